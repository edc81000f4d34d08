// Polygon files (Stanford): x, y, z and nx, ny, nz of "vertex" and the list vertex_indices (or
// vertex_index) of "face" are used; whatever else there is is read over. In text an entry has a
// line; in binary files everything stands without gaps.
#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "scenes/readers/mesh_readers.h"
#include "scenes/readers/mesh_text.h"
#include "scenes/readers/ply_header.h"

namespace overstrike {
namespace {

/// What a property is to us.
enum class Role { none, x, y, z, nx, ny, nz, corners };

constexpr std::string_view kVertexRoles[] = {"x", "y", "z", "nx", "ny", "nz"};

Role role_of(const PlyElement& element, const PlyProperty& property) {
  if (element.name == "face")
    return property.name == "vertex_indices" || property.name == "vertex_index" ? Role::corners
                                                                                : Role::none;
  if (element.name != "vertex" || property.count_type) return Role::none;
  const auto* const found_name =
      std::find(std::begin(kVertexRoles), std::end(kVertexRoles), property.name);
  if (found_name == std::end(kVertexRoles)) return Role::none;
  return static_cast<Role>(1 + (found_name - kVertexRoles));
}

bool is_coordinate(Role role) { return role >= Role::x && role <= Role::z; }

std::string ended(std::uint64_t done, const PlyElement& e) {
  return "the file ends after " + in_thousands(done) + " of " + in_thousands(e.count) +
         " entries of '" + e.name + "'";
}

/// Entries as lines of text.
class TextEntries {
 public:
  TextEntries(std::string_view bytes, std::size_t header, const std::string& name)
      : text_(bytes, name) {
    while (text_.offset_of_next_line() < header) text_.next_line();
  }
  void begin(std::uint64_t number, const PlyElement& element) {
    word_ = {};
    while (word_.empty()) {
      if (!text_.next_line()) {
        text_.error({}, ended(number, element));
        text_.reporter().throw_errors();
      }
      word_ = text_.word();
    }
    first_ = true;
  }
  double coordinate(const PlyProperty& property) {
    return text_.coordinate(next(), "vertex's " + property.name).value_or(0);
  }
  double normal(const PlyProperty&) {
    double value = 0;
    const std::string_view word = next();
    std::from_chars(word.data(), word.data() + word.size(), value);
    return value;
  }
  std::int64_t whole(const PlyType&, const char* what) {
    return text_.whole_number(next(), what).value_or(0);
  }
  /// That many values follow.
  bool has(std::uint64_t, const PlyType&) { return true; }
  void skip(std::uint64_t count, const PlyType&) {
    for (std::uint64_t i = 0; i < count && !next().empty(); ++i) {
    }
  }
  int line() const { return text_.line(); }
  bool at_end() const { return last_.empty(); }
  void error(const std::string& message, const std::string& hint = {}) {
    text_.error(last_, message, hint);
  }
  double precision() const { return text_.census().precision(); }
  void finish() { text_.reporter().throw_errors(); }

 private:
  std::string_view next() {
    last_ = first_ ? word_ : text_.word();
    first_ = false;
    return last_;
  }

  MeshText text_;
  std::string_view word_, last_;
  bool first_ = false;
};

/// Entries in binary; `kSwap`: of the other byte order.
template <bool kSwap>
class BinaryEntries {
 public:
  BinaryEntries(std::string_view bytes, std::size_t header, const std::string& name)
      : bytes_(bytes), at_(header), name_(name) {}
  void begin(std::uint64_t number, const PlyElement& element) {
    number_ = number;
    element_ = &element;
  }
  double coordinate(const PlyProperty& property) {
    const double value = real(*property.type);
    if (!(std::fabs(value) <= kLargestCoordinate)) fail_as_coordinate(property, value);
    if (property.type->real && property.type->size == sizeof(float))
      largest_float_ = std::max(largest_float_, std::fabs(value));
    return value;
  }
  double normal(const PlyProperty& property) { return real(*property.type); }
  std::int64_t whole(const PlyType& type, const char*) {
    switch (type.size) {
      case 1:
        return type.has_sign ? take<std::int8_t>() : take<std::uint8_t>();
      case 2:
        return type.has_sign ? take<std::int16_t>() : take<std::uint16_t>();
      default:
        return type.has_sign ? take<std::int32_t>() : std::int64_t{take<std::uint32_t>()};
    }
  }
  bool has(std::uint64_t count, const PlyType& type) {
    if (count > (bytes_.size() - at_) / type.size) fail_mesh(name_, ended(number_, *element_));
    return true;
  }
  void skip(std::uint64_t count, const PlyType& type) {
    has(count, type);
    at_ += count * type.size;
  }
  int line() const { return 0; }
  bool at_end() const { return false; }
  void error(const std::string& message, const std::string& hint = {}) {
    fail_mesh(name_, "byte " + std::to_string(last_) + ": " + message, hint);
  }
  double precision() const { return float_precision(largest_float_); }
  void finish() const {}

