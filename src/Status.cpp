#include <aolib/Status.h>

namespace aolib {

const char* statusName(StatusCode code) {
    switch (code) {
    case StatusCode::Ok:
        return "Ok";
    case StatusCode::InvalidCallOrder:
        return "InvalidCallOrder";
    case StatusCode::InvalidPosition:
        return "InvalidPosition";
    case StatusCode::InvalidNormal:
        return "InvalidNormal";
    case StatusCode::InvalidIndex:
        return "InvalidIndex";
    case StatusCode::IncompletePrimitive:
        return "IncompletePrimitive";
    case StatusCode::EmptyMesh:
        return "EmptyMesh";
    case StatusCode::InvalidPrimitive:
        return "InvalidPrimitive";
    case StatusCode::UnknownMesh:
        return "UnknownMesh";
    case StatusCode::UnknownCubeMap:
        return "UnknownCubeMap";
    case StatusCode::NoScene:
        return "NoScene";
    case StatusCode::NoCamera:
        return "NoCamera";
    case StatusCode::InvalidCamera:
        return "InvalidCamera";
    case StatusCode::InvalidOption:
        return "InvalidOption";
    case StatusCode::InvalidFramebuffer:
        return "InvalidFramebuffer";
    case StatusCode::MissingCapability:
        return "MissingCapability";
    case StatusCode::NoContext:
        return "NoContext";
    case StatusCode::ShaderError:
        return "ShaderError";
    case StatusCode::OutOfMemory:
        return "OutOfMemory";
    }
    return "unknown";
}

} // namespace aolib
