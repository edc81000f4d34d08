#include "core/geometry/repair.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <string_view>
#include <tuple>

#include "core/geometry/direction.h"
#include "core/geometry/face_list.h"
#include "core/geometry/orient.h"
#include "core/geometry/plane_fit.h"
#include "core/geometry/split_face.h"

namespace overstrike {
namespace {

/// A vertex written out in decimals, or computed by a few operations elsewhere, is this many units
/// of 2^-53 of the largest coordinate from where it was meant.
constexpr double kWrittenRoundings = 16;

/// Names at most so many faces or edges in one sentence.
constexpr std::size_t kNamed = 3;

std::string joined(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) text += part;
  return text;
}
/// The shortest decimals that read back as the same number.
std::string to_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value + 0.0).ptr};
}
std::string to_text(const Vec3& p) {
  return joined({"(", to_text(p.x), ", ", to_text(p.y), ", ", to_text(p.z), ")"});
}
/// Three digits.
std::string roughly(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 3).ptr};
}

class Repairer {
 public:
  Repairer(const Polyhedron& in, const RepairOptions& options, std::vector<std::string>& flaws)
      : p_(in), options_(options), flaws_(flaws), number_(in.face_count()) {
    std::iota(number_.begin(), number_.end(), Index{0});
    double largest = 0;
    for (const Vec3& v : in.vertices) largest = std::fmax(largest, max_norm(v));
    error_ = kWrittenRoundings * 0x1p-53 * largest + std::sqrt(3.0) * options.precision;
  }

  Repaired run() {
    merge_vertices();
    drop_degenerate();
    drop_copies();
    name_crossing();
    split_unplanar();
    if (!options_.open) name_open_edges(orient());
    compact();
    const bool crosses = std::find(crossing_.begin(), crossing_.end(), true) != crossing_.end();
    return {std::move(p_), crosses};
  }

 private:
  std::string name(Index face) const {
    const Index number = number_[face];
    if (options_.lines.empty()) return std::to_string(number);
    return joined({std::to_string(number), " (line ", std::to_string(options_.lines[number]), ")"});
  }
  /// "face 3", "faces 3 and 5", "faces 3, 5, 7 and 12 more"
  std::string names(const std::vector<Index>& faces) const {
    if (faces.size() == 1) return joined({"face ", name(faces[0])});
    std::string text = joined({"faces ", name(faces[0])});
    const bool cut = faces.size() > kNamed;
    const std::size_t shown = cut ? kNamed : faces.size() - 1;
    for (std::size_t i = 1; i < shown; ++i) text += joined({", ", name(faces[i])});
    return text + " and " +
           (cut ? std::to_string(faces.size() - kNamed) + " more" : name(faces.back()));
  }
  /// One sentence: the faces, then one of two endings.
  void tell(const std::vector<Index>& faces, const char* one, const char* many) {
    if (!faces.empty()) flaws_.push_back(names(faces) + (faces.size() == 1 ? one : many));
  }

  void merge_vertices() {
    std::vector<Index> order(p_.vertices.size()), first(p_.vertices.size());
    std::iota(order.begin(), order.end(), Index{0});
    const auto key = [&](Index i) {
      const Vec3& v = p_.vertices[i];
      return std::tuple(v.x, v.y, v.z);
    };
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
    for (std::size_t i = 0; i < order.size(); ++i)
      first[order[i]] =
          i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
    for (Index& v : p_.indices) v = first[v];
  }

  /// Keeps the faces that `keep` says; face numbers follow.
  template <class Keep>
  void filter(Keep keep) {
    Polyhedron out;
    std::vector<Index> number;
    for (Index f = 0; f < p_.face_count(); ++f) {
      if (!keep(f)) continue;
      append_face(out, p_, f, false);
      number.push_back(number_[f]);
    }
    out.vertices = std::move(p_.vertices);
    p_ = std::move(out);
    number_ = std::move(number);
  }

  bool repeats(Index l) const {
    const std::span<const Index> loop = p_.loop(l);
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (loop[i] == loop[i + 1 == loop.size() ? 0 : i + 1]) return true;
    return loop.size() < 3;
  }

  /// Takes repeated vertices out of loops, and loops of fewer than three out of faces.
  void drop_repeats() {
    Polyhedron out;
    for (Index f = 0; f < p_.face_count(); ++f) {
      for (Index l = p_.first_loop(f); l < p_.face_ends[f]; ++l) {
        std::vector<Index> corners;
        for (Index i = p_.first_index(l); i < p_.loop_ends[l]; ++i)
          if (corners.empty() || p_.indices[corners.back()] != p_.indices[i]) corners.push_back(i);
        while (corners.size() > 1 && p_.indices[corners.back()] == p_.indices[corners.front()])
          corners.pop_back();
        if (corners.size() < 3) continue;
        for (const Index i : corners) {
          out.indices.push_back(p_.indices[i]);
          if (!p_.corner_normals.empty()) out.corner_normals.push_back(p_.corner_normals[i]);
        }
        out.loop_ends.push_back(static_cast<Index>(out.indices.size()));
      }
      out.end_face();
    }
    out.plane_groups = std::move(p_.plane_groups);
    out.vertices = std::move(p_.vertices);
    p_ = std::move(out);
  }

