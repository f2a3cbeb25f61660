/// The one place that compiles tinygltf. It neither opens files nor decodes images here: see the
/// definitions in this folder's CMakeLists.txt.
#include <fstream>

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
