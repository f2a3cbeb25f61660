// The calls of a host in any order, with frames of any view: each succeeds or says why not, what a
// frame computed lies in [0, 1], a view at rest comes to an end, and GL has nothing to complain of.
#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include <aolib/RayTracing.h>
#include <aolib/aolib.h>

#include "FuzzTarget.h"
#include "gl/Handle.h"
#include "host/HostFramebuffer.h"
#include "platform/GlContext.h"

namespace {

using namespace aolib;
using aolib::fuzz::Bytes;
using aolib::fuzz::require;

constexpr int kSkip = 77; ///< what ctest takes for "not tested"
constexpr int kMostCalls = 24;
constexpr std::array<glm::ivec2, 4> kSizes{{{24, 14}, {1, 1}, {130, 5}, {7, 31}}};

/// A context with a host's framebuffers in it, made once.
class Stage {
public:
    static const Stage& get() {
        static const Stage stage;
        return stage;
    }

    const gl::Functions& gl() const { return gl_; }
    ProcAddressLoader loader() const { return context_->loader(); }
    const host::HostFramebuffer& framebuffer(std::size_t i) const { return framebuffers_.at(i); }
    unsigned error() const { return getError_(); }

private:
    Stage() {
        auto context = createContext({.api = ContextRequest::Api::OsMesa});
        if (!context) {
            std::fprintf(stderr, "NOT TESTED: %s\n", context.status().message().c_str());
            std::exit(kSkip);
        }
        context_ = std::move(*context);
        gl_ = *gl::Functions::load(loader());
        getError_ = reinterpret_cast<PFNGLGETERRORPROC>(loader()("glGetError"));
        for (const glm::ivec2& size : kSizes) {
            framebuffers_.push_back(std::move(
                *host::HostFramebuffer::create(gl_, {.width = size.x, .height = size.y})));
        }
    }

    std::unique_ptr<GlContext> context_;
    gl::Functions gl_;
    PFNGLGETERRORPROC getError_ = nullptr;
    std::vector<host::HostFramebuffer> framebuffers_;
};

/// A host that lives as long as an input. Its instance mostly lives on, for shaders take long to
/// build: emptied, as a host would between two levels.
class Host {
public:
    explicit Host(Bytes& bytes) : stage_(Stage::get()), bytes_(bytes), ao_(instance()) {
        if (one(16)) {
            ao_.reset();
        }
        begin(options());
        setCamera();
        addMesh();
    }
    ~Host() {
        for (const MeshId mesh : meshes_) {
            note(ao_->removeMesh(mesh));
        }
        note(ao_->setSceneRenderer({}, {}, {}));
        ao_->setTexelTracer(nullptr);
        note(ao_->clear());
        (void)ao_->aoDrawEnd(0.0F, 0.0F, 0.0F); // of a frame that was begun
    }
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;

    void call();

private:
    float coordinate() { return static_cast<float>(bytes_.take<std::int8_t>()) * 0.25F; }
    /// Small numbers mostly; now and then any bits.
    glm::vec3 vector() {
        if (bytes_.take<std::uint8_t>() % 16 == 15) {
            return {bytes_.take<float>(), bytes_.take<float>(), bytes_.take<float>()};
        }
        return {coordinate(), coordinate(), coordinate()};
    }
    std::size_t below(std::size_t count) { return bytes_.take<std::uint8_t>() % count; }
    bool one(std::size_t in) { return below(in) == 0; }

    void note(const Status& status) const {
        require(status.ok() || !status.message().empty(), "a reason is given");
        require(stage_.error() == 0, "no GL error is raised");
    }

    static std::optional<AmbientOcclusion>& instance() {
        static std::optional<AmbientOcclusion> kept;
        return kept;
    }
    void begin(const Options& options) {
        if (ao_) {
            note(ao_->setOptions(options));
            return;
        }
        auto made = AmbientOcclusion::create(stage_.loader(), options);
        require(made.ok(), "such options are accepted");
        ao_.emplace(std::move(*made));
    }

    Options options();
    void setOptions() { note(ao_->setOptions(options())); }
    void setCamera();
    void addMesh();
    void editMesh();
    void drawDepth() const;
    void frame();
    void rest();
    void readVisibility();
    void readCubeMap();
    void setTracer() { ao_->setTexelTracer(one(2) ? nullptr : std::move(*createTexelTracer(1))); }
    void setRenderer();

