#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <aolib/RayTracing.h>
#include <aolib/aolib.h>

#include "FuzzStage.h"
#include "FuzzTarget.h"

namespace aolib::fuzz {

/// A host that lives as long as an input. Its instance mostly lives on, for shaders take long to
/// build: emptied, as a host would between two levels.
class FuzzHost {
public:
    explicit FuzzHost(Bytes& bytes) : stage_(FuzzStage::get()), bytes_(bytes), ao_(instance()) {
        if (one(16)) {
            ao_.reset();
        }
        begin(options());
        setCamera();
        addMesh();
    }
    ~FuzzHost() {
        for (const MeshId mesh : meshes_) {
            note(ao_->removeMesh(mesh));
        }
        note(ao_->setSceneRenderer({}, {}, {}));
        ao_->setTexelTracer(nullptr);
        note(ao_->clear());
        (void)ao_->aoDrawEnd(0.0F, 0.0F, 0.0F); // of a frame that was begun
    }
    FuzzHost(const FuzzHost&) = delete;
    FuzzHost& operator=(const FuzzHost&) = delete;

    /// Any call.
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

    void note(const AoStatus& status) const {
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
    void changeViews();
    void prepare();
    void readVisibility();
    void readCubeMap();
    void setTracer() { ao_->setTexelTracer(one(2) ? nullptr : std::move(*createTexelTracer(1))); }
    void setRenderer();

    const FuzzStage& stage_;
    Bytes& bytes_;
    std::optional<AmbientOcclusion>& ao_;
    std::vector<MeshId> meshes_;
    std::size_t framebuffer_ = 0;
    std::array<std::uint8_t, 4> depths_{255, 128, 200, 240}; ///< of the quarters of the picture
    glm::vec3 eye_{0.0F};
};

} // namespace aolib::fuzz
