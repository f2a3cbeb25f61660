// Lets a header compile as GLSL and as C++ (glm): the tests call the very functions that shaders run.
// Opens the namespace in C++; AO_SHARED_END closes it.
#ifdef __cplusplus
#include <glm/glm.hpp>
#define AO_FUNCTION inline
#define AO_SHARED_END }
namespace aolib::shared {
using namespace glm; // the GLSL names are the point
#else
#define AO_FUNCTION
#define AO_SHARED_END
#endif
