#include <aolib/AbstractTexelTracer.h>

namespace aolib {

// Here, so that the class's table of virtual functions lives in one library.
AbstractTexelTracer::~AbstractTexelTracer() = default;

} // namespace aolib
