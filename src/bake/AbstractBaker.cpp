#include <aolib/bake/AbstractBaker.h>

namespace aolib::bake {

AbstractBaker::~AbstractBaker() = default;

} // namespace aolib::bake
