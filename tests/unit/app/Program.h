#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace aolib::test {

/// What a run of the program aolib left behind.
struct ProgramRun {
    int exitCode = -1;
    std::string out;
    std::string err;
};

/// A test that runs the program aolib, as a process, in an empty folder of its own below the build
/// folder. The folder stays when the test has failed.
class ProgramTest : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    /// Runs it in the test's folder. @param environment  added to, or replacing, ours.
    ProgramRun run(const std::vector<std::string>& arguments,
                   const std::map<std::string, std::string>& environment = {}) const;

    std::filesystem::path path(const std::string& name) const { return folder_ / name; }
    void write(const std::string& name, const std::string& bytes) const;
    std::string bytesOf(const std::string& name) const;
    /// Files and folders in the test's folder, sorted, recursively.
    std::vector<std::string> names() const;

private:
    std::filesystem::path folder_;
    std::filesystem::path logs_; ///< beside the folder, for what the program prints
};

} // namespace aolib::test