 private:
  template <class T>
  T take() {
    if (sizeof(T) > bytes_.size() - at_) fail_mesh(name_, ended(number_, *element_));
    char raw[sizeof(T)];
    std::memcpy(raw, bytes_.data() + at_, sizeof raw);
    if constexpr (kSwap) std::reverse(raw, raw + sizeof raw);
    T value;
    std::memcpy(&value, raw, sizeof value);
    last_ = at_;
    at_ += sizeof value;
    return value;
  }
  double real(const PlyType& type) {
    if (!type.real) return static_cast<double>(whole(type, ""));
    return type.size == sizeof(float) ? static_cast<double>(take<float>()) : take<double>();
  }
  void fail_as_coordinate(const PlyProperty& property, double value) {
    const char* const what = std::isnan(value)      ? "NaN"
                             : std::isfinite(value) ? "more than 1e+100"
                             : value > 0            ? "infinity"
                                                    : "-infinity";
    error(property.name + " of vertex " + std::to_string(number_) +
          " must be a finite number, found " + what);
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
  std::size_t last_ = 0;  ///< where the last value began
  std::string name_;
  std::uint64_t number_ = 0;
  const PlyElement* element_ = nullptr;
  double largest_float_ = 0;
};

template <class Entries>
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, Entries entries)
      : header_(header), in_(std::move(entries)), vertices_(header.find("vertex")->count) {}

  Mesh read() {
    for (const PlyElement& e : header_.elements) element(e);
    in_.finish();
    Polyhedron& p = mesh_.polyhedron;
    add_normals();
    weld_vertices(p);
    mesh_.precision = in_.precision();
    return std::move(mesh_);
  }

 private:
  void element(const PlyElement& e) {
    std::vector<Role> roles;
    for (const PlyProperty& p : e.properties) roles.push_back(role_of(e, p));
    const bool first_of_its_name = header_.find(e.name) == &e;
    if (!first_of_its_name) std::fill(roles.begin(), roles.end(), Role::none);
    const bool normals = e.find("nx") && e.find("ny") && e.find("nz");
    for (std::uint64_t i = 0; i < e.count; ++i) {
      in_.begin(i, e);
      entry(e, roles);
      if (e.name != "vertex" || !first_of_its_name) continue;
      mesh_.polyhedron.vertices.push_back(Vec3(values_[0], values_[1], values_[2]) + 0.0);
      if (normals) normals_.emplace_back(values_[3], values_[4], values_[5]);
    }
  }

  void entry(const PlyElement& e, const std::vector<Role>& roles) {
    for (std::size_t i = 0; i < roles.size(); ++i) {
      const PlyProperty& p = e.properties[i];
      const Role role = roles[i];
      if (p.count_type) {
        list(p, role);
      } else if (is_coordinate(role)) {
        value(role) = in_.coordinate(p);
      } else if (role != Role::none) {
        value(role) = in_.normal(p);
      } else {
        in_.skip(1, *p.type);
      }
    }
  }

  double& value(Role role) { return values_[static_cast<std::size_t>(role) - 1]; }

  void list(const PlyProperty& p, Role role) {
    const std::int64_t count = in_.whole(*p.count_type, "the length of a list");
    if (count < 0)
      return in_.error("the length of a list must not be negative, found " + std::to_string(count));
    if (role != Role::corners) return in_.skip(static_cast<std::uint64_t>(count), *p.type);
    if (count < 3)
      return in_.error("a face needs at least 3 vertices, found " + std::to_string(count));
    in_.has(static_cast<std::uint64_t>(count), *p.type);
    for (std::int64_t i = 0; i < count && !in_.at_end(); ++i) corner(p);
    Polyhedron& polyhedron = mesh_.polyhedron;
    polyhedron.loop_ends.push_back(static_cast<Index>(polyhedron.indices.size()));
    polyhedron.end_face();
    if (in_.line() > 0) mesh_.lines.push_back(in_.line());
  }

  void corner(const PlyProperty& p) {
    const std::int64_t number = in_.whole(*p.type, "the number of a vertex");
    if (number < 0 || static_cast<std::uint64_t>(number) >= vertices_)
      in_.error("vertex " + std::to_string(number) + " does not exist",
                "there are " + in_thousands(vertices_) + ", numbered from 0");
    mesh_.polyhedron.indices.push_back(static_cast<Index>(number));
  }

  /// If every vertex that a face uses has one.
  void add_normals() {
    if (normals_.empty()) return;
    std::vector<Vec3> normals;
    for (const Index v : mesh_.polyhedron.indices) {
      const double length = glm::length(normals_[v]);
      if (!(length > 0) || !std::isfinite(length)) return;
      normals.push_back(normals_[v] / length);
    }
    mesh_.polyhedron.corner_normals = std::move(normals);
  }

  const PlyHeader& header_;
  Entries in_;
  std::uint64_t vertices_;
  Mesh mesh_;
  double values_[6] = {};
  std::vector<Vec3> normals_;
};

}  // namespace

void check_ply(std::string_view head, std::uint64_t size, const std::string& name) {
  read_ply_header(head, size, name);
}

Mesh read_ply(std::string_view bytes, const std::string& name, Warnings&) {
  static_assert(std::endian::native == std::endian::little);
  const PlyHeader header = read_ply_header(bytes, bytes.size(), name);
  switch (header.encoding) {
    case PlyEncoding::little_endian:
      return PlyReader(header, BinaryEntries<false>(bytes, header.size, name)).read();
    case PlyEncoding::big_endian:
      return PlyReader(header, BinaryEntries<true>(bytes, header.size, name)).read();
    case PlyEncoding::ascii:
      break;
  }
  check_text(bytes, bytes.size(), name);
  return PlyReader(header, TextEntries(bytes, header.size, name)).read();
}

}  // namespace overstrike
