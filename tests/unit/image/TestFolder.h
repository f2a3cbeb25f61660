#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace aolib::test {

/// A test with an empty folder of its own below the build folder, so that tests can run at once.
/// It stays when the test has failed.
class InTestFolder : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    std::filesystem::path path(const std::string& name) const { return folder_ / name; }
    /// Writes a file byte by byte, past the code under test.
    std::filesystem::path fileOf(const std::string& name, const std::string& bytes) const;
    std::string bytesOf(const std::filesystem::path& file) const;
    /// The names of all files in the folder, sorted.
    std::vector<std::string> names() const;

private:
    std::filesystem::path folder_;
};

} // namespace aolib::test
