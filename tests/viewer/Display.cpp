#include "Display.h"

#include <array>
#include <csignal>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace aolib::test {

namespace {

/// In the child: becomes the server, which writes the number of a free display into the pipe.
[[noreturn]] void become(int pipe) {
    const std::string descriptor = std::to_string(pipe);
    const int nothing = open("/dev/null", O_WRONLY);
    dup2(nothing, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
    execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", "1280x1200x24",
           "-nolisten", "tcp", static_cast<char*>(nullptr));
    _exit(127);
}

std::string readLine(int pipe) {
    std::string line;
    char letter = 0;
    while (read(pipe, &letter, 1) == 1 && letter != '\n') {
        line += letter;
    }
    return line;
}

} // namespace

std::unique_ptr<Display> Display::start(std::string& problem) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) {
        problem = "there is no pipe to be had";
        return nullptr;
    }
    const pid_t server = fork();
    if (server == 0) {
        close(ends[0]);
        become(ends[1]);
    }
    close(ends[1]);
    const std::string number = readLine(ends[0]); // empty when the server has ended
    close(ends[0]);
    if (server < 0 || number.empty()) {
        if (server > 0) {
            waitpid(server, nullptr, 0);
        }
        problem = "Xvfb does not start; scripts/setup installs it (package xvfb)";
        return nullptr;
    }
    return std::unique_ptr<Display>(new Display(server, ":" + number));
}

Display::~Display() {
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
}

} // namespace aolib::test
