#include "scenes/readers/openscad/hull.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <memory>

#include "core/geometry/polygon.h"
#include "core/geometry/tessellate.h"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace overstrike::openscad {
namespace {

/// A run of Qhull and its memory.
class Qhull {
 public:
  explicit Qhull(const std::vector<Vec3>& points) : sink_(std::fopen("/dev/null", "w"), &close) {
    for (const Vec3& p : points) coordinates_.insert(coordinates_.end(), {p.x, p.y, p.z});
    char options[] = "qhull Qt";
    qh_zero(&qh_, sink_.get());
    failed_ = qh_new_qhull(&qh_, 3, static_cast<int>(points.size()), coordinates_.data(), False,
                           options, sink_.get(), sink_.get()) != 0;
  }
  ~Qhull() {
    qh_freeqhull(&qh_, !qh_ALL);
    int rest = 0, blocks = 0;
    qh_memfreeshort(&qh_, &rest, &blocks);
  }
  Qhull(const Qhull&) = delete;

  bool failed() const { return failed_; }

  /// Point numbers, counter-clockwise seen from outside.
  std::vector<std::array<Index, 3>> triangles() {
    std::vector<std::array<Index, 3>> all;
    qhT* const qh = &qh_;
    facetT* facet = nullptr;
    FORALLfacets {
      std::array<Index, 3> corners{};
      std::size_t n = 0;
      vertexT *vertex = nullptr, **vertexp = nullptr;
      FOREACHvertex_(facet->vertices) {
        if (n < 3) corners[n++] = static_cast<Index>(qh_pointid(qh, vertex->point));
      }
      if (facet->toporient != 0) std::swap(corners[1], corners[2]);
      all.push_back(corners);
    }
    return all;
  }

 private:
  static int close(std::FILE* file) { return std::fclose(file); }

  std::unique_ptr<std::FILE, int (*)(std::FILE*)> sink_;
  std::vector<double> coordinates_;
  qhT qh_;
  bool failed_ = false;
};

double volume(const Polyhedron& p, const std::vector<Vec3>& at) {
  double six = 0;
  for (Index l = 0; l < p.loop_ends.size(); ++l) {
    const auto loop = p.loop(l);
    for (std::size_t i = 2; i < loop.size(); ++i)
      six +=
          glm::dot(at[loop[0]] - at[0], glm::cross(at[loop[i - 1]] - at[0], at[loop[i]] - at[0]));
  }
  return std::fabs(six) / 6;
}

/// Volumes of equal sets, each a sum over many faces, differ by less than this part.
constexpr double kSameVolume = 1e-9;

}  // namespace

std::optional<Polyhedron> hull(const std::vector<Vec3>& points) {
  if (points.size() < 4) return std::nullopt;
  Qhull qhull(points);
  if (qhull.failed()) return std::nullopt;
  Polyhedron p;
  std::map<Index, Index> numbers;
  for (const auto& triangle : qhull.triangles()) {
    Index corners[3];
    for (int i = 0; i < 3; ++i) {
      const auto [at, is_new] = numbers.try_emplace(triangle[static_cast<std::size_t>(i)], 0);
      if (is_new) at->second = p.add_vertex(points[triangle[static_cast<std::size_t>(i)]]);
      corners[i] = at->second;
    }
    p.add_face({corners[0], corners[1], corners[2]});
  }
  return p;
}

std::vector<Vec2> hull(std::vector<Vec2> points) {
  const auto less = [](const Vec2& a, const Vec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  std::sort(points.begin(), points.end(), less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2> chain;
  const auto add = [&](const Vec2& p, std::size_t fewest) {
    while (chain.size() >= fewest && turn_of(chain[chain.size() - 2], chain.back(), p) <= 0)
      chain.pop_back();
    chain.push_back(p);
  };
  for (const Vec2& p : points) add(p, 2);
  const std::size_t lower = chain.size();
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) add(*p, lower + 1);
  chain.pop_back();
  return chain;
}

bool is_convex(const Part& part) {
  const Polyhedron faces = tessellate(*part.shape, 1, false);
  const std::vector<Vec3> corners = corners_of(part);
  const std::optional<Polyhedron> round = hull(corners);
  if (!round) return false;
  const double whole = volume(*round, round->vertices);
  return volume(faces, corners) >= whole * (1 - kSameVolume);
}

bool is_convex(const Region& region) {
  if (region.loops.size() != 1) return false;
  const Loop2 loop = without_repeats(region.loops[0]);
  const int side = is_counter_clockwise(loop) ? 1 : -1;
  for (std::size_t i = 0, n = loop.size(); i < n; ++i)
    if (turn_of(loop[i], loop[(i + 1) % n], loop[(i + 2) % n]) == -side) return false;
  return true;
}

}  // namespace overstrike::openscad
