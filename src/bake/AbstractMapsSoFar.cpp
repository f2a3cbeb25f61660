#include <aolib/bake/AbstractMapsSoFar.h>

namespace aolib::bake {

AbstractMapsSoFar::~AbstractMapsSoFar() = default;

} // namespace aolib::bake