    const Stage& stage_;
    Bytes& bytes_;
    std::optional<AmbientOcclusion>& ao_;
    std::vector<MeshId> meshes_;
    std::size_t framebuffer_ = 0;
    std::array<std::uint8_t, 4> depths_{255, 128, 200, 240}; ///< of the quarters of the picture
    glm::vec3 eye_{0.0F};
};

/// Anything that a software rasteriser computes in a moment.
Options Host::options() {
    Options o;
    o.frameBudget = one(4) ? 1.0F : 0.0F;
    o.estimator = one(3) ? static_cast<Estimator>(below(4)) : Estimator::LayeredIntervals;
    o.backbone = one(16) ? Backbone::ScreenSpace : Backbone::Cubemapped;
    if (o.backbone == Backbone::ScreenSpace && o.estimator == Estimator::RayTraced) {
        o.estimator = Estimator::Automatic;
    }
    o.radius = one(2) ? 0.0F : 0.1F * static_cast<float>(below(256));
    o.falloff = static_cast<Falloff>(below(3));
    o.contrast = static_cast<float>(below(5)) * 0.25F;
    o.horizonSplit = {.directions = 2, .steps = 2};
    o.layeredIntervals = {.slices = 1, .steps = 1 + static_cast<int>(below(3)), .layers = 2};
    o.rayTraced.rays = 4;
    o.cubeMaps.faceSize = 16 + static_cast<int>(below(5));
    o.cubeMaps.nearest = 1 + static_cast<int>(below(3));
    o.cubeMaps.place = !one(4);
    o.cubeMaps.projection = static_cast<ProjectionMethod>(below(2));
    o.cubeMaps.memoryBudget = one(4) ? 0.02F : 0.0F;
    o.cubeMaps.repair = !one(8);
    o.cubeMaps.outlines = one(8);
    o.blur.size = 1 + 2 * static_cast<int>(below(3));
    o.debugView = one(8) ? static_cast<DebugView>(below(8)) : DebugView::None;
    return o;
}

void Host::setCamera() {
    eye_ = vector();
    glm::mat4 view = glm::lookAt(eye_, vector(), glm::vec3(0, 1, 0));
    const float reach = 1.0F + std::abs(coordinate());
    glm::mat4 projection = one(4) ? glm::ortho(-reach, reach, -reach, reach, -reach, 64.0F)
                                  : glm::perspective(0.1F + 0.01F * static_cast<float>(below(256)),
                                                     1.5F, 0.05F, 10.0F * reach);
    if (one(4)) {
        projection[2][0] += coordinate() * 0.1F; // off-centre
    }
    if (one(16)) {
        view[static_cast<int>(below(4))][static_cast<int>(below(4))] = bytes_.take<float>();
    }
    if (one(16)) {
        projection[static_cast<int>(below(4))][static_cast<int>(below(4))] = bytes_.take<float>();
    }
    note(ao_->aoSetCamera(view, projection));
}

/// A quad, or a box of which a side may be missing.
void Host::addMesh() {
    const glm::vec3 from = vector();
    const glm::vec3 to = vector();
    std::vector<glm::vec3> positions;
    for (unsigned i = 0; i < 8; ++i) {
        positions.emplace_back((i & 1U) != 0 ? to.x : from.x, (i & 2U) != 0 ? to.y : from.y,
                               (i & 4U) != 0 ? to.z : from.z);
    }
    std::vector<std::uint32_t> indices{0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4,
                                       1, 5, 7, 1, 7, 3, 0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5};
    indices.resize(3 * (1 + below(12)));
    const glm::vec3 normal = vector();
    const std::vector<glm::vec3> normals(one(4) ? positions.size() : 0, normal);
    const Result<MeshId> mesh = ao_->addMesh({positions, normals, indices});
    note(mesh.status());
    if (mesh) {
        meshes_.push_back(*mesh);
    }
}

void Host::editMesh() {
    if (meshes_.empty()) {
        note(ao_->removeMesh(MeshId{77}));
        return;
    }
    const std::size_t which = below(meshes_.size());
    if (one(4)) {
        note(ao_->removeMesh(meshes_[which]));
        meshes_.erase(meshes_.begin() + static_cast<std::ptrdiff_t>(which));
        return;
    }
    glm::mat4 transform = glm::translate(glm::mat4(1.0F), vector());
    transform[0][0] = one(8) ? bytes_.take<float>() : 1.0F;
    note(ao_->moveMesh(meshes_[which], transform));
}

/// The depth that a host left: quarters, each at one depth.
void Host::drawDepth() const {
    const gl::Functions& gl = stage_.gl();
    const host::HostFramebuffer& framebuffer = stage_.framebuffer(framebuffer_);
    framebuffer.bind();
    const glm::ivec2 half(framebuffer.settings().width / 2, framebuffer.settings().height / 2);
    gl.Enable(GL_SCISSOR_TEST);
    for (int i = 0; i < 4; ++i) {
        gl.Scissor(i % 2 * half.x, i / 2 * half.y, half.x + 1, half.y + 1);
        const float depth = static_cast<float>(depths_.at(static_cast<std::size_t>(i))) / 255.0F;
        gl.ClearBufferfv(GL_DEPTH, 0, &depth);
    }
    gl.Disable(GL_SCISSOR_TEST);
}

void Host::frame() {
    drawDepth();
    note(ao_->aoDrawBegin());
    note(ao_->aoDrawEnd(eye_.x, eye_.y, eye_.z));
    const Statistics s = ao_->statistics();
    const glm::ivec2 size = kSizes.at(framebuffer_);
    require(s.pixelsRepaired <= static_cast<std::size_t>(size.x * size.y),
            "pixels are of the view");
}

/// Without a budget, a view is done when it has been seen twice.
void Host::rest() {
    for (int i = 0; i < 3; ++i) {
        drawDepth();
        note(ao_->aoDrawBegin());
        const Status status = ao_->aoDrawEnd(eye_.x, eye_.y, eye_.z);
        note(status);
        if (!status) {
            return;
        }
    }
    require(ao_->options().frameBudget > 0.0F || ao_->statistics().converged,
            "a view at rest comes to an end");
    readVisibility();
}

void Host::readVisibility() {
    const auto image = ao_->readVisibility();
    note(image.status());
    if (!image) {
        return;
    }
    for (const float w : image->visibility) {
        require(w == -1.0F || (w >= 0.0F && w <= 1.0F), "visibility lies in its range");
    }
}

void Host::readCubeMap() {
    const std::vector<CubeMapInfo> all = ao_->cubeMaps();
    if (all.empty()) {
        return;
    }
    const CubeMapInfo& info = all[below(all.size())];
    const auto image = ao_->readCubeMap(info.id);
    note(image.status());
    require(image.ok(), "a cube map that exists can be read");
    for (const float w : image->visibility) {
        require(w >= 0.0F && w <= 1.0F, "visibility lies in its range");
    }
    if (one(2)) {
        note(ao_->removeCubeMap(info.id));
    }
}

void Host::setRenderer() {
    const auto nothing = [](const FaceView&) {};
    const glm::vec3 min = vector();
    const glm::vec3 max = vector();
    note(ao_->setSceneRenderer(one(2) ? SceneRenderer() : nothing, min, max));
    note(ao_->aoSceneChanged(min, max));
}

void Host::call() {
    switch (below(14)) {
    case 0:
        setOptions();
        break;
    case 1:
        setCamera();
        break;
    case 2:
    case 3:
        addMesh();
        break;
    case 4:
        editMesh();
        break;
    case 5:
        note(ao_->addCubeMap(vector()).status());
        break;
    case 6:
        readCubeMap();
        break;
    case 7:
        framebuffer_ = below(kSizes.size());
        for (std::uint8_t& depth : depths_) {
            depth = bytes_.take<std::uint8_t>();
        }
        break;
    case 8:
        frame();
        readVisibility();
        break;
    case 9:
        setTracer();
        break;
    case 10:
        setRenderer();
        break;
    case 11:
        one(2) ? note(ao_->clear()) : note(ao_->aoDrawBegin());
        break;
    default:
        rest();
        break;
    }
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes(data, size);
    Host host(bytes);
    for (int calls = 0; calls < kMostCalls && !bytes.empty(); ++calls) {
        host.call();
    }
    return 0;
}
