#pragma once
// The header of a polygon file (Stanford):
//
//   ply
//   format ascii 1.0 | binary_little_endian 1.0 | binary_big_endian 1.0
//   comment ..., obj_info ...
//   element NAME COUNT                     in the order of the file
//   property TYPE NAME                     in the order of the element
//   property list COUNT_TYPE TYPE NAME
//   end_header
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/readers/source_text.h"

namespace overstrike {

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyType {
  std::string_view name, other_name;
  std::size_t size;
  bool real;
  bool has_sign;
};

struct PlyProperty {
  std::string name;
  const PlyType* type = nullptr;
  const PlyType* count_type = nullptr;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  TextMark mark;  ///< of its count

  const PlyProperty* find(std::string_view property) const;
  /// An entry takes at least so many bytes; in text without the end of its line.
  std::uint64_t fewest_bytes(PlyEncoding encoding) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t size = 0;  ///< in bytes

  const PlyElement* find(std::string_view element) const;
};

/// Reads the header at the beginning of `bytes` and checks that it describes faces over vertices
/// and that a file of `size` bytes (0: not known) may hold them. Throws InputError.
PlyHeader read_ply_header(std::string_view bytes, std::uint64_t size, const std::string& name);

}  // namespace overstrike
