#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <aolib/Options.h>

namespace aolib::bench {

/// Methods that differ in quality alone are a family: one curve of a plot.
enum class Family {
    HorizonCube,      ///< aolib: the thesis's estimator, cube maps
    LayeredCube,      ///< aolib: layered intervals, one cube map
    RayTracedCube,    ///< aolib: texels traced in the background
    LayeredCubeTen,   ///< aolib: layered intervals, ten cube maps
    HorizonScreen,    ///< the thesis's estimator on the host's view, every frame
    LayeredScreen,    ///< slices of constant thickness on the host's view, every frame, blurred
    LayeredScreenRaw, ///< the same without the blur
    SurfaceElements,  ///< discs and form factors per vertex
    FewRays,          ///< rays through every pixel, every frame
};

/// All families, in the order of legends.
const std::vector<Family>& families();
/// "layered intervals, one cube map"
std::string_view familyName(Family family);

/// Through the library's facade.
struct FacadeMethod {
    Options options;     ///< but for the radius, which is the case's
    int cubeMaps = 1;    ///< placed by hand: one at the eye, others before what it sees; 0 for none
    bool tracer = true;  ///< the host gives one
    bool moving = false; ///< frames are timed while the camera moves
};

/// Traced on the CPU, every frame.
struct FewRaysMethod {
    int raysPerPixel = 1; ///< a power of two, 1 to 256
};

/// Discs per vertex, computed once on the CPU.
struct SurfaceElementsMethod {
    int elements = 20000; ///< at most so many vertices after subdivision of large triangles
};

/// A way to get a picture of W.
struct Method {
    std::string name;  ///< unique, for --method and for files
    std::string label; ///< short, beside a point of a plot
    Family family = Family::HorizonCube;
    std::variant<FacadeMethod, FewRaysMethod, SurfaceElementsMethod> how;
    bool standard = true; ///< run unless --method says otherwise; the others take very long
};

/// Every method, qualities of a family in a row, lowest first.
const std::vector<Method>& benchMethods();

/// Whether a name fits a pattern with * (any text) and ? (any one character).
bool matches(std::string_view pattern, std::string_view name);

/// The methods that any of the patterns names; the standard ones where there are no patterns.
std::vector<Method> chooseMethods(const std::vector<std::string>& patterns);

} // namespace aolib::bench