  /// Parts that cancel are areas where the outline crosses itself, and none where it comes back the
  /// way it went.
  bool has_area(Index f) const {
    const PlaneFit fit = fit_plane(p_, f);
    return fit.area > 0 && (!fit.cancels || crosses_itself(loops_of(f), fit.normal));
  }

  void drop_degenerate() {
    bool repeated = false;
    for (Index l = 0; l < p_.loop_ends.size() && !repeated; ++l) repeated = repeats(l);
    if (repeated) drop_repeats();
    std::vector<Index> few, flat;
    std::vector<bool> bad(p_.face_count(), false);
    for (Index f = 0; f < p_.face_count(); ++f) {
      if (p_.first_loop(f) == p_.face_ends[f]) {
        few.push_back(f), bad[f] = true;
      } else if (!has_area(f)) {
        flat.push_back(f), bad[f] = true;
      }
    }
    tell(few, " has fewer than three different vertices: left out",
         " have fewer than three different vertices: left out");
    tell(flat, " has no area: left out", " have no area: left out");
    if (!few.empty() || !flat.empty()) filter([&](Index f) { return !bad[f]; });
  }

  /// The outline from its lowest vertex on: equal for copies wherever they start.
  std::vector<Index> cycle(Index f) const {
    const std::span<const Index> loop = p_.loop(p_.first_loop(f));
    std::vector<Index> turned(loop.begin(), loop.end());
    std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
    return turned;
  }
  void drop_copies() {
    std::vector<std::pair<std::uint64_t, Index>> order;
    for (Index f = 0; f < p_.face_count(); ++f) {
      std::uint64_t sum = p_.face_ends[f] - p_.first_loop(f);
      for (const Index v : p_.loop(p_.first_loop(f))) {
        const std::uint64_t mixed = (v + 1) * 0x9E3779B97F4A7C15u;
        sum += mixed ^ mixed >> 29;
      }
      order.emplace_back(sum, f);
    }
    std::sort(order.begin(), order.end());
    std::vector<Index> copies;
    for (std::size_t i = 0, end; i < order.size(); i = end) {
      for (end = i + 1; end < order.size() && order[end].first == order[i].first;) ++end;
      if (end - i == 1) continue;
      std::vector<std::vector<Index>> seen;
      for (std::size_t k = i; k < end; ++k) {
        std::vector<Index> now = cycle(order[k].second);
        if (std::find(seen.begin(), seen.end(), now) != seen.end())
          copies.push_back(order[k].second);
        else
          seen.push_back(std::move(now));
      }
    }
    if (copies.empty()) return;
    std::sort(copies.begin(), copies.end());
    tell(copies, " is a copy of another: left out", " are copies of others: left out");
    filter([&](Index f) { return !std::binary_search(copies.begin(), copies.end(), f); });
  }

  void take_loops(Index f, std::vector<std::vector<Vec3>>& loops) const {
    const Index first = p_.first_loop(f);
    loops.resize(p_.face_ends[f] - first);
    for (std::size_t l = 0; l < loops.size(); ++l) {
      loops[l].clear();
      for (const Index v : p_.loop(first + static_cast<Index>(l)))
        loops[l].push_back(p_.vertices[v]);
    }
  }
  std::vector<std::vector<Vec3>> loops_of(Index f) const {
    std::vector<std::vector<Vec3>> loops;
    take_loops(f, loops);
    return loops;
  }
  bool is_triangle(Index f) const {
    return p_.face_ends[f] - p_.first_loop(f) == 1 && p_.loop(p_.first_loop(f)).size() == 3;
  }

  void name_crossing() {
    crossing_.assign(p_.face_count(), false), off_.assign(p_.face_count(), 0);
    std::vector<std::vector<Vec3>> loops;
    std::vector<Index> faces;
    for (Index f = 0; f < p_.face_count(); ++f) {
      if (is_triangle(f)) continue;
      const PlaneFit fit = fit_plane(p_, f);
      off_[f] = unplanar(f, fit);
      if (off_[f] > 0) continue;
      take_loops(f, loops);
      if (!crosses_itself(loops, fit.normal)) continue;
      crossing_[f] = true;
      faces.push_back(f);
    }
    tell(faces, " crosses itself: drawn by the even-odd rule",
         " cross themselves: drawn by the even-odd rule");
  }

  /// How far the face's vertices are off its plane, beyond what their rounding and the turn of the
  /// plane that it allows explain; 0 when it explains all.
  double unplanar(Index f, const PlaneFit& fit) const {
    double off = 0;
    bool explained = true;
    for (Index i = p_.first_index(p_.first_loop(f)); i < p_.loop_ends[p_.face_ends[f] - 1]; ++i) {
      const Vec3 away = p_.vertices[p_.indices[i]] - fit.middle;
      const double distance = std::fabs(glm::dot(fit.normal, away));
      const double allowed = 2 * error_ + fit.tilt(error_) * std::sqrt(glm::dot(away, away));
      off = std::fmax(off, distance);
      explained = explained && distance <= allowed;
    }
    return explained ? 0 : off;
  }

