#include "core/visibility/strokes.h"

#include <algorithm>

#include "core/visibility/depth.h"

namespace overstrike {
namespace {

using Intervals = std::vector<std::pair<double, double>>;

/// Visible parts of edges, each compared with every face.
class EdgeResolver {
 public:
  EdgeResolver(const Canonical& canonical, const View& view)
      : c_(canonical), depths_(canonical.planes, view), side_(canonical.faces.size()) {
    for (Index f = 0; f < c_.faces.size(); ++f)
      side_[f] = side_of_eye(c_.planes[c_.faces[f].plane], c_.faces[f].flipped, view.eye);
    for (const Vec3& p : c_.vertices) points_.push_back(view.project(p));
  }

  bool seen(Index face) const {
    return face != kNone &&
           (side_[face] > 0 || (side_[face] < 0 && !c_.bodies[c_.faces[face].body].closed));
  }
  const Vec3& point(Index vertex) const { return points_[vertex]; }

  /// Parts of the edge, 0..1 from a to b, that no face hides.
  Intervals visible(const WingedEdge& e) const {
    Intervals hidden;
    for (Index f = 0; f < c_.faces.size(); ++f)
      if (seen(f) && !shares_plane(f, e)) hide(points_[e.from], points_[e.to], f, hidden);
    std::sort(hidden.begin(), hidden.end());
    Intervals result;
    double at = 0;
    for (const auto& [low, high] : hidden) {
      if (low > at) result.emplace_back(at, low);
      at = std::max(at, high);
    }
    if (at < 1) result.emplace_back(at, 1.0);
    return result;
  }

 private:
  bool shares_plane(Index f, const WingedEdge& e) const {
    return c_.faces[f].plane == c_.faces[e.left].plane ||
           (e.right != kNone && c_.faces[f].plane == c_.faces[e.right].plane);
  }
  void hide(const Vec3& a, const Vec3& b, Index face, Intervals& hidden) const;

  const Canonical& c_;
  DepthField depths_;
  std::vector<int> side_;
  std::vector<Vec3> points_;
};

void EdgeResolver::hide(const Vec3& a, const Vec3& b, Index face, Intervals& hidden) const {
  const CanonicalFace& f = c_.faces[face];
  const Vec2 origin(a), along = Vec2(b) - origin;
  std::vector<double> crossings;
  for (Index l = f.first_loop; l < f.end_loop; ++l) {
    const std::span<const Index> loop = c_.loop(l);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 p = Vec2(points_[loop[i]]) - origin,
                 q = Vec2(points_[loop[(i + 1) % loop.size()]]) - origin;
      const double sp = along.x * p.y - along.y * p.x, sq = along.x * q.y - along.y * q.x;
      if ((sp < 0) == (sq < 0)) continue;
      crossings.push_back(glm::dot(along, p + (q - p) * (sp / (sp - sq))) / glm::dot(along, along));
    }
  }
  std::sort(crossings.begin(), crossings.end());
  const DepthPlane& d = depths_[f.plane];
  const double da = d.at(a.x, a.y) - a.z, db = d.at(b.x, b.y) - b.z;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    double low = std::max(crossings[i], 0.0), high = std::min(crossings[i + 1], 1.0);
    const double through = da / (da - db);
    if (da <= 0 && db <= 0) continue;
    if (da > 0 && db < 0) high = std::min(high, through);
    if (da < 0 && db > 0) low = std::max(low, through);
    if (low < high) hidden.emplace_back(low, high);
  }
}

}  // namespace

std::vector<Stroke> visible_strokes(const Canonical& seen, const View& view,
                                    const std::vector<Shadow>&, const StrokeOptions& options,
                                    double) {
  const EdgeResolver resolver(seen, view);
  std::vector<Stroke> strokes;
  for (const WingedEdge& e : seen.edges) {
    const bool left = resolver.seen(e.left), right = resolver.seen(e.right);
    const bool contour = left != right;
    if (!(contour ? options.contours : left && e.crease && options.creases)) continue;
    const Vec2 a(resolver.point(e.from)), b(resolver.point(e.to));
    for (const auto& [low, high] : resolver.visible(e)) {
      const CanonicalBody& body = seen.bodies[seen.faces[e.left].body];
      strokes.push_back({{a + (b - a) * low, a + (b - a) * high},
                         contour ? StrokeKind::contour : StrokeKind::crease,
                         seen.faces[e.left].body,
                         body.pen,
                         false});
    }
  }
  return strokes;
}

}  // namespace overstrike
