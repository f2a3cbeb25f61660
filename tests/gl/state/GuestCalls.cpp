#include <array>
#include <limits>
#include <utility>

#include <aolib/RayTracing.h>

#include "Guest.h"
#include "HostObjects.h"
#include "SmallScene.h"

namespace aolib {

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t kMaxCubeMaps = 4;
constexpr float kTightBudget = 0.02F; ///< MiB: two cube maps or three

} // namespace

/// The public calls, each with what it must answer.
struct GuestCalls {
    Guest& guest;
    Dice& dice;
    const Guest::Situation& situation;
    std::string fault;

    AmbientOcclusion& ao() { return *guest.ao_; }
    AmbientOcclusion& empty() { return *guest.empty_; }

    void expect(StatusCode wanted, const AoStatus& status) {
        if (status.code() != wanted) {
            fault.append(statusName(status.code())).append(" (").append(status.message());
            fault.append(") in place of ").append(statusName(wanted)).append("; ");
        }
    }
    template <typename T>
    void expect(StatusCode wanted, const Result<T>& result) {
        expect(wanted, result.status());
    }
    void end(const glm::vec3& at = Guest::eye()) {
        const AoStatus status = ao().aoDrawEnd(at.x, at.y, at.z);
        expect(situation.frame, status);
        guest.hadFrame_ = guest.hadFrame_ || status.ok();
    }
    void frame() {
        expect(StatusCode::Ok, ao().aoDrawBegin());
        end();
    }
    glm::vec3 somewhere() {
        const auto coordinate = [&] { return static_cast<float>(dice.between(-40, 40)) * 0.1F; };
        return {coordinate(), coordinate() + 4.0F, coordinate()};
    }
    CubeMapId someCubeMap() {
        const std::vector<CubeMapInfo> infos = ao().cubeMaps();
        return infos.empty() ? CubeMapId{0xFFFFFF} : infos[dice.below(infos.size())].id;
    }
    void change(Options options) { expect(StatusCode::Ok, ao().setOptions(options)); }

    // ---- One function per call ------------------------------------------------------------------

