#pragma once

#include <memory>
#include <string>

#include <sys/types.h>

namespace aolib::test {

/// An X server of its own that shows nothing to anybody (Xvfb), for as long as it lives.
class Display {
public:
    /// Null, with the reason, where there is no Xvfb.
    static std::unique_ptr<Display> start(std::string& problem);
    ~Display();
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    /// For the environment variable DISPLAY: ":3".
    const std::string& name() const { return name_; }

private:
    Display(pid_t server, std::string name) : server_(server), name_(std::move(name)) {}

    pid_t server_;
    std::string name_;
};

} // namespace aolib::test
