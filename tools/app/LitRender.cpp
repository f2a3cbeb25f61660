#include "app/LitRender.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <glm/geometric.hpp>

#include "app/Interruption.h"
#include "app/NumberFlags.h"
#include "app/OutputFiles.h"
#include "app/RenderJob.h"
#include "app/Table.h"
#include "bench/environment/EnvironmentRun.h"
#include "bench/environment/LitScene.h"
#include "bench/environment/TracedLight.h"
#include "content/EnvironmentSource.h"
#include "image/ToneMap.h"

namespace aolib::app {

namespace {

namespace fs = std::filesystem;

/// What of the picture's mean over surfaces is shown at 63%.
constexpr double kShownMean = 1.0;

/// Root of the mean squared difference over the traced surfaces' pixels, of the mean there.
double errorOf(const FloatImage& drawn, const FloatImage& traced,
               const std::vector<std::uint8_t>& covered) {
    double squares = 0.0;
    double count = 0.0;
    for (std::size_t pixel = 0; pixel < covered.size(); ++pixel) {
        for (std::size_t channel = 0; covered[pixel] != 0 && channel < 3; ++channel) {
            const std::size_t i = 3 * pixel + channel;
            const double error = double{drawn.pixels[i]} - double{traced.pixels[i]};
            squares += error * error;
            count += 1.0;
        }
    }
    const double mean = host::meanOverSurfaces(traced, covered);
    return count > 0.0 && mean > 0.0 ? std::sqrt(squares / count) / mean : 0.0;
}

void put(OutputFiles& files, const std::string& file, const FloatImage& radiance, float exposure) {
    if (fs::path(file).extension() == ".pfm") {
        files.put(file, radiance);
    } else {
        files.put(file, toneMapped(radiance, exposure));
    }
}

class LitJob {
public:
    LitJob(const LitFlags& flags, View view, GlSession session)
        : flags_(flags), view_(std::move(view)), session_(std::move(session)) {}

    MaybeFailure run(const lighting::EnvironmentMap& map, OutputFiles& files);

private:
    MaybeFailure bake();
    MaybeFailure draw(const lighting::EnvironmentMap& map);
    MaybeFailure trace(const lighting::EnvironmentMap& map);

