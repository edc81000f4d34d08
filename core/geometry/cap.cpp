#include "core/geometry/cap.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "core/geometry/winding_layers.h"

namespace overstrike {
namespace {

/// Edges in the plane that have a face on one side only, turned round.
std::vector<DirectedEdge> edges_to_close(const Polyhedron& p, const std::vector<bool>& in_plane) {
  std::vector<DirectedEdge> edges;
  for (Index l = 0; l < p.loop_ends.size(); ++l) {
    const std::span<const Index> loop = p.loop(l);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index a = loop[i], b = loop[i + 1 == loop.size() ? 0 : i + 1];
      if (in_plane[a] && in_plane[b]) edges.push_back({a, b});
    }
  }
  const auto key = [](const DirectedEdge& e) { return std::minmax({e.from, e.to}); };
  std::stable_sort(edges.begin(), edges.end(),
                   [&](const DirectedEdge& a, const DirectedEdge& b) { return key(a) < key(b); });
  std::vector<DirectedEdge> open;
  for (std::size_t i = 0, end; i < edges.size(); i = end) {
    int balance = 0;
    for (end = i; end < edges.size() && key(edges[end]) == key(edges[i]); ++end)
      balance += edges[end].from < edges[end].to ? 1 : -1;
    const auto [low, high] = key(edges[i]);
    for (; balance > 0; --balance) open.push_back({high, low});
    for (; balance < 0; ++balance) open.push_back({low, high});
  }
  return open;
}

/// The points of the cut alone, which the layers count from 0.
struct CutPoints {
  std::vector<Vec3> points;
  std::vector<Index> vertex;  ///< per point
  std::vector<DirectedEdge> edges;

  CutPoints(const Polyhedron& p, const std::vector<DirectedEdge>& open) {
    for (const DirectedEdge& e : open) vertex.push_back(e.from), vertex.push_back(e.to);
    std::sort(vertex.begin(), vertex.end());
    vertex.erase(std::unique(vertex.begin(), vertex.end()), vertex.end());
    for (const Index v : vertex) points.push_back(p.vertices[v]);
    for (const DirectedEdge& e : open) edges.push_back({number(e.from), number(e.to)});
  }

 private:
  Index number(Index v) const {
    return static_cast<Index>(std::lower_bound(vertex.begin(), vertex.end(), v) - vertex.begin());
  }
};

/// Rewrites the faces of a polyhedron whose edges have been divided.
class Divider {
 public:
  explicit Divider(CutPolyhedron& cut) : cut_(cut) {
    same_.resize(cut.polyhedron.vertices.size());
    std::iota(same_.begin(), same_.end(), 0);
  }

  /// The edge from a to b passes `path`, its ends included.
  void divide(Index a, Index b, std::vector<Index> path) {
    any_ = any_ || path.size() > 2 || path.front() != a || path.back() != b;
    same_[a] = path.front(), same_[b] = path.back();
    if (path.size() == 2) return;
    if (a > b) std::reverse(path.begin(), path.end());
    paths_[std::minmax({a, b})] = std::move(path);
  }

  void rewrite() {
    if (!any_) return;
    const Polyhedron old = std::move(cut_.polyhedron);
    const std::vector<Index> sources = std::move(cut_.face_source);
    Polyhedron& p = cut_.polyhedron;
    p = {}, cut_.face_source.clear();
    p.vertices = old.vertices;
    for (Index f = 0; f < old.face_count(); ++f) {
      const std::size_t before = p.loop_ends.size();
      for (Index l = old.first_loop(f); l < old.face_ends[f]; ++l) rewrite(old, l);
      if (p.loop_ends.size() == before) continue;
      p.end_face();
      cut_.face_source.push_back(sources[f]);
    }
  }

 private:
  void rewrite(const Polyhedron& old, Index l) {
    loop_.clear(), normals_.clear();
    const Index first = old.first_index(l), end = old.loop_ends[l];
    for (Index i = first; i < end; ++i) add_side(old, i, i + 1 == end ? first : i + 1);
    while (loop_.size() > 1 && loop_.back() == loop_.front()) loop_.pop_back();
    if (loop_.size() < 3) return;
    cut_.polyhedron.add_loop(loop_);
    if (old.corner_normals.empty()) return;
    normals_.resize(loop_.size());
    auto& all = cut_.polyhedron.corner_normals;
    all.insert(all.end(), normals_.begin(), normals_.end());
  }

  /// All points of the side but its last.
  void add_side(const Polyhedron& old, Index i, Index j) {
    const Index a = old.indices[i], b = old.indices[j];
    const bool smooth = !old.corner_normals.empty();
    add(same_[a], smooth ? old.corner_normals[i] : Vec3(0.0));
    const auto it = paths_.find(std::minmax({a, b}));
    if (it == paths_.end()) return;
    const std::vector<Index>& path = it->second;
    const Vec3 from = old.vertices[a], along = old.vertices[b] - from;
    for (std::size_t k = 1; k + 1 < path.size(); ++k) {
      const Index v = path[a < b ? k : path.size() - 1 - k];
      const double t = glm::dot(old.vertices[v] - from, along) / glm::dot(along, along);
      const Vec3 normal =
          smooth ? old.corner_normals[i] * (1 - t) + old.corner_normals[j] * t : Vec3(0.0);
      add(v, normal);
    }
  }
  void add(Index v, const Vec3& normal) {
    if (!loop_.empty() && loop_.back() == v) return;
    loop_.push_back(v), normals_.push_back(normal);
  }

  CutPolyhedron& cut_;
  bool any_ = false;
  std::vector<Index> same_;
  std::map<std::pair<Index, Index>, std::vector<Index>> paths_;  ///< from the lower end
  std::vector<Index> loop_;
  std::vector<Vec3> normals_;
};

}  // namespace

void add_caps(CutPolyhedron& cut, const std::vector<bool>& in_plane, const Vec3& normal) {
  Polyhedron& p = cut.polyhedron;
  const bool smooth = !p.corner_normals.empty();
  CutPoints at(p, edges_to_close(p, in_plane));
  WindingLayers found = winding_layers(at.points, at.edges, FlatAxes(-normal));
  for (std::size_t i = at.points.size(); i < found.points.size(); ++i) {
    at.vertex.push_back(p.add_vertex(found.points[i]));
    cut.origin.push_back({kCap, kCap});
  }
  const auto to_vertices = [&](std::vector<Index>& points) {
    for (Index& v : points) v = at.vertex[v];
  };
  Divider divider(cut);
  for (std::size_t e = 0; e < at.edges.size(); ++e) {
    to_vertices(found.paths[e]);
    divider.divide(at.vertex[at.edges[e].from], at.vertex[at.edges[e].to],
                   std::move(found.paths[e]));
  }
  divider.rewrite();
  for (WindingLayers::Layer& layer : found.layers) {
    for (std::vector<Index>& loop : layer.loops) {
      to_vertices(loop);
      p.add_loop(loop);
      if (smooth) p.corner_normals.insert(p.corner_normals.end(), loop.size(), -normal);
    }
    p.end_face();
    cut.face_source.push_back(layer.winding > 0 ? kCap : kTurnedCap);
  }
}

}  // namespace overstrike
