// Stereolithography files: triangles, as text or as floats.
//
//   solid name                                        header, 80 bytes
//     facet normal nx ny nz                           triangles, u32
//       outer loop                                    per triangle: normal, 3 vertices (12 floats),
//         vertex x y z   (three times)                  2 bytes; all little endian
//       endloop
//     endfacet
//   endsolid name
//
// Binary headers may begin with "solid", too: a file is binary if its size is what its count says,
// or if its beginning is no text. Normals are not used: the order of vertices says it all.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "scenes/readers/mesh_readers.h"
#include "scenes/readers/mesh_text.h"

namespace overstrike {
namespace {

constexpr std::size_t kHeader = 80;
constexpr std::size_t kStart = 84;
constexpr std::size_t kTriangle = 50;
constexpr std::size_t kNormal = 12;
constexpr std::size_t kLook = 4096;  // so much tells text from floats
constexpr std::uint64_t kMostTriangles = kMostCorners / 3;

static_assert(std::endian::native == std::endian::little, "floats are copied as they are");

std::uint32_t triangle_count(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeader, sizeof count);
  return count;
}

std::uint64_t bytes_of(std::uint64_t triangles) { return kStart + kTriangle * triangles; }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same_word(std::string_view a, std::string_view b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) { return lower(x) == y; });
}

bool begins_as_text(std::string_view head) {
  MeshText text(without_bom(head), {});
  return same_word(text.word_of_any_line(), "solid");
}

/// Counts of triangles below 2^24 hold a zero byte, as do most floats.
bool is_text(std::string_view bytes) { return bytes.find('\0') == std::string_view::npos; }

/// `size` of 0 is not known.
bool is_binary(std::string_view head, std::uint64_t size) {
  if (head.size() >= kStart && size == bytes_of(triangle_count(head))) return true;
  return !begins_as_text(head) || !is_text(head.substr(0, kLook));
}

[[noreturn]] void fail_as_neither(std::uint64_t size, const std::string& name) {
  if (size == 0) fail_mesh(name, "the file is empty", "expected an STL mesh");
  fail_mesh(name, "is no STL file: text begins with 'solid', and binary files have a header of " +
                      std::to_string(kStart) + " bytes, found " + in_thousands(size));
}

void check_binary(std::string_view head, std::uint64_t size, const std::string& name) {
  if (head.size() < kStart) fail_as_neither(head.size(), name);
  const std::uint64_t count = triangle_count(head);
  if (is_text(head.substr(0, kLook)))
    fail_mesh(name, "is no STL file: it is text, but does not begin with 'solid'");
  if (count == 0)
    fail_mesh(name, "byte 80: the binary STL file has 0 triangles", "expected at least one");
  if (size > 0 && size < bytes_of(count))
    fail_mesh(name,
              "ends after " + in_thousands((size - kStart) / kTriangle) + " of " +
                  in_thousands(count) + " triangles",
              "byte 80 counts the triangles of this binary STL file");
  if (count > kMostTriangles)
    fail_mesh(name, "byte 80: has " + in_thousands(count) + " triangles",
              "at most " + in_thousands(kMostTriangles) + " can be read");
}

[[noreturn]] void fail_as_number(std::size_t triangle, std::size_t part, float value,
                                 const std::string& name) {
  constexpr const char* kVertices[] = {"first", "second", "third"};
  const std::size_t byte = bytes_of(triangle) + kNormal + part * sizeof(float);
  fail_mesh(name, "byte " + std::to_string(byte) + ": " + "xyz"[part % 3] + " of the " +
                      kVertices[part / 3] + " vertex of triangle " + std::to_string(triangle) +
                      " must be a finite number, found " +
                      (std::isnan(value) ? "NaN"
                       : value > 0       ? "infinity"
                                         : "-infinity"));
}

/// Appends the triangle's three corners.
void add_triangle(std::string_view bytes, std::size_t triangle, Mesh& mesh, Welder& welder,
                  const std::string& name) {
  float parts[9];
  std::memcpy(parts, bytes.data() + bytes_of(triangle) + kNormal, sizeof parts);
  for (std::size_t i = 0; i < 9; ++i)
    if (!std::isfinite(parts[i])) fail_as_number(triangle, i, parts[i], name);
  Polyhedron& p = mesh.polyhedron;
  for (std::size_t i = 0; i < 9; i += 3)
    p.indices.push_back(welder.add({parts[i] + 0.0, parts[i + 1] + 0.0, parts[i + 2] + 0.0}));
  p.loop_ends.push_back(static_cast<Index>(p.indices.size()));
  p.end_face();
}