    const LitFlags& flags_;
    View view_;
    GlSession session_;
    Progress progress_;
    bench::LitScene scene_;
    host::LitRenderer::Picture picture_;
    std::optional<bench::TracedLight> truth_;
};

MaybeFailure LitJob::bake() {
    progress_.begin(view_.model.name + ": baking its vertices");
    bench::LitSceneOptions options;
    options.edge = flags_.edge / 100.0;
    options.rays = flags_.rays;
    const auto goOn = [&](double done) {
        progress_.update(done);
        return !Interruption::happened();
    };
    Result<bench::LitScene> scene = bench::bakeLitScene(std::move(view_.model), options, goOn);
    if (!scene) {
        return failureOf(scene.status());
    }
    scene_ = std::move(*scene);
    return std::nullopt;
}

MaybeFailure LitJob::draw(const lighting::EnvironmentMap& map) {
    progress_.begin(scene_.name + ": drawing");
    Result<host::LitRenderer> renderer =
        host::LitRenderer::create(session_.gl(), scene_.pieces, {view_.width, view_.height});
    if (!renderer) {
        return failureOf(renderer.status());
    }
    if (const AoStatus status = renderer->setEnvironment(session_.loader(), map); !status) {
        return failureOf(status);
    }
    renderer->draw(viewMatrix(view_.camera),
                   projectionMatrix(view_.camera, static_cast<float>(view_.width) /
                                                      static_cast<float>(view_.height)),
                   flags_.method);
    picture_ = renderer->read();
    return session_.reviewMessages();
}

MaybeFailure LitJob::trace(const lighting::EnvironmentMap& map) {
    progress_.begin(scene_.name + ": tracing");
    Result<bench::TracedLight> truth =
        bench::traceLight(scene_, map, view_.camera, view_.width, view_.height, flags_.truthRays,
                          progress_.callback());
    if (!truth) {
        return failureOf(truth.status());
    }
    truth_ = std::move(*truth);
    return std::nullopt;
}

MaybeFailure LitJob::run(const lighting::EnvironmentMap& map, OutputFiles& files) {
    if (MaybeFailure failure = bake()) {
        return failure;
    }
    if (MaybeFailure failure = draw(map)) {
        return failure;
    }
    if (!flags_.truth.empty()) {
        if (MaybeFailure failure = trace(map)) {
            return failure;
        }
    }
    progress_.pause();
    const double mean = host::meanOverSurfaces(picture_.radiance, picture_.covered);
    const float exposure = static_cast<float>(
        flags_.exposure > 0.0 ? flags_.exposure : (mean > 0.0 ? kShownMean / mean : 1.0));
    put(files, flags_.picture, picture_.radiance, exposure);
    std::cout << session_.describe() << '\n'
              << scene_.name << ": " << grouped(scene_.vertices()) << " vertices baked in "
              << knownNumber(scene_.bakeSeconds, 1) << " s; lit by " << flags_.environment << ", "
              << bench::litMethodName(flags_.method) << ", exposure " << knownNumber(exposure, 3)
              << '\n';
    if (truth_) {
        FloatImage shown = picture_.radiance; // with its background
        truth_->paint(shown);
        put(files, flags_.truth, shown, exposure);
        std::cout << "RMSE against " << flags_.truthRays << " rays per pixel: "
                  << knownPercentage(errorOf(picture_.radiance, shown, picture_.covered))
                  << " of the mean radiance\n";
    }
    return files.commit();
}

} // namespace

void LitFlags::attach(CLI::App& command) {
    command
        .add_option("--environment", environment,
                    "light the scene by this instead and write --lit alone: a .hdr file, or one of "
                    "sunny, sunset, overcast, studio, window")
        ->type_name("ENVIRONMENT");
    addChoice<host::LitMethod>(
        command, "--lit-method",
        {{"irradiance", host::LitMethod::Irradiance},
         {"blurred", host::LitMethod::Blurred},
         {"blurred-by-angles", host::LitMethod::BlurredByAngles},
         {"cone", host::LitMethod::Cone},
         {"cone-and-sun", host::LitMethod::ConeAndSun},
         {"sectors", host::LitMethod::Sectors},
         {"sectors-and-sun", host::LitMethod::SectorsAndSun}},
        [this](host::LitMethod value) { method = value; },
        "how surfaces are lit by the environment")
        ->default_str("sectors-and-sun");
    command.add_option("--lit", picture, "the lit picture, .png, or .pfm for linear radiance")
        ->type_name("FILE");
    command.add_option("--lit-truth", truth, "the same traced; the error is printed")
        ->type_name("FILE");
    addWholeNumber(
        command, "--lit-rays", 1, kMostRays, [this](int count) { rays = count; },
        "rays per vertex that the environment's method gets its values from")
        ->default_str(std::to_string(rays));
    addWholeNumber(
        command, "--lit-truth-rays", 8, kMostRays, [this](int count) { truthRays = count; },
        "rays per pixel of --lit-truth")
        ->default_str(std::to_string(truthRays));
    addNumber(
        command, "--lit-edge", [this](double percent) { edge = percent; },
        "edges are cut that are longer, percent of the scene's diagonal")
        ->default_str("0.5");
    addNumber(
        command, "--turn", [this](double degrees) { turn = degrees; },
        "turn the environment about the vertical, degrees");
    addNumber(
        command, "--exposure", [this](double value) { exposure = value; },
        "of the lit picture, per unit of radiance; without it by the picture's mean");
}

MaybeFailure renderLit(const LitFlags& flags, const ViewFlags& view, const GlFlags& gl) {
    if (flags.picture.empty()) {
        return badInput("--environment needs --lit, the picture to write");
    }
    if (flags.exposure < 0.0) {
        return badInput("--exposure must be above 0");
    }
    if (!(flags.edge > 0.0)) {
        return badInput("--lit-edge must be above 0");
    }
    OutputFiles files;
    if (MaybeFailure failure = files.announce("--lit", flags.picture, {".png", ".pfm"})) {
        return failure;
    }
    if (!flags.truth.empty()) {
        if (MaybeFailure failure = files.announce("--lit-truth", flags.truth, {".png", ".pfm"})) {
            return failure;
        }
    }
    Result<lighting::EnvironmentMap, LoadError> map = openEnvironment(flags.environment);
    if (!map) {
        return badInput(map.error().sentence);
    }
    const Interruption interruption;
    Result<View, Failure> opened = view.open();
    if (!opened) {
        return opened.error();
    }
    Result<GlSession, Failure> session = GlSession::open(gl);
    if (!session) {
        return session.error();
    }
    return LitJob(flags, std::move(*opened), std::move(*session))
        .run(lighting::turned(*map, static_cast<float>(flags.turn / 360.0)), files);
}

} // namespace aolib::app
