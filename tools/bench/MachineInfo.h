#pragma once

#include <string>

namespace aolib::bench {

/// Where and when figures were taken. Texts are empty where they could not be found out.
struct MachineInfo {
    std::string cpu;
    int cores = 0;      ///< logical
    std::string driver; ///< context, renderer and version of OpenGL
    std::string commit; ///< of the source tree, "-dirty" where files differ from it
    std::string date;   ///< UTC, ISO 8601
};

/// Asks the system. @param driver  what the context says of itself.
MachineInfo describeMachine(const std::string& driver);

} // namespace aolib::bench