Mesh read_binary(std::string_view bytes, const std::string& name, Warnings& warnings) {
  check_binary(bytes, bytes.size(), name);
  const std::size_t count = triangle_count(bytes);
  Mesh mesh;
  mesh.polyhedron.indices.reserve(3 * count);
  mesh.polyhedron.loop_ends.reserve(count);
  mesh.polyhedron.face_ends.reserve(count);
  Welder welder(count / 2);  // as in a closed mesh (Euler)
  for (std::size_t i = 0; i < count; ++i) add_triangle(bytes, i, mesh, welder, name);
  mesh.polyhedron.vertices = welder.take_points();
  mesh.precision = float_precision(mesh.polyhedron);
  if (const std::size_t rest = bytes.size() - bytes_of(count); rest > 0)
    warn_of_mesh(warnings, name,
                 "byte " + std::to_string(bytes_of(count)) + ": " + in_thousands(rest) +
                     " bytes after the last triangle are left out");
  return mesh;
}

class AsciiReader {
 public:
  AsciiReader(std::string_view text, const std::string& name)
      : text_(text, name), welder_(text.size() / kBytesPerVertex) {}

  Mesh read() {
    expect("solid");
    text_.skip_line();
    while (true) {
      const std::string_view word = text_.word_of_any_line();
      if (same_word(word, "facet")) {
        facet();
      } else if (same_word(word, "endsolid")) {
        text_.skip_line();
        if (!next_solid()) break;
      } else if (!unexpected(word)) {
        break;
      }
    }
    return finished();
  }

 private:
  // Rather too many: it only guesses how much memory is needed.
  static constexpr std::size_t kBytesPerVertex = 400;

  bool expect(std::string_view keyword) {
    const std::string_view word = text_.word_of_any_line();
    if (same_word(word, keyword)) return true;
    if (word.empty()) {
      text_.error(word, "the file ends within triangle " + std::to_string(count()) + ": expected " +
                            in_quotes(keyword));
      text_.reporter().throw_errors();
    }
    text_.error(word, "expected " + in_quotes(keyword) + ", found " + found(word));
    return false;
  }

  std::size_t count() const { return mesh_.polyhedron.face_count(); }

  /// After an error: goes on with the next facet.
  void skip_facet() {
    while (true) {
      const std::string_view word = text_.word_of_any_line();
      if (word.empty() || same_word(word, "endfacet")) return;
    }
  }

  void facet() {
    const int line = text_.line();
    Vec3 corners[3];
    if (!expect("normal")) return skip_facet();
    for (int i = 0; i < 3; ++i) text_.word();  // not used, and often nonsense
    if (!expect("outer") || !expect("loop")) return skip_facet();
    for (Vec3& corner : corners) {
      if (!expect("vertex")) return skip_facet();
      const std::optional<Vec3> p = text_.point("vertex");
      if (!p) return skip_facet();
      corner = *p;
    }
    if (!expect("endloop") || !expect("endfacet")) return skip_facet();
    const Index a = welder_.add(corners[0]), b = welder_.add(corners[1]);
    mesh_.polyhedron.add_face({a, b, welder_.add(corners[2])});
    mesh_.lines.push_back(line);
  }

  /// Another solid may follow.
  bool next_solid() {
    const std::string_view word = text_.word_of_any_line();
    if (word.empty()) return false;
    if (!same_word(word, "solid"))
      text_.error(word, "expected 'solid' or the end of the file, found " + found(word));
    text_.skip_line();
    return true;
  }

  /// False at the end of the file.
  bool unexpected(std::string_view word) {
    text_.error(word, "expected 'facet' or 'endsolid', found " +
                          (word.empty() ? "the end of the file after " + in_thousands(count()) +
                                              (count() == 1 ? " triangle" : " triangles")
                                        : found(word)));
    text_.skip_line();
    return !word.empty();
  }

  Mesh finished() {
    if (!text_.failed() && count() == 0) text_.error({}, "the mesh has no triangles");
    text_.reporter().throw_errors();
    mesh_.polyhedron.vertices = welder_.take_points();
    mesh_.precision = text_.census().precision();
    return std::move(mesh_);
  }

  MeshText text_;
  Welder welder_;
  Mesh mesh_;
};

}  // namespace

void check_stl(std::string_view head, std::uint64_t size, const std::string& name) {
  if (is_binary(head, size)) check_binary(head, size, name);
}

Mesh read_stl(std::string_view bytes, const std::string& name, Warnings& warnings) {
  if (is_binary(bytes, bytes.size())) return read_binary(bytes, name, warnings);
  check_text(bytes, bytes.size(), name);
  return AsciiReader(without_bom(bytes), name).read();
}

}  // namespace overstrike
