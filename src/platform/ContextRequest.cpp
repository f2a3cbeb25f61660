#include "platform/ContextRequest.h"

namespace aolib {

const char* apiName(ContextRequest::Api api) {
    switch (api) {
    case ContextRequest::Api::Egl:
        return "EGL";
    case ContextRequest::Api::OsMesa:
        return "OSMesa";
    case ContextRequest::Api::Glfw:
        return "GLFW";
    }
    return "unknown";
}

std::string wantedContext(const ContextRequest& request) {
    const bool core = request.profile == ContextRequest::Profile::Core;
    return "OpenGL " + std::to_string(request.major) + "." + std::to_string(request.minor) +
           (core ? " core context" : " compatibility context");
}

} // namespace aolib
