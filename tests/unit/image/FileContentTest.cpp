#include "image/FileContent.h"

#include <thread>

#include "TestFolder.h"

namespace aolib {
namespace {

class FileContentTest : public test::InTestFolder {};

TEST_F(FileContentTest, RoundTrip) {
    const std::vector<std::uint8_t> content{0, 10, 13, 26, 255};
    ASSERT_FALSE(writeFile(path("a"), content));
    EXPECT_EQ(bytesOf(path("a")), std::string("\0\n\r\x1a\xff", 5));
    EXPECT_EQ(*readFile(path("a")), content);
    EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

TEST_F(FileContentTest, ReplacesAndMayBeEmpty) {
    fileOf("a", "much longer than what comes");
    ASSERT_FALSE(writeFile(path("a"), {}));
    EXPECT_EQ(readFile(path("a"))->size(), 0U);
}

TEST_F(FileContentTest, ErrorsNameFileAndReason) {
    const auto missing = readFile(path("missing"));
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().message,
              path("missing").string() + ": cannot be opened: No such file or directory");
    std::filesystem::create_directory(path("folder"));
    EXPECT_EQ(readFile(path("folder")).error().message,
              path("folder").string() + ": cannot be read: it is a folder");
    const ImageOutcome nowhere = writeFile(path("no/such/folder"), {});
    ASSERT_TRUE(nowhere);
    EXPECT_EQ(nowhere->message,
              path("no/such/folder").string() + ": cannot be written: No such file or directory");
}

/// The last step fails, a folder is in the way: the temporary file must go.
TEST_F(FileContentTest, FailureLeavesNothingBehind) {
    std::filesystem::create_directory(path("folder"));
    const ImageOutcome outcome = writeFile(path("folder"), std::vector<std::uint8_t>{1, 2, 3});
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->message.find(path("folder").string() + ": cannot be replaced: "), 0U);
    EXPECT_EQ(names(), std::vector<std::string>{"folder"});
}

/// Whoever reads while others write sees one of the contents, whole.
TEST_F(FileContentTest, WritersDoNotMix) {
    const std::vector<std::uint8_t> ones(1U << 16U, 1);
    const std::vector<std::uint8_t> twos(1U << 15U, 2);
    ASSERT_FALSE(writeFile(path("a"), ones));
    const auto write = [&](const std::vector<std::uint8_t>& content) {
        for (int i = 0; i < 400; ++i) {
            EXPECT_FALSE(writeFile(path("a"), content));
        }
    };
    {
        const std::jthread first([&] { write(ones); });
        const std::jthread second([&] { write(twos); });
    }
    const auto content = readFile(path("a"));
    ASSERT_TRUE(content);
    EXPECT_TRUE(*content == ones || *content == twos);
    EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

} // namespace
} // namespace aolib
