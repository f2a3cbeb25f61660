#pragma once

#include <functional>
#include <future>
#include <optional>
#include <string>

#include "app/View.h"

namespace aolib::viewer {

/// Opens scenes while the window goes on. Threads: all functions from one.
class SceneLoader {
public:
    /// @param wake  called from another thread when something was opened.
    explicit SceneLoader(std::function<void()> wake) : wake_(std::move(wake)) {}

    /// A generated scene's name, a model or a case file (.json). Not while it is busy().
    void open(const std::string& nameOrPath);
    bool busy() const { return opening_.valid(); }
    /// What was opened, once.
    std::optional<Result<app::View, app::Failure>> take();

private:
    std::function<void()> wake_;
    std::future<Result<app::View, app::Failure>> opening_;
};

} // namespace aolib::viewer
