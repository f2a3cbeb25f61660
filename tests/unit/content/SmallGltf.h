#pragma once

#include <initializer_list>
#include <string>

namespace aolib::test {

/// Packs JSON text and bytes into a GLB.
std::string packGlb(std::string json, std::string binary);

/// Little-endian bytes of floats and 16-bit indices.
std::string floatBytes(std::initializer_list<float> values);
std::string shortBytes(std::initializer_list<unsigned short> values);

/// The binary chunk of quadJson(): four corners of a unit square in z = 0, four normals +z, and
/// the indices of its two triangles.
std::string quadBytes();

/// JSON for quadBytes(). The parts in capitals are replaced: NODES (the list of nodes, node 0 is
/// the scene's only root) and EXTRA (further members, each with a comma before it).
std::string quadJson(const std::string& nodes = R"([{"mesh":0}])", const std::string& extra = "");

/// The two together.
std::string quadGlb(const std::string& nodes = R"([{"mesh":0}])", const std::string& extra = "");

/// `text` with the first `from` replaced; fails the test where there is none.
std::string replaced(std::string text, const std::string& from, const std::string& to);

} // namespace aolib::test
