#include "bench/ResultJson.h"

namespace aolib::bench {

Json knownJson(double value) {
    return value >= 0.0 ? Json(value) : Json(nullptr);
}

Json spreadJson(const Spread& spread) {
    return {{"median", knownJson(spread.median)},
            {"q1", knownJson(spread.low)},
            {"q3", knownJson(spread.high)},
            {"count", spread.count}};
}

Json machineJson(const MachineInfo& machine, const std::string& commandLine) {
    return {{"cpu", machine.cpu},       {"cores", machine.cores}, {"driver", machine.driver},
            {"commit", machine.commit}, {"date", machine.date},   {"command", commandLine}};
}

std::string fileText(const Json& json) {
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace aolib::bench
