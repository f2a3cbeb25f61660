#pragma once

namespace aolib::app {

/// While it lives, Ctrl-C (SIGINT, and SIGTERM) no longer ends the program at once but is
/// remembered, so that work can stop where nothing is left half done; a second one ends it.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    static bool happened();
};

} // namespace aolib::app
