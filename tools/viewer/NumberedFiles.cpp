#include "viewer/NumberedFiles.h"

#include <cstdio>
#include <system_error>

namespace aolib::viewer {

std::filesystem::path nextNumberedFile(const std::filesystem::path& folder,
                                       const std::string& ending) {
    std::error_code ignored;
    for (int number = 1;; ++number) {
        char name[40];
        std::snprintf(name, sizeof name, "aolib-view-%03d", number);
        std::filesystem::path file = (folder / (name + ending)).lexically_normal();
        if (!std::filesystem::exists(file, ignored)) {
            return file;
        }
    }
}

} // namespace aolib::viewer
