#include "tests/bench/run_ends.h"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <limits>

#include "tests/oracle/random.h"

namespace overstrike::bench {
namespace {

using Exact = mpq_class;
using Four = std::array<Exact, 4>;

Exact dot(const Four& a, const Four& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}
Four row_of(const Mat4& m, int row) { return {m[0][row], m[1][row], m[2][row], m[3][row]}; }
Four point(const Vec3& p) { return {p.x, p.y, p.z, 1}; }
Four covector(const Plane& p) { return {p.normal.x, p.normal.y, p.normal.z, -p.offset}; }

/// The point on three planes, homogeneous; all 0 when they have more than one.
Four meet(const Four& a, const Four& b, const Four& c) {
  const auto minor = [&](int i, int j, int k) -> Exact {
    return a[i] * (b[j] * c[k] - b[k] * c[j]) - a[j] * (b[i] * c[k] - b[k] * c[i]) +
           a[k] * (b[i] * c[j] - b[j] * c[i]);
  };
  return {minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)};
}

/// A scan line, as the plane of all that is seen on it.
class Line {
 public:
  Line(const Prepared& prepared, double y)
      : canonical_(*prepared.canonical),
        x_(row_of(prepared.view.matrix, 0)),
        w_(row_of(prepared.view.matrix, 2)),
        plane_(row_of(prepared.view.matrix, 1)) {
    for (int i = 0; i < 4; ++i) plane_[i] -= Exact(y) * w_[i];
  }

  /// The distance of x from the nearest place where the faces (or one and kNone) can part.
  double error(double x, Index left, Index right) const {
    std::vector<Exact> places;
    for (const Index face : {left, right})
      if (face != kNone) add_edges(face, places);
    if (left != kNone && right != kNone) add(meet(plane_, plane_of(left), plane_of(right)), places);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Exact& place : places)
      nearest = std::min(nearest, Exact(abs(place - Exact(x))).get_d());
    return nearest;
  }

 private:
  Four plane_of(Index face) const {
    return covector(canonical_.planes[canonical_.faces[face].plane]);
  }
  void add(const Four& p, std::vector<Exact>& places) const {
    const Exact w = dot(w_, p);
    if (w != 0) places.push_back(dot(x_, p) / w);
  }
  void add_edges(Index face, std::vector<Exact>& places) const {
    const CanonicalFace& f = canonical_.faces[face];
    for (Index l = f.first_loop; l < f.end_loop; ++l) {
      const std::span<const Index> loop = canonical_.loop(l);
      for (std::size_t i = 0; i < loop.size(); ++i)
        add_edge(canonical_.vertices[loop[i]], canonical_.vertices[loop[(i + 1) % loop.size()]],
                 places);
    }
  }
  void add_edge(const Vec3& from, const Vec3& to, std::vector<Exact>& places) const {
    const Four a = point(from), b = point(to);
    const Exact above = dot(plane_, a), below = dot(plane_, b);
    if (above == 0) add(a, places);
    if (sgn(above) * sgn(below) >= 0) return;
    Four crossing;
    for (int i = 0; i < 4; ++i) crossing[i] = b[i] * above - a[i] * below;
    add(crossing, places);
  }

  const Canonical& canonical_;
  Four x_, w_, plane_;
};

/// Where the face on the left of x gives way to the one on the right.
struct End {
  int row;
  double x;
  Index left, right;
};

std::vector<End> ends_of(int row, const std::vector<DensityRun>& runs, double columns) {
  std::vector<End> ends;
  const auto add = [&](double x, Index left, Index right) {
    if (x > 0 && x < columns) ends.push_back({row, x, left, right});
  };
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const bool joined = i > 0 && runs[i - 1].x1 == runs[i].x0;
    add(runs[i].x0, joined ? runs[i - 1].surface : kNone, runs[i].surface);
    if (i + 1 == runs.size() || runs[i + 1].x0 != runs[i].x1)
      add(runs[i].x1, runs[i].surface, kNone);
  }
  return ends;
}

}  // namespace

double worst_run_end(const Prepared& prepared, const std::vector<int>& rows,
                     const std::vector<std::vector<DensityRun>>& runs) {
  std::vector<End> ends;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<End> more = ends_of(rows[i], runs[i], prepared.view.grid.columns);
    ends.insert(ends.end(), more.begin(), more.end());
  }
  oracle::Random random(3);
  double worst = 0;
  for (int i = 0; i < kMostEnds && !ends.empty(); ++i) {
    const End& end = ends[static_cast<std::size_t>(random.in(0, double(ends.size())))];
    const Line line(prepared, end.row + 0.5);
    worst = std::max(worst, line.error(end.x, end.left, end.right));
  }
  return worst;
}

}  // namespace overstrike::bench
