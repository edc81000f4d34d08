// Object file format (Geomview).
//
//   OFF                   or COFF, NOFF, STOFF, ... : colours, normals, texture points are not used
//   vertices faces edges  the edges are not needed and often 0; may stand on the first line
//   x y z ...             a vertex a line
//   n a b c ... colour    a face a line: n numbers of vertices, from 0; the colour is not used
//
// Comments begin with #. The 4OFF and nOFF of other dimensions and binary files are refused.
#include "scenes/readers/mesh_readers.h"
#include "scenes/readers/mesh_text.h"

namespace overstrike {
namespace {

// "0 0 0" and its line's end; "3 0 0 0" and its.
constexpr std::uint64_t kFewestVertexBytes = 6;
constexpr std::uint64_t kFewestFaceBytes = 8;

class OffReader {
 public:
  OffReader(std::string_view text, const std::string& name)
      : text_(text, name), left_(text.size()) {
    text_.set_comment('#');
  }

  Mesh read() {
    header();
    if (text_.failed()) text_.reporter().throw_errors();
    for (std::uint64_t i = 0; i < vertices_; ++i) vertex(i);
    for (std::uint64_t i = 0; i < faces_; ++i) face(i);
    text_.reporter().throw_errors();
    weld_vertices(mesh_.polyhedron);
    mesh_.precision = text_.census().precision();
    return std::move(mesh_);
  }

 private:
  static bool is_header(std::string_view word) {
    if (!word.ends_with("OFF")) return false;
    word.remove_suffix(3);
    for (const std::string_view part : {"ST", "C", "N"})
      if (word.starts_with(part)) word.remove_prefix(part.size());
    return word.empty();
  }

  void header() {
    std::string_view word = text_.word_of_any_line();
    if (is_header(word)) {
      word = text_.word_of_any_line();
    } else if (word.empty() || word[0] < '0' || word[0] > '9' || word.ends_with("OFF")) {
      return text_.error(word, "expected 'OFF', found " + found(word));
    }
    if (word == "BINARY") return text_.error(word, "binary OFF files cannot be read");
    vertices_ = count(word, "vertices");
    faces_ = count(text_.word_of_any_line(), "faces");
    text_.skip_line();
  }

  std::uint64_t count(std::string_view word, const std::string& what) {
    const auto number = text_.whole_number(word, "the number of " + what);
    if (!number) return 0;
    const std::uint64_t fewest = what == "faces" ? kFewestFaceBytes : kFewestVertexBytes;
    if (*number <= 0) {
      text_.error(word, "the number of " + what + " must be above 0, found " + found(word));
    } else if (static_cast<std::uint64_t>(*number) > left_ / fewest + 1) {
      text_.error(word, "the file is too short for " +
                            in_thousands(static_cast<std::uint64_t>(*number)) + ' ' + what);
    }
    return static_cast<std::uint64_t>(*number);
  }

  /// The first word of the next line that is not empty.
  std::string_view next(std::uint64_t done, std::uint64_t all, const char* what) {
    while (text_.next_line())
      if (const std::string_view word = text_.word(); !word.empty()) return word;
    text_.error(
        {}, "the file ends after " + in_thousands(done) + " of " + in_thousands(all) + ' ' + what);
    text_.reporter().throw_errors();
    return {};
  }

  void vertex(std::uint64_t i) {
    const std::string_view first = next(i, vertices_, "vertices");
    mesh_.polyhedron.vertices.push_back(text_.point_from(first, "vertex").value_or(Vec3(0)));
  }

  void face(std::uint64_t i) {
    const std::string_view first = next(i, faces_, "faces");
    Polyhedron& p = mesh_.polyhedron;
    const auto corners = text_.whole_number(first, "a face's number of vertices");
    if (!corners) return;
    if (*corners < 3)
      return text_.error(first, "a face needs at least 3 vertices, found " + found(first));
    for (std::int64_t c = 0; c < *corners; ++c) {
      const std::string_view word = text_.word();
      if (word.empty())
        return text_.error(word, "the line ends after " + std::to_string(c) + " of " +
                                     std::to_string(*corners) + " vertices");
      corner(word);
    }
    p.loop_ends.push_back(static_cast<Index>(p.indices.size()));
    p.end_face();
    mesh_.lines.push_back(text_.line());
  }

  void corner(std::string_view word) {
    const auto number = text_.whole_number(word, "the number of a vertex");
    if (number && (*number < 0 || static_cast<std::uint64_t>(*number) >= vertices_))
      text_.error(word, "vertex " + std::string(word) + " does not exist",
                  "there are " + std::to_string(vertices_) + ", numbered from 0");
    mesh_.polyhedron.indices.push_back(static_cast<Index>(number.value_or(0)));
  }

  MeshText text_;
  Mesh mesh_;
  std::uint64_t left_ = 0;
  std::uint64_t vertices_ = 0;
  std::uint64_t faces_ = 0;
};

}  // namespace

Mesh read_off(std::string_view text, const std::string& name, Warnings&) {
  check_text(text, text.size(), name);
  return OffReader(without_bom(text), name).read();
}

}  // namespace overstrike
