#include "core/geometry/cut_polyhedron.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "core/geometry/cap.h"
#include "core/geometry/direction.h"
#include "core/geometry/expansion.h"
#include "core/geometry/plane_fit.h"

namespace overstrike {
namespace {

/// A corner of a cut loop: its vertex and its normal (zero when the polyhedron has none).
struct Corner {
  Index vertex;
  Vec3 normal;
};
/// What is left of a loop between entering the kept side and leaving it.
using Chain = std::vector<Corner>;

Expansion exact_height(const Vec3& p, const Vec3& normal, double offset) {
  Expansion height = -offset;
  for (int i = 0; i < 3; ++i) height = height + Expansion(normal[i]) * Expansion(p[i]);
  return height;
}

class Cutter {
 public:
  Cutter(const Polyhedron& p, const std::vector<double>& heights, const Vec3& normal, double offset)
      : in_(p),
        height_(heights),
        normal_(normal),
        offset_(offset),
        kept_(p.vertices.size(), kCap) {}

  CutPolyhedron cut(bool cap) {
    is_solid_ = cap;
    for (Index f = 0; f < in_.face_count(); ++f) cut_face(f);
    if (cap) add_caps(out_, in_plane_, normal_);
    return std::move(out_);
  }

 private:
  bool inside(Index v) const { return height_[v] >= 0; }
  Vec3 corner_normal(Index corner) const {
    return in_.corner_normals.empty() ? Vec3(0.0) : in_.corner_normals[corner];
  }

  Index add_vertex(const Vec3& p, Index low, Index high, bool in_plane) {
    out_.origin.push_back({low, high});
    in_plane_.push_back(in_plane);
    return out_.polyhedron.add_vertex(p);
  }
  Index keep(Index v) {
    if (kept_[v] == kCap) kept_[v] = add_vertex(in_.vertices[v], v, v, height_[v] == 0);
    return kept_[v];
  }

  /// The part t of the way. An end is rounded by its own last place, and so is what doubles find:
  /// where that is more than a few of the new vertex's it is found exactly; and where the edge lies
  /// so flatly in the plane that rounding of heights moves the vertex by more than 2^10 times that.
  Vec3 point_between(Index low, Index high, double t) const {
    constexpr double kFew = 4, kFlat = 0x1p-9;
    const Vec3 &from = in_.vertices[low], &to = in_.vertices[high];
    const Vec3 rough = from + (to - from) * t;
    const double rise = std::fabs(height_[low] - height_[high]);
    if (std::max(max_norm(from), max_norm(to)) <= kFew * max_norm(rough) &&
        rise >= kFlat * max_norm(to - from))
      return rough;
    const Expansion above = exact_height(from, normal_, offset_),
                    below = -exact_height(to, normal_, offset_);
    if (above.sign() * below.sign() <= 0) return rough;  // one lies in the plane but for rounding
    const double whole = (above + below).approximate();
    Vec3 at;
    for (int i = 0; i < 3; ++i)
      at[i] = (above * Expansion(to[i]) + below * Expansion(from[i])).approximate() / whole;
    return at;
  }

  /// Where the edge of corners i (vertex a) and j (vertex b) meets the plane.
  Corner crossing(Index i, Index j) {
    const Index a = in_.indices[i], b = in_.indices[j];
    if (height_[a] == 0) return {keep(a), corner_normal(i)};
    if (height_[b] == 0) return {keep(b), corner_normal(j)};
    const Index low = std::min(a, b), high = std::max(a, b);
    const double t = height_[low] / (height_[low] - height_[high]);
    const std::uint64_t key = std::uint64_t{low} << 32 | high;
    const auto [it, fresh] = crossings_.try_emplace(key, 0);
    if (fresh) it->second = add_vertex(point_between(low, high, t), low, high, true);
    const Vec3 low_normal = corner_normal(a == low ? i : j);
    const Vec3 high_normal = corner_normal(a == low ? j : i);
    return {it->second, low_normal + (high_normal - low_normal) * t};
  }

  void cut_face(Index f) {
    std::vector<Chain> chains, whole;
    for (Index l = in_.first_loop(f); l < in_.face_ends[f]; ++l) cut_loop(l, chains, whole);
    if (!chains.empty()) join(f, chains, whole);
    bool any = false;
    for (const Chain& loop : whole) any = add_loop(loop) || any;
    if (any && !gone(f, whole)) {
      out_.polyhedron.end_face();
      out_.face_source.push_back(f);
    } else if (any) {
      drop_open_face();
    }
  }

