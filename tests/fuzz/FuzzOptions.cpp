// Options of any value: accepted exactly when each lies in its range, and refused with a reason.
#include <cmath>
#include <type_traits>

#include <aolib/OptionFields.h>

#include "CheckOptions.h"
#include "FuzzTarget.h"

namespace {

using aolib::fuzz::Bytes;

/// Fills each option that the bytes choose, and tells whether all lie in their ranges.
struct Fill {
    Bytes& bytes;
    bool inRange = true;

    template <typename Number>
    void operator()(std::string_view name, Number& value, aolib::OptionRange range,
                    std::string_view /*help*/) {
        if (bytes.take<std::uint8_t>() % 4 == 0) {
            value = bytes.take<Number>();
        }
        const auto number = static_cast<double>(value);
        // NaN is in no range; a blur has a middle.
        inRange = inRange && number >= range.min && number <= range.max &&
                  !(name == "blur-size" && std::fmod(number, 2.0) == 0.0);
    }
    void operator()(std::string_view /*name*/, bool& value, std::string_view /*help*/) {
        value = bytes.take<std::uint8_t>() % 2 != 0;
    }
    template <typename E, std::size_t N>
    void operator()(std::string_view /*name*/, E& value,
                    const std::array<aolib::OptionChoice<E>, N>& choices,
                    std::string_view /*help*/) {
        if (bytes.take<std::uint8_t>() % 4 != 0) {
            return;
        }
        value = static_cast<E>(bytes.take<std::underlying_type_t<E>>());
        bool known = false;
        for (const auto& choice : choices) {
            known = known || choice.value == value;
        }
        inRange = inRange && known;
    }
};

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes(data, size);
    aolib::Options options;
    Fill fill{bytes};
    aolib::visitOptions(options, fill);
    const aolib::AoStatus status = aolib::checkOptions(options);
    const aolib::CubeMapOptions& maps = options.cubeMaps;
    const double texels = 6.0 * maps.faceSize * maps.faceSize;
    const bool room = maps.memoryBudget == 0.0F || maps.memoryBudget * 1048576.0 > 3.01 * texels;
    const bool together = room && !(options.backbone == aolib::Backbone::ScreenSpace &&
                                    options.estimator == aolib::Estimator::RayTraced);
    aolib::fuzz::require(!status.ok() || fill.inRange, "what is accepted lies in its range");
    aolib::fuzz::require(status.ok() || !fill.inRange || !together,
                         "what lies in range is accepted");
    aolib::fuzz::require(status.ok() || !status.message().empty(), "a reason is given");
    return 0;
}
