#include "Program.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace aolib::test {

namespace fs = std::filesystem;

namespace {

std::string readAll(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void redirect(int descriptor, const fs::path& file) {
    const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(opened, descriptor);
    close(opened);
}

/// In the child: becomes the program, or exits with 127.
[[noreturn]] void become(std::vector<std::string> words, const fs::path& folder,
                         const fs::path& logs,
                         const std::map<std::string, std::string>& environment) {
    redirect(STDOUT_FILENO, logs / "out");
    redirect(STDERR_FILENO, logs / "err");
    for (const auto& [name, value] : environment) {
        setenv(name.c_str(), value.c_str(), 1);
    }
    std::vector<char*> argv;
    for (std::string& word : words) {
        argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    if (chdir(folder.c_str()) == 0) {
        execv(argv[0], argv.data());
    }
    _exit(127);
}

} // namespace

void ProgramTest::SetUp() {
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(info->test_suite_name()) + "." + info->name();
    std::replace(name.begin(), name.end(), '/', '.');
    const fs::path base = fs::path(AOLIB_TEST_FOLDER) / name;
    fs::remove_all(base);
    folder_ = base / "work";
    logs_ = base / "logs";
    fs::create_directories(folder_);
    fs::create_directories(logs_);
}

void ProgramTest::TearDown() {
    if (!HasFailure()) {
        fs::remove_all(folder_.parent_path());
    }
}

ProgramRun ProgramTest::run(const std::vector<std::string>& arguments,
                            const std::map<std::string, std::string>& environment) const {
    std::vector<std::string> words{AOLIB_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    ProgramRun result;
    const pid_t child = fork();
    if (child == 0) {
        become(std::move(words), folder_, logs_, environment);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child) {
        ADD_FAILURE() << "the program could not be started";
        return result;
    }
    result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    result.out = readAll(logs_ / "out");
    result.err = readAll(logs_ / "err");
    return result;
}

void ProgramTest::write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
}

std::string ProgramTest::bytesOf(const std::string& name) const {
    EXPECT_TRUE(fs::is_regular_file(path(name))) << name << " is missing";
    return readAll(path(name));
}

std::vector<std::string> ProgramTest::names() const {
    std::vector<std::string> result;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_)) {
        result.push_back(fs::relative(entry.path(), folder_).string());
    }
    std::sort(result.begin(), result.end());
    return result;
}

} // namespace aolib::test
