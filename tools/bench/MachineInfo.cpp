#include "bench/MachineInfo.h"

#include <array>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <memory>
#include <thread>

namespace aolib::bench {

namespace {

std::string cpuName() {
    std::ifstream file("/proc/cpuinfo");
    std::string line;
    while (std::getline(file, line)) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    return "";
}

/// For a shell: quoted so that nothing in it means anything.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return result + "'";
}

std::string commitOf(const std::string& folder) {
    const std::string command = "git -C " + quoted(folder) +
                                " describe --always --dirty --abbrev=12 --exclude '*' 2>/dev/null";
    struct Close {
        void operator()(std::FILE* pipe) const { pclose(pipe); }
    };
    const std::unique_ptr<std::FILE, Close> pipe(popen(command.c_str(), "r"));
    std::array<char, 128> line{};
    if (!pipe || std::fgets(line.data(), static_cast<int>(line.size()), pipe.get()) == nullptr) {
        return "";
    }
    std::string commit(line.data());
    while (!commit.empty() && commit.back() == '\n') {
        commit.pop_back();
    }
    return commit;
}

std::string now() {
    const std::time_t time = std::time(nullptr);
    std::tm parts{};
    if (gmtime_r(&time, &parts) == nullptr) {
        return "";
    }
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text.data();
}

} // namespace

MachineInfo describeMachine(const std::string& driver) {
    return {cpuName(), static_cast<int>(std::thread::hardware_concurrency()), driver,
            commitOf(AOLIB_SOURCE_DIR), now()};
}

} // namespace aolib::bench