  /// In the plane, with the solid on the side that is taken away.
  bool gone(Index f, const std::vector<Chain>& loops) const {
    if (!is_solid_) return false;
    for (const Chain& loop : loops)
      for (const Corner& c : loop)
        if (!in_plane_[c.vertex]) return false;
    return glm::dot(fit_plane(in_, f).normal, normal_) > 0;
  }
  void drop_open_face() {
    Polyhedron& p = out_.polyhedron;
    p.loop_ends.resize(p.face_ends.empty() ? 0 : p.face_ends.back());
    p.indices.resize(p.loop_ends.empty() ? 0 : p.loop_ends.back());
    if (!p.corner_normals.empty()) p.corner_normals.resize(p.indices.size());
  }

  void cut_loop(Index l, std::vector<Chain>& chains, std::vector<Chain>& whole) {
    const Index first = in_.first_index(l), end = in_.loop_ends[l];
    const auto next = [&](Index i) { return i + 1 == end ? first : i + 1; };
    Index start = first;  // the first corner inside after one outside
    bool crosses = false, any_inside = false;
    for (Index i = first; i < end; ++i) {
      any_inside = any_inside || inside(in_.indices[i]);
      if (!crosses && !inside(in_.indices[i]) && inside(in_.indices[next(i)])) {
        crosses = true;
        start = next(i);
      }
    }
    if (!any_inside) return;
    Chain chain;
    Index i = start, previous = start == first ? end - 1 : start - 1;
    do {
      if (inside(in_.indices[i])) {
        if (crosses && !inside(in_.indices[previous])) chain.push_back(crossing(previous, i));
        push(chain, {keep(in_.indices[i]), corner_normal(i)});
        if (crosses && !inside(in_.indices[next(i)])) {
          push(chain, crossing(i, next(i)));
          chains.push_back(std::move(chain));
          chain.clear();
        }
      }
      previous = i;
      i = next(i);
    } while (i != start);
    if (!crosses) whole.push_back(std::move(chain));
  }

  static void push(Chain& chain, const Corner& c) {
    if (chain.empty() || chain.back().vertex != c.vertex) chain.push_back(c);
  }

  /// Closes chains along the plane. Along normal x outward the boundary leaves and enters the kept
  /// side in turn, so that the i-th leaving is followed by the i-th entering.
  void join(Index f, const std::vector<Chain>& chains, std::vector<Chain>& whole) {
    const Vec3 along = glm::cross(normal_, fit_plane(in_, f).normal);
    const auto place = [&](const Corner& c) {
      return glm::dot(along, out_.polyhedron.vertices[c.vertex]);
    };
    std::vector<std::size_t> leaving(chains.size()), entering(chains.size()), next(chains.size());
    std::iota(leaving.begin(), leaving.end(), 0);
    std::iota(entering.begin(), entering.end(), 0);
    std::stable_sort(leaving.begin(), leaving.end(), [&](std::size_t a, std::size_t b) {
      return place(chains[a].back()) < place(chains[b].back());
    });
    std::stable_sort(entering.begin(), entering.end(), [&](std::size_t a, std::size_t b) {
      return place(chains[a].front()) < place(chains[b].front());
    });
    for (std::size_t i = 0; i < chains.size(); ++i) next[leaving[i]] = entering[i];
    std::vector<bool> used(chains.size(), false);
    for (std::size_t i = 0; i < chains.size(); ++i) {
      Chain loop;
      for (std::size_t k = i; !used[k]; k = next[k]) {
        used[k] = true;
        for (const Corner& c : chains[k]) push(loop, c);
      }
      if (!loop.empty()) whole.push_back(std::move(loop));
    }
  }

  /// False when the loop has no area to enclose.
  bool add_loop(Chain loop) {
    while (loop.size() > 1 && loop.back().vertex == loop.front().vertex) loop.pop_back();
    if (loop.size() < 3) return false;
    std::vector<Index> vertices;
    for (const Corner& c : loop) {
      vertices.push_back(c.vertex);
      if (!in_.corner_normals.empty()) out_.polyhedron.corner_normals.push_back(c.normal);
    }
    out_.polyhedron.add_loop(vertices);
    return true;
  }

  const Polyhedron& in_;
  const std::vector<double>& height_;
  const Vec3 normal_;
  const double offset_;
  bool is_solid_ = false;
  std::vector<Index> kept_;  ///< new number of an old vertex, or kCap
  std::unordered_map<std::uint64_t, Index> crossings_;
  std::vector<bool> in_plane_;
  CutPolyhedron out_;
};

}  // namespace

CutPolyhedron cut_polyhedron(const Polyhedron& polyhedron, const std::vector<double>& heights,
                             const Vec3& normal, double offset, bool cap) {
  return Cutter(polyhedron, heights, normal, offset).cut(cap);
}

CutPolyhedron cut_polyhedron(const Polyhedron& polyhedron, const Vec3& normal, double offset,
                             bool cap) {
  std::vector<double> heights;
  heights.reserve(polyhedron.vertices.size());
  for (const Vec3& v : polyhedron.vertices) heights.push_back(glm::dot(normal, v) - offset);
  return cut_polyhedron(polyhedron, heights, normal, offset, cap);
}

}  // namespace overstrike
