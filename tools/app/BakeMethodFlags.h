#pragma once

namespace CLI {
class App;
} // namespace CLI

namespace aolib::app {

struct BakeFlags;

/// Adds the flags that only one method of baking reads. `flags` must outlive the command.
void attachBakeMethods(BakeFlags& flags, CLI::App& command);

} // namespace aolib::app
