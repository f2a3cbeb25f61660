#include "platform/OsMesaContext.h"

#include <GL/osmesa.h>
#include <dlfcn.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace aolib {
namespace {

/// The functions of libOSMesa, or the reason why there are none.
struct OsMesaLibrary {
    decltype(&OSMesaCreateContextAttribs) createContextAttribs = nullptr;
    decltype(&OSMesaDestroyContext) destroyContext = nullptr;
    decltype(&OSMesaMakeCurrent) makeCurrent = nullptr;
    decltype(&OSMesaGetCurrentContext) getCurrentContext = nullptr;
    decltype(&OSMesaGetProcAddress) getProcAddress = nullptr;
    std::string problem;
};

OsMesaLibrary loadLibrary() {
    OsMesaLibrary library;
    void* handle = nullptr;
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
        // Local: its glDrawElements must never answer for libGL's.
        handle = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
        if (handle != nullptr) {
            break;
        }
        const char* reason = dlerror();
        library.problem += std::string(" ") + (reason == nullptr ? name : reason) + ".";
    }
    if (handle == nullptr) {
        return library;
    }
    library.problem.clear();
    const auto look = [&](auto& function, const char* name) {
        void* address = dlsym(handle, name);
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(address);
        if (address == nullptr) {
            library.problem += std::string(" The library has no ") + name + ".";
        }
    };
    look(library.createContextAttribs, "OSMesaCreateContextAttribs");
    look(library.destroyContext, "OSMesaDestroyContext");
    look(library.makeCurrent, "OSMesaMakeCurrent");
    look(library.getCurrentContext, "OSMesaGetCurrentContext");
    look(library.getProcAddress, "OSMesaGetProcAddress");
    return library;
}

const OsMesaLibrary& osMesa() {
    static const OsMesaLibrary library = loadLibrary();
    return library;
}

void* osMesaLoader(const char* name) {
    return reinterpret_cast<void*>(osMesa().getProcAddress(name));
}

void releaseOsMesa() {
    osMesa().makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
}

class OsMesaContext final : public GlContext {
public:
    OsMesaContext(::OSMesaContext context, int width, int height)
        : context_(context), width_(width), height_(height),
          pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}
    ~OsMesaContext() override;

    LoaderFunction loader() const override { return osMesaLoader; }
    ContextRequest::Api api() const override { return ContextRequest::Api::OsMesa; }
    std::string platformName() const override { return "OSMesa"; }

protected:
    AoStatus bind() override;
    bool isBound() const override { return osMesa().getCurrentContext() == context_; }
    ReleaseFunction releaseFunction() const override { return releaseOsMesa; }

private:
    ::OSMesaContext context_;
    int width_;
    int height_;
    std::vector<std::uint32_t> pixels_; ///< the default framebuffer's colours, RGBA, 8 bits each
};

OsMesaContext::~OsMesaContext() {
    doneCurrent();
    osMesa().destroyContext(context_);
}

AoStatus OsMesaContext::bind() {
    if (osMesa().makeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, width_, height_) == 0) {
        return {StatusCode::NoContext, "OSMesa: OSMesaMakeCurrent failed for " +
                                           std::to_string(width_) + " x " +
                                           std::to_string(height_) + " pixels."};
    }
    return {};
}

} // namespace

bool osMesaBuilt() {
    return true;
}

Result<std::unique_ptr<GlContext>> createOsMesaContext(const ContextRequest& request) {
    if (!osMesa().problem.empty()) {
        return AoStatus(StatusCode::MissingCapability,
                        "OSMesa: its library cannot be used." + osMesa().problem);
    }
    if (request.samples > 0) {
        return AoStatus(StatusCode::InvalidOption, "OSMesa: its framebuffer has no samples, but " +
                                                       std::to_string(request.samples) +
                                                       " were asked for.");
    }
    const bool core = request.profile == ContextRequest::Profile::Core;
    const std::array<int, 15> attributes{OSMESA_FORMAT,
                                         OSMESA_RGBA,
                                         OSMESA_DEPTH_BITS,
                                         24,
                                         OSMESA_STENCIL_BITS,
                                         8,
                                         OSMESA_PROFILE,
                                         core ? OSMESA_CORE_PROFILE : OSMESA_COMPAT_PROFILE,
                                         OSMESA_CONTEXT_MAJOR_VERSION,
                                         request.major,
                                         OSMESA_CONTEXT_MINOR_VERSION,
                                         request.minor,
                                         0};
    const ::OSMesaContext context = osMesa().createContextAttribs(attributes.data(), nullptr);
    if (context == nullptr) {
        return AoStatus(StatusCode::NoContext, "OSMesa: no " + wantedContext(request) + ".");
    }
    return std::unique_ptr<GlContext>(
        std::make_unique<OsMesaContext>(context, request.width, request.height));
}

} // namespace aolib
