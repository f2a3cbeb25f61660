#include "app/BakeFlags.h"

#include <sstream>

#include <CLI/CLI.hpp>

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
        {{"step", Falloff::Step}, {"exp", Falloff::Exp}, {"none", Falloff::None}},
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

void attachRays(BakeFlags& flags, CLI::App& command) {
    const char* const group = "Rays";
    addWholeNumber(
        command, "--rays", 1, 1 << 20, [&flags](int rays) { flags.rays.rays = rays; },
        "per texel, vertex or sample")
        ->default_str("256")
        ->group(group);
    addChoice<bake::Sampling>(
        command, "--sampling",
        {{"stratified", bake::Sampling::Stratified}, {"rejection", bake::Sampling::Rejection}},
        [&flags](bake::Sampling value) { flags.rays.sampling = value; },
        "Sobol's points about the normal, or random points in a cube")
        ->default_str("stratified")
        ->group(group);
    addChoice<bake::Measure>(
        command, "--measure",
        {{"cosine", bake::Measure::Cosine}, {"solid-angle", bake::Measure::SolidAngle}},
        [&flags](bake::Measure value) { flags.rays.measure = value; },
        "visibility W, or the plain share of open directions")
        ->default_str("cosine")
        ->group(group);
    addWholeNumber(
        command, "--threads", 0, 1024, [&flags](int threads) { flags.rays.threads = threads; },
        "0 = one per core")
        ->default_str("0")
        ->group(group);
}

void attachScatter(BakeFlags& flags, CLI::App& command) {
    const char* const group = "Scatter";
    bake::ScatterOptions& scatter = flags.scatter;
    addWholeNumber(
        command, "--raster", 0, 16384, [&scatter](int size) { scatter.rasterSize = size; },
        "pixels along the picture from each direction; 0 = by the map's texels")
        ->default_str("0")
        ->group(group);
    addNumber(
        command, "--point-size",
        [&scatter](double size) { scatter.pointSize = static_cast<float>(size); },
        "texels along a point's edge, with fractions; 0 = the nearest texel alone")
        ->default_str("0.5")
        ->group(group);
    command
        .add_flag("!--no-stretch", scatter.stretchCorrection,
                  "take charts to be stretched alike everywhere, for comparison")
        ->group(group);
    addChoice<bake::Normalisation>(
        command, "--normalise",
        {{"derived", bake::Normalisation::Derived}, {"brightest", bake::Normalisation::Brightest}},
        [&scatter](bake::Normalisation value) { scatter.normalisation = value; },
        "how sums become W: derived, or the brightest texel is taken for open")
        ->default_str("derived")
        ->group(group);
    addChoice<bake::SeamFix>(
        command, "--seams",
        {{"coverage", bake::SeamFix::Coverage}, {"erosion", bake::SeamFix::Erosion}},
        [&scatter](bake::SeamFix value) { scatter.seams = value; },
        "texels that charts cover in part: divided by that part, or discarded and filled")
        ->default_str("coverage")
        ->group(group);
}

void attachShadow(BakeFlags& flags, CLI::App& command) {
    const char* const group = "Shadow maps";
    bake::ShadowOptions& shadow = flags.shadow;
    addWholeNumber(
        command, "--depth-size", 64, 8192, [&shadow](int size) { shadow.depthSize = size; },
        "texels along a depth map")
        ->default_str("1024")
        ->group(group);
    addWholeNumber(
        command, "--maps-per-pass", 1, 16, [&shadow](int count) { shadow.mapsPerPass = count; },
        "depth maps read in one pass")
        ->default_str("8")
        ->group(group);
    addNumber(
        command, "--bias", [&shadow](double bias) { shadow.bias = static_cast<float>(bias); },
        "texels of a depth map by which receivers on slopes are lifted")
        ->default_str("1")
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
        command, "--target", {{"texture", BakeTarget::Texture}, {"vertex", BakeTarget::Vertex}},
        [this](BakeTarget value) { target = value; }, "what the occlusion goes to")
        ->default_str("texture");
    attachPoses(*this, command);
    attachOutputs(*this, command);
    attachMaps(*this, command);
    attachLight(*this, command);
    attachRays(*this, command);
    attachScatter(*this, command);
    attachShadow(*this, command);
    gl.attach(command);
}

} // namespace aolib::app
