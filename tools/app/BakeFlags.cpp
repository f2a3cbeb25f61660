#include "app/BakeFlags.h"

#include <sstream>

#include <CLI/CLI.hpp>

#include "app/BakeMethodFlags.h"
#include "app/NumberFlags.h"

namespace aolib::app {

namespace {

void attachOutputs(BakeFlags& flags, CLI::App& command) {
    const char* const group = "Output";
    command
        .add_option("-o,--out", flags.out,
                    "the model with its occlusion, .glb; for several models a folder")
        ->type_name("FILE")
        ->group(group);
    command
        .add_option(
            "--ao", flags.ao,
            "the map by itself, .png, .pfm or .exr; with several maps -NAME is put before the "
            "extension")
        ->type_name("FILE")
        ->group(group);
    command
        .add_option("--bent-normals", flags.bentNormals,
                    "mean open directions in world space as a map, .png (n * 0.5 + 0.5), "
                    ".pfm or .exr")
        ->type_name("FILE")
        ->group(group);
    addChoice<int>(
        command, "--bits", {{"8", 8}, {"16", 16}}, [&flags](int bits) { flags.bits = bits; },
        "bits per channel of PNGs")
        ->default_str("8")
        ->group(group);
    addChoice<VertexAttribute>(
        command, "--attribute", {{"ao", VertexAttribute::Ao}, {"color", VertexAttribute::Color}},
        [&flags](VertexAttribute value) { flags.attribute = value; },
        "vertices: _AO and _BENT_NORMAL, or the vertex colour COLOR_0")
        ->default_str("ao")
        ->group(group);
}

void attachMaps(BakeFlags& flags, CLI::App& command) {
    const char* const group = "Maps and vertices";
    addWholeNumber(
        command, "--size", 16, 16384,
        [&flags](int size) { flags.map.width = flags.map.height = size; },
        "texels along each side of a map")
        ->default_str("1024")
        ->group(group);
    addWholeNumber(
        command, "--padding", 0, 64, [&flags](int padding) { flags.map.padding = padding; },
        "texels that charts are grown by")
        ->default_str("8")
        ->group(group);
    addWholeNumber(
        command, "--texel-samples", 1, 64,
        [&flags](int places) { flags.map.texelSamples = places; },
        "places across a texel that rays or directions are shared out among; 1 = its centre")
        ->default_str("16")
        ->group(group);
    command.add_flag("!--no-fill", flags.map.fill, "leave what lies beyond the padding black")
        ->group(group);
    addWholeNumber(
        command, "--uv-set", 0, 7, [&flags](int set) { flags.uvSet = set; },
        "TEXCOORD_n to use; without it the first that is fit")
        ->group(group);
    addChoice<Unwrap>(
        command, "--unwrap",
        {{"auto", Unwrap::Auto}, {"never", Unwrap::Never}, {"always", Unwrap::Always}},
        [&flags](Unwrap value) { flags.unwrap = value; },
        "make UVs of our own: where the model's are missing, overlap or tile; never; always")
        ->default_str("auto")
        ->group(group);
    addChoice<bake::VertexFit>(
        command, "--fit",
        {{"direct", bake::VertexFit::Direct},
         {"triangle-mean", bake::VertexFit::TriangleMean},
         {"least-squares", bake::VertexFit::LeastSquares}},
        [&flags](bake::VertexFit value) { flags.vertices.fit = value; },
        "vertices: traced there, means of triangles' centres, or fitted to the surface")
        ->default_str("direct")
        ->group(group);
    addNumber(
        command, "--smoothness",
        [&flags](double value) { flags.vertices.smoothness = static_cast<float>(value); },
        "least-squares: weight of differences along edges, 0 to 100")
        ->default_str("0.1")
        ->group(group);
    addNumber(
        command, "--density",
        [&flags](double value) { flags.vertices.density = static_cast<float>(value); },
        "least-squares: samples per triangle, 1 to 256")
        ->default_str("4")
        ->group(group);
}

void attachLight(BakeFlags& flags, CLI::App& command) {
    const char* const group = "Occlusion";
    const auto takeRadius = [&flags](const std::string& text) {
        const std::optional<Length> length = parseLength(text);
        if (!length) {
            throw CLI::ValidationError("--radius " + text +
                                       ": a length such as 0.3 or 10% is needed");
        }
        flags.radius = *length;
    };
    command
        .add_option_function<std::string>(
            "--radius", takeRadius,
            "reach of occluders, world units; 5% = of the scene's diagonal; 0 = endless")
        ->type_name("LENGTH")
        ->default_str("0")
        ->group(group);
    addChoice<Falloff>(
        command, "--falloff",
        {{"step", Falloff::Step}, {"exp", Falloff::Exp}, {"none", Falloff::Off}},
        [&flags](Falloff value) { flags.rays.falloff = value; },
        "weight of an occluder over its distance, where there is a radius")
        ->default_str("step")
        ->group(group);
    addChoice<bake::Sky>(
        command, "--sky", {{"sphere", bake::Sky::Sphere}, {"dome", bake::Sky::Dome}},
        [&flags](bake::Sky value) { flags.rays.sky = value; },
        "where light comes from: everywhere, or above the horizon")
        ->default_str("sphere")
        ->group(group);
    addWholeNumber(
        command, "--directions", 1, 1 << 20,
        [&flags](int count) { flags.scatter.directions = flags.shadow.directions = count; },
        "of light, for scatter and shadow")
        ->default_str("512")
        ->group(group);
    addWholeNumber(
        command, "--seed", 0, 1 << 30,
        [&flags](int seed) { flags.rays.seed = static_cast<std::uint32_t>(seed); },
        "another seed, another noise")
        ->default_str("0")
        ->group(group);
    const auto takeGround = [&flags](const std::string& text) {
        flags.ground = true;
        flags.groundHeight = parseNumber(text);
        if (text != "below" && !flags.groundHeight) {
            throw CLI::ValidationError("--ground " + text + ": a height or \"below\" is needed");
        }
    };
    command
        .add_option_function<std::string>("--ground", takeGround,
                                          "an endless ground at this y, or below the model")
        ->type_name("Y|below")
        ->group(group);
}

void attachWatching(BakeFlags& flags, CLI::App& command) {
    const char* const group = "Watching and ending";
    command
        .add_option(
            "--watch", flags.watch,
            "the map so far, replaced every two seconds: .png, .pfm or .exr; textures alone")
        ->type_name("FILE")
        ->group(group);
    const auto takeSeconds = [&flags](double seconds) {
        if (!(seconds > 0.0)) {
            reject("--seconds", std::to_string(seconds), "a time above 0");
        }
        flags.seconds = seconds;
    };
    addNumber(command, "--seconds", takeSeconds,
              "end the bake after so long, with the rays or directions that there are by then; "
              "textures alone")
        ->group(group);
}

void attachCamera(BakeFlags& flags, CLI::App& command) {
    const char* const group = "Camera";
    command.add_option("--camera", flags.camera, "by name, for --target camera")
        ->type_name("NAME")
        ->group(group);
    addWholeNumber(command, "--width", 1, 16384, flags.width, "of its picture, pixels")
        ->group(group);
    addWholeNumber(command, "--height", 1, 16384, flags.height, "of its picture, pixels")
        ->group(group);
}

void attachPoses(BakeFlags& flags, CLI::App& command) {
    const char* const group = "Poses";
    const auto takeTimes = [&flags](const std::string& text) {
        flags.poses.clear();
        std::istringstream parts(text);
        for (std::string part; std::getline(parts, part, ',');) {
            const std::optional<double> time = parseNumber(part);
            if (!time || *time < 0.0 || *time > 1e6 ||
                (!flags.poses.empty() && static_cast<float>(*time) <= flags.poses.back())) {
                flags.poses.clear();
                break;
            }
            flags.poses.push_back(static_cast<float>(*time));
        }
        if (flags.poses.empty()) {
            throw CLI::ValidationError("--poses " + text +
                                       ": growing times such as 0,0.5,1 are needed");
        }
    };
    command
        .add_option_function<std::string>(
            "--poses", takeTimes,
            "vertices: bake the model at these times of its animation, seconds, as _AO_0, "
            "_BENT_NORMAL_0, _AO_1, ...")
        ->type_name("T0,T1,...")
        ->group(group);
    addWholeNumber(
        command, "--animation", 0, 100000, [&flags](int number) { flags.animation = number; },
        "which one, by its number in the file")
        ->default_str("0")
        ->group(group);
}

} // namespace

void BakeFlags::attach(CLI::App& command) {
    command.add_option("models", inputs, ".glb, .gltf or .obj files, or shapes and scenes by name")
        ->type_name("MODEL")
        ->required();
    addChoice<BakeMethod>(
        command, "--method",
        {{"rays", BakeMethod::Rays},
         {"scatter", BakeMethod::Scatter},
         {"shadow", BakeMethod::Shadow}},
        [this](BakeMethod value) { method = value; },
        "rays on the CPU; points scattered, or shadow maps, on the GPU")
        ->default_str("rays");
    addChoice<BakeTarget>(
        command, "--target",
        {{"texture", BakeTarget::Texture},
         {"vertex", BakeTarget::Vertex},
         {"camera", BakeTarget::Camera}},
        [this](BakeTarget value) { target = value; },
        "what the occlusion goes to; camera: a picture, to --ao")
        ->default_str("texture");
    attachPoses(*this, command);
    attachOutputs(*this, command);
    attachMaps(*this, command);
    attachWatching(*this, command);
    attachCamera(*this, command);
    attachLight(*this, command);
    attachBakeMethods(*this, command);
    gl.attach(command);
}

} // namespace aolib::app