    void create() {
        Options options = smallOptions();
        options.backbone = dice.chance(0.5) ? Backbone::Cubemapped : Backbone::ScreenSpace;
        expect(StatusCode::Ok, AmbientOcclusion::create(guest.loader_, options));
    }
    void createRefused() {
        Options options;
        options.contrast = 2.0F;
        expect(StatusCode::InvalidOption, AmbientOcclusion::create(guest.loader_, options));
        expect(StatusCode::NoContext, AmbientOcclusion::create({}));
        const auto holed = [this](const char* name) -> void* {
            return std::string_view(name) == "glDrawArrays" ? nullptr : guest.loader_(name);
        };
        expect(StatusCode::MissingCapability, AmbientOcclusion::create(holed));
    }
    void move() {
        AmbientOcclusion elsewhere(std::move(*guest.ao_));
        guest.ao_.emplace(std::move(elsewhere));
    }
    void estimate() {
        Options options = ao().options();
        options.horizonSplit.directions = dice.between(1, 2);
        options.horizonSplit.steps = dice.between(1, 4);
        options.layeredIntervals.slices = dice.between(1, 2);
        options.layeredIntervals.layers = dice.between(1, 3);
        options.radius = static_cast<float>(dice.between(1, 3));
        options.falloff = static_cast<Falloff>(dice.between(0, 2));
        options.cubeMaps.faceSize = dice.chance(0.5) ? 16 : 20;
        options.cubeMaps.halfResolution = dice.chance(0.5);
        change(options);
    }
    void exchangeEstimator() {
        Options options = ao().options();
        options.estimator = options.estimator == Estimator::HorizonSplit
                                ? Estimator::LayeredIntervals
                                : Estimator::HorizonSplit;
        change(options);
        frame();
    }
    void pace() {
        Options options = ao().options();
        options.frameBudget = dice.chance(0.5) ? 0.0F : 1.0F;
        options.cubeMaps.refineStaticViews = dice.chance(0.7);
        options.cubeMaps.projection =
            dice.chance(0.5) ? ProjectionMethod::SinglePass : ProjectionMethod::PingPong;
        options.cubeMaps.memoryBudget = dice.chance(0.5) ? 512.0F : kTightBudget;
        change(options);
    }
    /// Frames of a view that does not move, or of textures: layered intervals, or rays.
    void rest() {
        Options options = ao().options();
        const Options before = options;
        options.estimator = dice.chance(0.7) ? Estimator::LayeredIntervals : Estimator::RayTraced;
        options.frameBudget = 0.0F;
        options.cubeMaps.refineStaticViews = true;
        if (options.estimator == Estimator::RayTraced) {
            ao().setTexelTracer(std::move(*createTexelTracer(1)));
        }
        change(options);
        if (ao().cubeMaps().empty()) {
            addCubeMap();
        }
        for (int i = dice.between(2, 4); i > 0; --i) {
            situation.frame == StatusCode::Ok ? frame() : apply();
        }
        guest.pixelsAtRest_ += ao().statistics().pixelsRefined;
        if (dice.chance(0.5)) {
            ao().setTexelTracer({});
        }
        change(before);
    }
    void appearance() {
        Options options = ao().options();
        options.contrast = static_cast<float>(dice.between(0, 4)) * 0.25F;
        options.cubeMaps.outlines = dice.chance(0.5);
        options.debugGroups = dice.chance(0.8);
        options.cubeMaps.place = dice.chance(0.5);
        options.cubeMaps.coverage = dice.chance(0.5) ? 0.75F : 1.0F;
        options.cubeMaps.nearest = dice.between(1, 3);
        options.blur = {.enabled = dice.chance(0.7), .size = 1 + 2 * dice.between(0, 3)};
        options.debugView = dice.chance(0.5)
                                ? DebugView::Off
                                : kDebugViewChoices[dice.below(kDebugViewChoices.size())].value;
        change(options);
    }
    void optionsRefused() {
        Options options = ao().options();
        options.cubeMaps.faceSize = 1;
        expect(StatusCode::InvalidOption, ao().setOptions(options));
    }
    void exchangeBackbone() {
        Options options = ao().options();
        options.backbone = Backbone::ScreenSpace;
        change(options);
        guest.hadFrame_ = false;
        frame();
        options.backbone = Backbone::Cubemapped;
        change(options);
        guest.hadFrame_ = false;
    }
    void addCubeMap() {
        if (ao().cubeMaps().size() >= kMaxCubeMaps) {
            expect(StatusCode::Ok, ao().removeCubeMap(someCubeMap()));
        }
        const auto added = ao().addCubeMap(somewhere());
        const bool tight = ao().options().cubeMaps.memoryBudget == kTightBudget;
        expect(!added && tight ? StatusCode::OutOfMemory : StatusCode::Ok, added);
    }
    void addCubeMapRefused() {
        expect(StatusCode::InvalidPosition, ao().addCubeMap({0, kNaN, 0}));
        expect(StatusCode::NoScene, empty().addCubeMap({0, 1, 0}));
    }
    void removeCubeMap() {
        const CubeMapId id = someCubeMap();
        const bool known = !ao().cubeMaps().empty();
        expect(known ? StatusCode::Ok : StatusCode::UnknownCubeMap, ao().removeCubeMap(id));
        expect(StatusCode::UnknownCubeMap, ao().removeCubeMap(CubeMapId{0xFFFFFF}));
    }
    void clear() { expect(StatusCode::Ok, ao().clear()); }
    void frameTwiceBegun() {
        expect(StatusCode::Ok, ao().aoDrawBegin());
        expect(StatusCode::InvalidCallOrder, ao().aoDrawBegin());
        end();
    }
    void frameNotBegun() {
        expect(StatusCode::InvalidCallOrder, ao().aoDrawEnd(0, 0, 0));
        expect(StatusCode::Ok, ao().aoDrawBegin());
        expect(StatusCode::InvalidCamera, ao().aoDrawEnd(kNaN, 0, 0));
    }
    void frameWithoutCamera() {
        glm::mat4 broken(1.0F);
        broken[0][0] = kNaN;
        expect(StatusCode::InvalidCamera, ao().aoSetCamera(broken, broken));
        expect(StatusCode::Ok, empty().aoDrawBegin());
        expect(situation.compatibility ? StatusCode::InvalidCamera : StatusCode::NoCamera,
               empty().aoDrawEnd(1000, 0, 0));
    }
    HostTextures textures() {
        const auto some = [&](std::size_t i) {
            return TextureName{dice.chance(0.5) ? guest.textures_[i].name() : 0U};
        };
        return {.size = {HostObjects::kWidth, HostObjects::kHeight},
                .depth = TextureName{guest.textures_[0].name()},
                .normal = some(2),
                .colour = some(1)};
    }
    void apply() {
        const auto applied = ao().aoApply(textures(), Guest::eye());
        expect(situation.apply, applied);
        guest.hadFrame_ = guest.hadFrame_ || applied.ok();
    }
    void applyRefused() {
        HostTextures broken = textures();
        broken.depth = TextureName{dice.chance(0.5) ? guest.textures_[1].name() : 54321U};
        expect(StatusCode::InvalidFramebuffer, ao().aoApply(broken, Guest::eye()));
        broken = textures();
        broken.size.y = -1;
        expect(StatusCode::InvalidFramebuffer, ao().aoApply(broken, Guest::eye()));
        expect(StatusCode::InvalidCamera, ao().aoApply(textures(), {0, kNaN, 0}));
    }
    void sceneRenderer() {
        AmbientOcclusion& drawn = *guest.drawn_;
        guest.throws_ = dice.chance(0.3);
        expect(guest.throws_ ? StatusCode::CallbackFailed : StatusCode::Ok,
               drawn.addCubeMap(somewhere()));
        guest.throws_ = false;
        expect(StatusCode::Ok, drawn.aoSceneChanged({-1, 0, -1}, {1, 1, 1}));
        expect(StatusCode::Ok, drawn.aoDrawBegin());
        expect(situation.frame, drawn.aoDrawEnd(Guest::eye().x, Guest::eye().y, Guest::eye().z));
        if (drawn.cubeMaps().size() >= kMaxCubeMaps) {
            expect(StatusCode::Ok, drawn.clear());
        }
        expect(StatusCode::InvalidPosition, drawn.aoSceneChanged({1, 0, 1}, {-1, 1, -1}));
        expect(StatusCode::NoScene, ao().aoSceneChanged({0, 0, 0}, {1, 1, 1}));
    }
    void readVisibility() {
        const auto image = ao().readVisibility();
        expect(guest.hadFrame_ ? StatusCode::Ok : StatusCode::InvalidCallOrder, image);
        expect(StatusCode::InvalidCallOrder, empty().readVisibility());
    }
    /// Frames of views of their own, one of which goes.
    void views() {
        const ViewId id{static_cast<std::uint32_t>(dice.between(1, 3))};
        const glm::vec3& eye = Guest::eye();
        expect(StatusCode::Ok, ao().aoDrawBegin());
        const AoStatus status = ao().aoDrawEnd(eye.x, eye.y, eye.z, id);
        expect(situation.frame, status);
        if (status) {
            expect(StatusCode::Ok, ao().readVisibility(id));
        }
        expect(StatusCode::InvalidCallOrder, ao().readVisibility(ViewId{99}));
        expect(StatusCode::Ok,
               ao().removeView(ViewId{static_cast<std::uint32_t>(dice.between(1, 3))}));
        frame();
    }
    void shade() {
        const AoStatus status = ao().aoShade(Guest::view(), Guest::projection());
        expect(situation.frame, status);
        guest.hadFrame_ = guest.hadFrame_ || status.ok();
        glm::mat4 broken(1.0F);
        broken[0][0] = kNaN;
        expect(StatusCode::InvalidCamera, ao().aoShade(broken, broken));
    }
    void prepare() {
        expect(StatusCode::InvalidPosition, ao().prepare({}, std::array{glm::vec3(0, kNaN, 0)}));
        expect(StatusCode::NoScene, empty().prepare({}));
        const bool stops = dice.chance(0.3);
        const bool full = ao().cubeMaps().size() >= kMaxCubeMaps ||
                          ao().options().cubeMaps.memoryBudget == kTightBudget;
        const std::vector<glm::vec3> places(full ? 0 : 1, somewhere());
        expect(stops ? StatusCode::Cancelled : StatusCode::Ok,
               ao().prepare([&](float /*progress*/) { return !stops; }, places));
    }
    void readCubeMap() {
        const bool known = !ao().cubeMaps().empty();
        expect(known ? StatusCode::Ok : StatusCode::UnknownCubeMap,
               ao().readCubeMap(someCubeMap()));
    }
    void look() {
        (void)ao().statistics();
        (void)ao().cubeMaps();
        (void)ao().lastStatus();
        int told = 0;
        ao().setMessageSink([&told](const AoStatus&) { ++told; });
        expect(StatusCode::InvalidCallOrder, ao().aoEnd());
        ao().setMessageSink({});
        expect(StatusCode::InvalidCallOrder, ao().aoEnd());
        if (told != 1) {
            fault.append("the sink was told ").append(std::to_string(told)).append(" failures; ");
        }
    }
    /// A triangle, one vertex at a time.
    void describeMesh() {
        const bool broken = dice.chance(0.3);
        expect(StatusCode::Ok, ao().meshBegin());
        expect(StatusCode::Ok, ao().aoNormal3f(0, 1, 0));
        for (int i = 0; i < 3; ++i) {
            const glm::vec3 at = somewhere();
            expect(StatusCode::Ok, ao().aoVertex3f(at.x, at.y, at.z));
        }
        expect(StatusCode::Ok, ao().aoBegin(AO_TRIANGLES));
        for (std::uint32_t i = 0; i < 3; ++i) {
            const bool wrong = broken && i == 2;
            expect(wrong ? StatusCode::InvalidIndex : StatusCode::Ok,
                   ao().aoVertexIndex(wrong ? 77 : i));
        }
        expect(broken ? StatusCode::IncompletePrimitive : StatusCode::Ok, ao().aoEnd());
        const Result<MeshId> mesh = ao().meshEnd();
        expect(broken ? StatusCode::InvalidIndex : StatusCode::Ok, mesh);
        frame();
        if (mesh) {
            expect(StatusCode::Ok, ao().removeMesh(*mesh));
            expect(StatusCode::UnknownMesh, ao().removeMesh(*mesh));
        }
    }
    void moveMesh() {
        const glm::mat4 transform = glm::translate(glm::mat4(1.0F), somewhere() * 0.2F);
        expect(StatusCode::Ok, ao().moveMesh(guest.meshes_[1], transform));
        frame();
    }
    void replaceMesh() {
        const ModelMesh box = guestScene().meshes[2];
        MeshData data{box.positions, {}, box.indices};
        data.transform = glm::translate(glm::mat4(1.0F), somewhere() * 0.1F);
        expect(StatusCode::Ok, ao().replaceMesh(guest.meshes_[2], data));
        if (dice.chance(0.5)) {
            const Result<MeshId> extra = ao().addMesh(data);
            expect(StatusCode::Ok, extra);
            frame();
            expect(StatusCode::Ok, ao().removeMesh(*extra));
        }
        frame();
    }
};

