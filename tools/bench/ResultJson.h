#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "bench/MachineInfo.h"
#include "bench/Spread.h"

namespace aolib::bench {

using Json = nlohmann::ordered_json;

/// The value, null where it is negative: the sign of "not known".
Json knownJson(double value);
Json spreadJson(const Spread& spread);
/// With the command that was run.
Json machineJson(const MachineInfo& machine, const std::string& commandLine);
/// For a file: indented, with a line feed at the end; text that is not UTF-8 is repaired.
std::string fileText(const Json& json);

} // namespace aolib::bench
