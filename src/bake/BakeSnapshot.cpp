#include <aolib/bake/BakeSnapshot.h>

namespace aolib::bake {

BakeSnapshot::~BakeSnapshot() = default;

} // namespace aolib::bake