namespace {

struct NamedCall {
    const char* name;
    void (GuestCalls::*function)();
    int weight; ///< how often it is drawn; those that build shaders take long
};

constexpr std::array kCalls{
    NamedCall{"create, destroy", &GuestCalls::create, 4},
    NamedCall{"create, refused", &GuestCalls::createRefused, 20},
    NamedCall{"move the instance", &GuestCalls::move, 5},
    NamedCall{"setOptions: estimate", &GuestCalls::estimate, 30},
    NamedCall{"setOptions: appearance", &GuestCalls::appearance, 60},
    NamedCall{"setOptions: pace", &GuestCalls::pace, 40},
    NamedCall{"a view at rest", &GuestCalls::rest, 9},
    NamedCall{"setOptions, refused", &GuestCalls::optionsRefused, 20},
    NamedCall{"setOptions: estimator", &GuestCalls::exchangeEstimator, 6},
    NamedCall{"setOptions: backbone", &GuestCalls::exchangeBackbone, 4},
    NamedCall{"addCubeMap", &GuestCalls::addCubeMap, 40},
    NamedCall{"addCubeMap, refused", &GuestCalls::addCubeMapRefused, 20},
    NamedCall{"removeCubeMap", &GuestCalls::removeCubeMap, 20},
    NamedCall{"clear", &GuestCalls::clear, 10},
    NamedCall{"aoDrawBegin, aoDrawEnd", &GuestCalls::frame, 120},
    NamedCall{"aoDrawBegin twice", &GuestCalls::frameTwiceBegun, 20},
    NamedCall{"aoDrawEnd, refused", &GuestCalls::frameNotBegun, 20},
    NamedCall{"aoDrawEnd without a camera", &GuestCalls::frameWithoutCamera, 20},
    NamedCall{"aoApply", &GuestCalls::apply, 40},
    NamedCall{"aoApply, refused", &GuestCalls::applyRefused, 20},
    NamedCall{"setSceneRenderer, aoSceneChanged", &GuestCalls::sceneRenderer, 30},
    NamedCall{"readVisibility", &GuestCalls::readVisibility, 30},
    NamedCall{"views", &GuestCalls::views, 20},
    NamedCall{"aoShade", &GuestCalls::shade, 20},
    NamedCall{"prepare", &GuestCalls::prepare, 10},
    NamedCall{"readCubeMap", &GuestCalls::readCubeMap, 30},
    NamedCall{"statistics, cubeMaps", &GuestCalls::look, 30},
    NamedCall{"meshBegin ... meshEnd", &GuestCalls::describeMesh, 20},
    NamedCall{"moveMesh and a frame", &GuestCalls::moveMesh, 40},
    NamedCall{"replaceMesh and frames", &GuestCalls::replaceMesh, 30}};

} // namespace

std::size_t Guest::kinds() {
    return kCalls.size();
}

Guest::Outcome Guest::call(Dice& dice, const Situation& situation) {
    int total = 0;
    for (const NamedCall& call : kCalls) {
        total += call.weight;
    }
    int drawn = dice.between(0, total - 1);
    const NamedCall* chosen = kCalls.data();
    while (drawn >= chosen->weight) {
        drawn -= chosen->weight;
        ++chosen;
    }
    GuestCalls calls{*this, dice, situation, {}};
    (calls.*chosen->function)();
    return {chosen->name, calls.fault};
}

} // namespace aolib
