#include "CheckOptions.h"

#include <algorithm>
#include <sstream>
#include <string_view>

#include <aolib/OptionFields.h>

#include "backbone/cubemaps/Eviction.h"
#include "backbone/cubemaps/FaceStore.h"

namespace aolib {

namespace {

/// Visits the options and keeps the first fault.
struct Checker {
    AoStatus status;

    template <typename Number>
    void operator()(std::string_view name, const Number& value, OptionRange range,
                    std::string_view /*help*/) {
        const auto number = static_cast<double>(value);
        if (status && !(number >= range.min && number <= range.max)) {
            std::ostringstream text;
            text << name << " is " << value << "; it must be " << range.min << " to " << range.max;
            status = AoStatus(StatusCode::InvalidOption, text.str());
        }
    }

    void operator()(std::string_view /*name*/, const bool& /*value*/, std::string_view /*help*/) {}

    template <typename E, std::size_t N>
    void operator()(std::string_view name, const E& value,
                    const std::array<OptionChoice<E>, N>& choices, std::string_view /*help*/) {
        const bool known = std::any_of(choices.begin(), choices.end(),
                                       [&](const auto& choice) { return choice.value == value; });
        if (status && !known) {
            status = AoStatus(StatusCode::InvalidOption,
                              std::string(name) + " holds a value that is not one of its choices");
        }
    }
};

} // namespace

AoStatus checkOptions(const Options& options) {
    Checker checker;
    visitOptions(options, checker);
    if (checker.status && options.blur.size % 2 == 0) {
        return {StatusCode::InvalidOption,
                "blur-size is " + std::to_string(options.blur.size) + "; it must be odd"};
    }
    const CubeMapOptions& cubeMaps = options.cubeMaps;
    if (checker.status && Eviction::layersWithin(cubeMaps, kFaces) < kFaces) {
        std::ostringstream text;
        text << "memory-budget is " << cubeMaps.memoryBudget << " MiB; a cube map with faces of "
             << cubeMaps.faceSize << " x " << cubeMaps.faceSize << " texels takes "
             << static_cast<double>(kFaces * FaceStore::bytesPerLayer(cubeMaps.faceSize)) /
                    (1 << 20)
             << " MiB; raise memory-budget or lower face-size";
        return {StatusCode::InvalidOption, text.str()};
    }
    return checker.status;
}

} // namespace aolib
