#pragma once
// Mesh files written by tests.
#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "core/geometry/polyhedron.h"
#include "scenes/readers/mesh.h"

namespace overstrike::mesh_tests {

/// The bytes of a value, least significant first; most significant first if `big`.
template <class T>
std::string bytes_of(T value, bool big = false) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return big ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

/// Nine floats a triangle.
inline std::string binary_stl(const std::vector<float>& corners, std::uint32_t count,
                              const std::string& header = "made by a test") {
  std::string bytes = header;
  bytes.resize(80, ' ');
  bytes += bytes_of(count);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i % 9 == 0) bytes += std::string(12, '\0');
    bytes += bytes_of(corners[i]);
    if (i % 9 == 8) bytes += std::string(2, '\0');
  }
  return bytes;
}

/// "0,0,0 1,0,0 0,1,0 | 0 1 2": vertices, then faces; with lines "| 0 1 2 @7".
inline std::string dump(const Mesh& mesh) {
  std::string text;
  const Polyhedron& p = mesh.polyhedron;
  for (const Vec3& v : p.vertices)
    text += fmt::format("{}{},{},{}", text.empty() ? "" : " ", v.x, v.y, v.z);
  for (Index f = 0; f < p.face_count(); ++f) {
    text += fmt::format(" | {}", fmt::join(p.loop(p.first_loop(f)), " "));
    if (!mesh.lines.empty()) text += fmt::format(" @{}", mesh.lines[f]);
  }
  return text;
}

/// What a file holds, or what is wrong with it; then its warnings.
inline std::string outcome(const std::string& text, const std::string& format) {
  std::vector<Diagnostic> warnings;
  std::string result;
  try {
    result = dump(read_mesh_text(text, format, "m." + format, warnings));
  } catch (const InputError& e) {
    result = e.what();
  }
  for (const Diagnostic& d : warnings) result += '\n' + to_string(d);
  return result;
}

struct Case {
  const char* name;
  std::string text;
  std::string outcome;
};

}  // namespace overstrike::mesh_tests
