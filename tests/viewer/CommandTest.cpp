#include <gtest/gtest.h>

#include <set>
#include <string>

#include "viewer/Command.h"

namespace aolib::viewer {
namespace {

TEST(CommandTest, EachKeyGivesOneCommandAndEachCommandHasAKey) {
    std::set<std::pair<int, bool>> keys;
    std::set<Command> commands;
    for (const KeyBinding& binding : keyBindings()) {
        EXPECT_TRUE(keys.insert({binding.key, binding.control}).second) << binding.name;
        EXPECT_TRUE(commands.insert(binding.command).second) << binding.name;
        EXPECT_EQ(bindingOf({binding.key, binding.control, false}), &binding);
        EXPECT_EQ(&bindingOf(binding.command), &binding);
    }
    EXPECT_EQ(commands.size(), static_cast<std::size_t>(Command::Quit) + 1);
}

TEST(CommandTest, KeysOfAWalkAreNotCommands) {
    for (const char key : std::string("WASDQE")) {
        EXPECT_EQ(bindingOf({key, false, false}), nullptr) << key;
    }
}

} // namespace
} // namespace aolib::viewer
