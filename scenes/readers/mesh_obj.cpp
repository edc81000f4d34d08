// Wavefront objects. Read are
//
//   v x y z ...           a vertex; what follows (weight, colour) is not used
//   vn x y z              a normal
//   f a a/t a/t/n a//n    a face: numbers of vertices, texture points and normals, from 1, or
//                         backwards from the last one given so far: -1
//
// Comments begin with #; a line that ends with \ goes on. Groups, materials, texture points, lines
// and curves are left out. A face may name vertices that come later.
#include <algorithm>
#include <array>

#include "scenes/readers/mesh_readers.h"
#include "scenes/readers/mesh_text.h"
#include "scenes/readers/nearest.h"

namespace overstrike {
namespace {

constexpr std::string_view kLeftOut[] = {
    "vt",     "vp",     "p",          "l",         "curv",  "curv2",  "surf",     "cstype",   "deg",
    "bmat",   "step",   "parm",       "trim",      "hole",  "scrv",   "sp",       "end",      "con",
    "g",      "s",      "mg",         "o",         "bevel", "usemtl", "c_interp", "d_interp", "lod",
    "mtllib", "usemap", "shadow_obj", "trace_obj", "ctech", "stech",  "maplib",   "call",     "csh",
    "res",    "bsp",    "bzp",        "cdc",       "cdp",   "fo"};
constexpr std::string_view kKnown[] = {"v", "vn", "f", "vt", "usemtl", "mtllib"};
constexpr std::size_t kMostWarnings = 5;

bool is_left_out(std::string_view keyword) {
  return std::find(std::begin(kLeftOut), std::end(kLeftOut), keyword) != std::end(kLeftOut);
}

/// A number of a vertex or a normal that is not there yet.
struct Later {
  TextMark mark;
  std::int64_t number;
};

/// The normal of a corner; kNone: it has none.
constexpr Index kNone = 0xFFFF'FFFF;

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& name) : text_(text, name) {
    text_.set_comment('#');
    text_.join_lines();
  }

  Mesh read(Warnings& warnings) {
    while (text_.next_line())
      if (const std::string_view keyword = text_.word(); !keyword.empty()) statement(keyword);
    check_later(vertices_later_, mesh_.polyhedron.vertices.size(), "vertex", "vertices");
    check_later(normals_later_, normals_.size(), "normal", "normals");
    if (!text_.failed() && mesh_.polyhedron.face_count() == 0)
      text_.error({}, "the file ends without a face ('f')");
    text_.reporter().throw_errors();
    for (const Diagnostic& d : text_.reporter().warnings()) warnings.push_back(d);
    add_normals();
    weld_vertices(mesh_.polyhedron);
    mesh_.precision = text_.census().precision();
    return std::move(mesh_);
  }

 private:
  void statement(std::string_view keyword) {
    if (keyword == "v") {
      mesh_.polyhedron.vertices.push_back(text_.point("vertex").value_or(Vec3(0)));
    } else if (keyword == "vn") {
      normals_.push_back(normal());
    } else if (keyword == "f") {
      face();
    } else if (!is_left_out(keyword)) {
      unknown(keyword);
    }
  }

  Vec3 normal() {
    Vec3 n{0};
    for (int i = 0; i < 3; ++i)
      n[i] = text_.number(text_.word(), std::string("normal's ") + "xyz"[i]).value_or(0);
    return n;
  }

  void unknown(std::string_view keyword) {
    if (std::find(unknown_.begin(), unknown_.end(), keyword) != unknown_.end()) return;
    if (unknown_.size() == kMostWarnings) return;
    unknown_.push_back(keyword);
    text_.warning(keyword, "unknown statement " + found(keyword) + " is left out",
                  did_you_mean(keyword, kKnown));
  }

  void face() {
    const TextMark start = text_.mark({});
    std::size_t corners = 0;
    for (std::string_view word = text_.word(); !word.empty(); word = text_.word(), ++corners)
      corner(word);
    Polyhedron& p = mesh_.polyhedron;
    if (corners < 3)
      text_.error_at(start, "a face needs at least 3 vertices, found " + std::to_string(corners));
    p.loop_ends.push_back(static_cast<Index>(p.indices.size()));
    p.end_face();
    mesh_.lines.push_back(start.line);
  }

  /// Splits a/t/n.
  static std::array<std::string_view, 3> parts_of(std::string_view word) {
    std::array<std::string_view, 3> parts;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t slash = i < 2 ? std::min(word.find('/'), word.size()) : word.size();
      parts[i] = word.substr(0, slash);
      word.remove_prefix(std::min(slash + 1, word.size()));
    }
    return parts;
  }

  void corner(std::string_view word) {
    const auto [vertex, texture, normal] = parts_of(word);
    mesh_.polyhedron.indices.push_back(number(vertex.empty() ? word : vertex,
                                              mesh_.polyhedron.vertices.size(), "vertex",
                                              vertices_later_));
    if (!texture.empty()) text_.whole_number(texture, "the number of a texture point");
    corner_normals_.push_back(
        normal.empty() ? kNone : number(normal, normals_.size(), "normal", normals_later_));
    all_have_normals_ = all_have_normals_ && !normal.empty();
  }

  /// From 0.
  Index number(std::string_view word, std::size_t count, const char* what,
               std::vector<Later>& later) {
    const auto given = text_.whole_number(word, std::string("the number of a ") + what);
    if (!given) return 0;
    if (*given < 0 && *given >= -static_cast<std::int64_t>(count))
      return static_cast<Index>(static_cast<std::int64_t>(count) + *given);
    if (*given > 0 && *given <= static_cast<std::int64_t>(count))
      return static_cast<Index>(*given - 1);
    if (*given > 0 && *given < static_cast<std::int64_t>(kMostCorners)) {
      later.push_back({text_.mark(word), *given});
      return static_cast<Index>(*given - 1);
    }
    text_.error(
        word, std::string(what) + ' ' + std::string(word) + " does not exist",
        *given == 0 ? "they are numbered from 1" : "so far there are " + std::to_string(count));
    return 0;
  }

  void check_later(const std::vector<Later>& later, std::size_t count, const std::string& one,
                   const std::string& many) {
    for (const Later& l : later)
      if (l.number > static_cast<std::int64_t>(count))
        text_.error_at(l.mark, one + ' ' + std::to_string(l.number) + " does not exist",
                       "there are " + std::to_string(count) + ' ' + many + ", numbered from 1");
  }

  /// If every corner has one.
  void add_normals() {
    if (!all_have_normals_) return;
    std::vector<Vec3> normals;
    normals.reserve(corner_normals_.size());
    for (const Index n : corner_normals_) {
      const double length = glm::length(normals_[n]);
      if (!(length > 0) || !std::isfinite(length)) return;
      normals.push_back(normals_[n] / length);
    }
    mesh_.polyhedron.corner_normals = std::move(normals);
  }

  MeshText text_;
  Mesh mesh_;
  std::vector<Vec3> normals_;
  std::vector<Index> corner_normals_;  ///< one a corner
  bool all_have_normals_ = true;
  std::vector<Later> vertices_later_, normals_later_;
  std::vector<std::string_view> unknown_;
};

}  // namespace

Mesh read_obj(std::string_view text, const std::string& name, Warnings& warnings) {
  check_text(text, text.size(), name);
  return ObjReader(without_bom(text), name).read(warnings);
}

}  // namespace overstrike
