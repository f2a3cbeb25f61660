#include "TestFolder.h"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace aolib::test {

namespace fs = std::filesystem;

void InTestFolder::SetUp() {
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
        fs::path(AOLIB_TEST_FOLDER) / (std::string(info->test_suite_name()) + "." + info->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
}

void InTestFolder::TearDown() {
    if (!HasFailure()) {
        fs::remove_all(folder_);
    }
}

fs::path InTestFolder::fileOf(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
}

std::string InTestFolder::bytesOf(const fs::path& file) const {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<std::string> InTestFolder::names() const {
    std::vector<std::string> result;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
        result.push_back(entry.path().filename().string());
    }
    std::ranges::sort(result);
    return result;
}

} // namespace aolib::test
