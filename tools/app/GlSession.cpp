#include "app/GlSession.h"

#include <iostream>
#include <utility>

#include <CLI/CLI.hpp>

#include "app/NumberFlags.h"

namespace aolib::app {

namespace {

#ifdef NDEBUG
constexpr bool kDebugBuild = false;
#else
constexpr bool kDebugBuild = true;
#endif

} // namespace

void GlFlags::attach(CLI::App& command) {
    using Api = ContextRequest::Api;
    using Profile = ContextRequest::Profile;
    const char* const group = "OpenGL";
    addChoice<Api>(
        command, "--context", {{"egl", Api::Egl}, {"osmesa", Api::OsMesa}, {"glfw", Api::Glfw}},
        [this](Api value) { api = value; },
        "where the OpenGL context comes from; without it EGL, else OSMesa")
        ->group(group);
    addChoice<Profile>(
        command, "--profile", {{"core", Profile::Core}, {"compatibility", Profile::Compatibility}},
        [this](Profile value) { profile = value; }, "OpenGL profile")
        ->default_str("core")
        ->group(group);
    command
        .add_flag("--gl-debug", strict,
                  "take any message of the driver above notification as a failure (exit code 3)")
        ->group(group);
}

Result<GlSession, Failure> GlSession::open(const GlFlags& flags) {
    ContextRequest request;
    request.profile = flags.profile;
    if (flags.api) {
        request.api = *flags.api;
        return open(request, flags.strict);
    }
    request.debug = flags.strict || kDebugBuild;
    return adopt(createOffscreenContext(request), request.debug, flags.strict);
}

Result<GlSession, Failure> GlSession::open(ContextRequest request, bool strict) {
    request.debug = strict || kDebugBuild;
    return adopt(createContext(request), request.debug, strict);
}

Result<GlSession, Failure> GlSession::adopt(Result<std::unique_ptr<GlContext>> context, bool debug,
                                            bool strict) {
    if (!context) {
        return graphicsFailure("no OpenGL context: " + context.status().message());
    }
    GlSession session;
    session.context_ = std::move(*context);
    session.strict_ = strict;
    if (debug) {
        Result<std::unique_ptr<DebugLog>> log = DebugLog::install(session.loader());
        if (log) {
            session.log_ = std::move(*log);
        } else if (strict) {
            std::cerr << "aolib: --gl-debug: " << log.status().message()
                      << "; only failures of aolib itself will show\n";
        }
    }
    Result<gl::Functions> gl = gl::Functions::load(session.loader());
    if (!gl) {
        return graphicsFailure(session.describe() + ": " + gl.status().message());
    }
    session.gl_ = std::make_unique<gl::Functions>(*gl);
    return session;
}

MaybeFailure GlSession::reviewMessages() const {
    if (!log_ || log_->empty()) {
        return std::nullopt;
    }
    const std::string summary = "the OpenGL driver (" + describe() + ") complained " +
                                std::to_string(log_->messages().size()) + " times:\n" +
                                log_->text();
    if (strict_) {
        return graphicsFailure(summary);
    }
    std::cerr << "aolib: warning: " << summary << '\n';
    return std::nullopt;
}

} // namespace aolib::app
