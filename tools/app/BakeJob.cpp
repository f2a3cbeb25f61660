#include "app/BakeJob.h"

#include <exception>
#include <memory>
#include <optional>
#include <utility>

#include <aolib/bake/AbstractBaker.h>

#include "app/BakeInput.h"
#include "app/BakeToPoses.h"
#include "app/BakeToTexture.h"
#include "app/BakeToVertices.h"
#include "app/BakeToView.h"
#include "app/Interruption.h"
#include "app/OutputFiles.h"

namespace aolib::app {

namespace {

Failure bakeFailure(const std::string& subject, const AoStatus& status) {
    if (status.code() == StatusCode::Cancelled) {
        return {ExitCode::Failed, "cancelled; nothing was written for " + subject};
    }
    switch (status.code()) {
    case StatusCode::OutOfMemory:
        return {ExitCode::Failed, subject + ": " + status.message()};
    case StatusCode::ShaderError:
    case StatusCode::NoContext:
        return graphicsFailure(subject + ": " + status.message());
    default:
        return badInput(subject + ": " + status.message());
    }
}

class Job {
public:
    Job(BakeInput input, std::string model, const BakeFlags& flags, std::string out,
        Progress& progress)
        : input_(std::move(input)), model_(std::move(model)), flags_(flags), out_(std::move(out)),
          progress_(progress) {}

    Result<std::string, Failure> run();

private:
    std::unique_ptr<AbstractBakeDestination> destination();
    Result<std::unique_ptr<bake::AbstractBaker>, Failure> baker();
    bake::BakeScene scene() const;
    MaybeFailure bakeAll(AbstractBakeDestination& goal);
    MaybeFailure putModel(OutputFiles& files);
    MaybeFailure commit(OutputFiles& files) const;

    BakeInput input_;
    std::string model_;                ///< as it was given
    std::optional<GlSession> session_; ///< outlives bakers
    const BakeFlags& flags_;
    std::string out_;
    Progress& progress_;
};

bake::BakeScene Job::scene() const {
    bake::BakeScene scene;
    for (const BakePiece& piece : input_.pieces) {
        scene.surfaces.push_back(piece.surface);
    }
    if (flags_.ground) {
        scene.ground =
            flags_.groundHeight ? static_cast<float>(*flags_.groundHeight) : input_.bounds.min.y;
    }
    return scene;
}

Result<std::unique_ptr<bake::AbstractBaker>, Failure> Job::baker() {
    Result<std::unique_ptr<bake::AbstractBaker>> made = AoStatus();
    const double radius = flags_.radius.resolved(double{input_.bounds.diagonal()});
    if (flags_.method == BakeMethod::Rays) {
        bake::RayOptions rays = flags_.rays;
        rays.radius = static_cast<float>(radius);
        made = bake::createRayBaker(scene(), rays);
    } else {
        Result<GlSession, Failure> session = GlSession::open(flags_.gl);
        if (!session) {
            return session.error();
        }
        session_.emplace(std::move(*session));
        bake::ScatterOptions scatter = flags_.scatter;
        bake::ShadowOptions shadow = flags_.shadow;
        scatter.sky = shadow.sky = flags_.rays.sky;
        scatter.seed = shadow.seed = flags_.rays.seed;
        scatter.radius = shadow.radius = static_cast<float>(radius);
        scatter.falloff = shadow.falloff = flags_.rays.falloff;
        made = flags_.method == BakeMethod::Scatter
                   ? bake::createScatterBaker(session_->loader(), scene(), scatter)
                   : bake::createShadowBaker(session_->loader(), scene(), shadow);
    }
    if (!made) {
        return bakeFailure(input_.name, made.status());
    }
    return std::move(*made);
}

MaybeFailure Job::bakeAll(AbstractBakeDestination& goal) {
    const auto rounds = static_cast<double>(goal.rounds());
    for (std::size_t round = 0; round < goal.rounds(); ++round) {
        if (MaybeFailure failure = goal.beginRound(round)) {
            return failure;
        }
        const auto made = baker();
        if (!made) {
            return made.error();
        }
        const auto goOn = [&](double fraction) {
            progress_.update((static_cast<double>(round) + fraction) / rounds);
            return !Interruption::happened();
        };
        if (const AoStatus baked = goal.bake(**made, goOn); !baked) {
            return bakeFailure(input_.name, baked);
        }
    }
    return std::nullopt;
}

MaybeFailure Job::putModel(OutputFiles& files) {
    if (out_.empty()) {
        return std::nullopt;
    }
    const Result<std::string, LoadError> glb = input_.edit.glb();
    if (!glb) {
        return Failure{ExitCode::Failed, glb.error().sentence};
    }
    files.put(out_, std::vector<std::uint8_t>(glb->begin(), glb->end()));
    return std::nullopt;
}

MaybeFailure Job::commit(OutputFiles& files) const {
    if (session_) {
        if (MaybeFailure failure = session_->reviewMessages()) {
            return failure;
        }
    }
    if (Interruption::happened()) {
        return bakeFailure(input_.name, {StatusCode::Cancelled, ""});
    }
    return files.commit();
}

std::unique_ptr<AbstractBakeDestination> Job::destination() {
    if (!flags_.poses.empty()) {
        return std::make_unique<BakeToPoses>(input_, flags_);
    }
    if (flags_.target == BakeTarget::Vertex) {
        return std::make_unique<BakeToVertices>(input_, flags_);
    }
    if (flags_.target == BakeTarget::Camera) {
        return std::make_unique<BakeToView>(input_, flags_, model_);
    }
    return std::make_unique<BakeToTexture>(input_, flags_);
}

Result<std::string, Failure> Job::run() {
    progress_.begin(input_.name + ": looking at it");
    OutputFiles files;
    if ((!flags_.watch.empty() || flags_.seconds > 0.0) && flags_.target != BakeTarget::Texture) {
        return badInput("--watch and --seconds go with --target texture");
    }
    const std::unique_ptr<AbstractBakeDestination> goal = destination();
    if (MaybeFailure failure = goal->prepare(files)) {
        return *failure;
    }
    if (!out_.empty()) {
        if (MaybeFailure failure = files.announce("--out", out_, {".glb"})) {
            return *failure;
        }
    }
    progress_.begin(input_.name + ": baking");
    if (MaybeFailure failure = bakeAll(*goal)) {
        return *failure;
    }
    progress_.begin(input_.name + ": writing");
    Result<std::string, Failure> table = goal->put(files);
    if (!table) {
        return table;
    }
    if (MaybeFailure failure = putModel(files)) {
        return *failure;
    }
    if (MaybeFailure failure = commit(files)) {
        return *failure;
    }
    goal->succeed();
    return table;
}

} // namespace

Result<std::string, Failure> bakeModel(const std::string& input, const std::string& out,
                                       const BakeFlags& flags, Progress& progress) {
    progress.begin("opening " + input);
    Result<BakeInput, Failure> opened = openBakeInput(input);
    if (!opened) {
        return opened.error();
    }
    try {
        return Job(std::move(*opened), input, flags, out, progress).run();
    } catch (const std::bad_alloc&) {
        return Failure{ExitCode::Failed, input + ": no memory left; nothing was written"};
    } catch (const std::exception& error) {
        return badInput(input + ": cannot be edited (" + error.what() + ")");
    }
}

} // namespace aolib::app
