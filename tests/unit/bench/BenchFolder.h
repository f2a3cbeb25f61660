#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace aolib::test {

/// An empty folder of the running test's own, below the build folder.
inline std::filesystem::path freshFolder() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    const std::filesystem::path folder = std::filesystem::path(AOLIB_TEST_FOLDER) /
                                         (std::string(info->test_suite_name()) + info->name());
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

} // namespace aolib::test