  void split_unplanar() {
    std::vector<Index> faces;
    std::vector<bool> split(p_.face_count(), false);
    double worst = 0;
    for (Index f = 0; f < p_.face_count(); ++f) {
      if (!(off_[f] > 0)) continue;
      split[f] = true;
      faces.push_back(f);
      worst = std::fmax(worst, off_[f]);
    }
    if (faces.empty()) return;
    flaws_.push_back(joined({names(faces), faces.size() == 1 ? " is" : " are",
                             " not planar (a vertex is ", roughly(worst), " off): split"}));
    Polyhedron out;
    std::vector<Index> number;
    for (Index f = 0; f < p_.face_count(); ++f) {
      if (split[f])
        append_triangles(out, f);
      else
        append_face(out, p_, f, false);
      number.resize(out.face_count(), number_[f]);
    }
    out.plane_groups.clear();
    out.vertices = std::move(p_.vertices);
    p_ = std::move(out);
    number_ = std::move(number);
  }

  void append_triangles(Polyhedron& out, Index f) const {
    const Vec3 normal = fit_plane(p_, f).normal;
    const Index first = p_.first_index(p_.first_loop(f));
    const std::vector<Index> corners = bridged(loops_of(f), normal);
    std::vector<Vec3> points;
    for (const Index c : corners) points.push_back(p_.vertices[p_.indices[first + c]]);
    for (const auto& triangle : triangles_of(points, normal)) {
      for (const Index k : triangle) {
        out.indices.push_back(p_.indices[first + corners[k]]);
        if (!p_.corner_normals.empty())
          out.corner_normals.push_back(p_.corner_normals[first + corners[k]]);
      }
      out.loop_ends.push_back(static_cast<Index>(out.indices.size()));
      out.end_face();
    }
  }

  void turn(const std::vector<bool>& reversed) {
    Polyhedron out;
    for (Index f = 0; f < p_.face_count(); ++f) append_face(out, p_, f, reversed[f]);
    out.vertices = std::move(p_.vertices);
    p_ = std::move(out);
  }

  /// The result: the edges as they are then.
  std::vector<EdgePair> orient() {
    std::vector<EdgePair> edges = pair_edges(p_);
    const Orientation found = consistent_orientation(p_, edges);
    if (found.one_sided) flaws_.push_back("its faces have no consistent inside and outside");
    if (!found.turn.empty() && !found.one_sided) {
      std::vector<Index> faces;
      for (Index f = 0; f < found.turn.size(); ++f)
        if (found.turn[f]) faces.push_back(f);
      tell(faces, " looks the other way than its neighbours: turned",
           " look the other way than their neighbours: turned");
      turn(found.turn);
      edges = pair_edges(p_);
    }
    const std::vector<bool> reversed = inside_out(p_, edges);
    if (reversed.empty()) return edges;
    const std::size_t count = std::count(reversed.begin(), reversed.end(), true);
    flaws_.push_back(count == reversed.size() ? "inside out: turned"
                                              : joined({"a part of ", std::to_string(count),
                                                        " faces is inside out: turned"}));
    turn(reversed);
    return pair_edges(p_);
  }

  void name_open_edges(const std::vector<EdgePair>& edges) {
    std::size_t count = 0;
    std::string named;
    for (const EdgePair& e : edges) {
      if (e.right != kNoFace) continue;
      if (++count <= kNamed)
        named += joined({count > 1 ? ", " : "", to_text(p_.vertices[e.from]), " to ",
                         to_text(p_.vertices[e.to])});
    }
    if (count == 0) return;
    flaws_.push_back(
        joined({"open: ", std::to_string(count), count == 1 ? " edge has" : " edges have",
                " one face only: ", named, count > kNamed ? ", ..." : ""}));
  }

  /// Vertices of no face go, the others keep their order.
  void compact() {
    std::vector<Index> number(p_.vertices.size(), 0);
    for (const Index v : p_.indices) number[v] = 1;
    std::vector<Vec3> kept;
    for (std::size_t v = 0; v < number.size(); ++v) {
      if (number[v] == 0) continue;
      number[v] = static_cast<Index>(kept.size());
      kept.push_back(p_.vertices[v]);
    }
    for (Index& v : p_.indices) v = number[v];
    p_.vertices = std::move(kept);
  }

  Polyhedron p_;
  const RepairOptions& options_;
  std::vector<std::string>& flaws_;
  std::vector<Index> number_;  ///< per face, the input's
  std::vector<bool> crossing_;
  std::vector<double> off_;  ///< per face: how far its vertices are off its plane, as unplanar()
  double error_ = 0;
};

}  // namespace

Repaired repaired(const Polyhedron& polyhedron, const RepairOptions& options,
                  std::vector<std::string>& flaws) {
  return Repairer(polyhedron, options, flaws).run();
}

}  // namespace overstrike
