#include "FuzzHost.h"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace aolib::fuzz {

/// Anything that a software rasteriser computes in a moment.
Options FuzzHost::options() {
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
    o.cubeMaps.refineStaticViews = !one(8);
    o.cubeMaps.outlines = one(8);
    o.blur.size = 1 + 2 * static_cast<int>(below(3));
    o.debugView = one(8) ? static_cast<DebugView>(below(8)) : DebugView::Off;
    return o;
}

void FuzzHost::setCamera() {
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
void FuzzHost::addMesh() {
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

void FuzzHost::editMesh() {
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
void FuzzHost::drawDepth() const {
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

void FuzzHost::frame() {
    drawDepth();
    note(ao_->aoDrawBegin());
    const ViewId view{static_cast<std::uint32_t>(one(3) ? below(3) : 0)};
    note(ao_->aoDrawEnd(eye_.x, eye_.y, eye_.z, view));
    const Statistics s = ao_->statistics(view);
    require(s.computed >= 0.0F && s.computed <= 1.0F, "shares lie in their range");
    const glm::ivec2 size = kFuzzSizes.at(framebuffer_);
    require(s.pixelsRefined <= static_cast<std::size_t>(size.x * size.y), "pixels are of the view");
}

/// Without a budget, a view is done when it has been seen twice.
void FuzzHost::rest() {
    for (int i = 0; i < 3; ++i) {
        drawDepth();
        note(ao_->aoDrawBegin());
        const AoStatus status = ao_->aoDrawEnd(eye_.x, eye_.y, eye_.z);
        note(status);
        if (!status) {
            return;
        }
    }
    require(ao_->options().frameBudget > 0.0F || ao_->statistics().converged,
            "a view at rest comes to an end");
    readVisibility();
}

void FuzzHost::changeViews() {
    const ViewId view{static_cast<std::uint32_t>(below(3))};
    note(ao_->readVisibility(view).status());
    note(ao_->removeView(view));
    require(!ao_->statistics(view).converged, "a view that is gone has nothing to show");
}

void FuzzHost::prepare() {
    float before = 0.0F;
    std::size_t calls = 1 + below(8);
    const auto callback = [&](float progress) {
        require(progress >= before && progress <= 1.0F, "progress only grows");
        before = progress;
        return --calls > 0;
    };
    note(ao_->prepare(callback, std::array{vector()}));
}

void FuzzHost::readVisibility() {
    const auto image = ao_->readVisibility();
    note(image.status());
    if (!image) {
        return;
    }
    for (const float w : image->visibility) {
        require(w == -1.0F || (w >= 0.0F && w <= 1.0F), "visibility lies in its range");
    }
}

void FuzzHost::readCubeMap() {
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

void FuzzHost::setRenderer() {
    const auto nothing = [](const FaceView&) {};
    const glm::vec3 min = vector();
    const glm::vec3 max = vector();
    note(ao_->setSceneRenderer(one(2) ? SceneRenderer() : nothing, min, max));
    note(ao_->aoSceneChanged(min, max));
}

void FuzzHost::call() {
    switch (below(16)) {
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
        framebuffer_ = below(kFuzzSizes.size());
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
    case 12:
        changeViews();
        break;
    case 13:
        prepare();
        break;
    default:
        rest();
        break;
    }
}

} // namespace aolib::fuzz
