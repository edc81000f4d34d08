#include "core/geometry/orient.h"

#include <algorithm>
#include <numeric>

#include "core/geometry/plane_fit.h"

namespace overstrike {
namespace {

/// Union-find over faces that keeps whether a face looks the other way than its root.
class Shells {
 public:
  explicit Shells(std::size_t faces) : parent_(faces), other_(faces, 0) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }
  Index root(Index i) {
    Index top = i;
    char parity = 0;
    for (; parent_[top] != top; top = parent_[top]) parity ^= other_[top];
    while (parent_[i] != i) {
      const Index next = parent_[i];
      const char rest = static_cast<char>(parity ^ other_[i]);
      parent_[i] = top, other_[i] = parity, parity = rest;
      i = next;
    }
    return top;
  }
  /// Whether the face looks the other way than its root.
  bool other(Index i) { return root(i) != i && other_[i] != 0; }
  /// False when the two are joined already and otherwise than said.
  bool join(Index a, Index b, bool opposite) {
    const bool differ = (other(a) != other(b)) != opposite;
    const Index ra = root(a), rb = root(b);
    if (ra == rb) return !differ;
    parent_[std::max(ra, rb)] = std::min(ra, rb);
    other_[std::max(ra, rb)] = differ ? 1 : 0;
    return true;
  }

 private:
  std::vector<Index> parent_;
  std::vector<char> other_;
};

struct Shell {
  double volume = 0;
  bool closed = true;
  Vec3 low{1e300}, high{-1e300};
  Vec3 base{0.0};
  bool within(const Shell& s) const {
    return glm::all(glm::greaterThanEqual(low, s.low)) &&
           glm::all(glm::lessThanEqual(high, s.high));
  }
};

/// Six times the volume between the base and the face, holes taken off by their orientation.
double cone_volume(const Polyhedron& p, Index face, const Vec3& base) {
  double volume = 0;
  for (Index l = p.first_loop(face); l < p.face_ends[face]; ++l) {
    const std::span<const Index> loop = p.loop(l);
    const Vec3 a = p.vertices[loop[0]] - base;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
      volume += glm::dot(a, glm::cross(p.vertices[loop[i]] - base, p.vertices[loop[i + 1]] - base));
  }
  return volume;
}

/// More comparisons of bounds than this are not worth the seconds: such shells stay as they are.
constexpr std::size_t kMostComparisons = 50'000'000;

/// Everything when the whole has its inside outside, else the shells that are no cavities.
std::vector<bool> turned_shells(const Polyhedron& p, Shells& faces,
                                const std::vector<Shell>& shells, const std::vector<Index>& roots) {
  double whole = 0;
  std::vector<Index> wrong;
  for (const Index r : roots) {
    if (!shells[r].closed) continue;
    whole += shells[r].volume;
    if (shells[r].volume < 0) wrong.push_back(r);
  }
  if (wrong.empty()) return {};
  std::vector<bool> turned(p.face_count(), false);
  if (whole < 0) {
    for (Index f = 0; f < p.face_count(); ++f) turned[f] = shells[faces.root(f)].closed;
    return turned;
  }
  if (wrong.size() * roots.size() > kMostComparisons) return {};
  bool any = false;
  for (const Index r : wrong) {
    turned[r] = std::none_of(roots.begin(), roots.end(), [&](Index other) {
      return other != r && shells[other].closed && shells[r].within(shells[other]);
    });
    any = any || turned[r];
  }
  if (!any) return {};
  for (Index f = 0; f < p.face_count(); ++f) turned[f] = turned[faces.root(f)];
  return turned;
}

}  // namespace

Orientation consistent_orientation(const Polyhedron& p, const std::vector<EdgePair>& edges) {
  Orientation result;
  Shells shells(p.face_count());
  bool any = false;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const EdgePair& e = edges[i];
    if (e.right != kNoFace) {
      if (!shells.join(e.left, e.right, false)) result.one_sided = true;
    } else if (i + 1 < edges.size() && edges[i + 1].right == kNoFace &&
               edges[i + 1].from == e.from && edges[i + 1].to == e.to) {
      any = true;
      if (!shells.join(e.left, edges[++i].left, true)) result.one_sided = true;
    }
  }
  if (!any) return result;
  std::vector<double> balance(p.face_count(), 0);  // area that looks as the root minus the rest
  for (Index f = 0; f < p.face_count(); ++f)
    balance[shells.root(f)] += fit_plane(p, f).area * (shells.other(f) ? -1 : 1);
  result.turn.resize(p.face_count());
  for (Index f = 0; f < p.face_count(); ++f)
    result.turn[f] = shells.other(f) != (balance[shells.root(f)] < 0);
  return result;
}

std::vector<bool> inside_out(const Polyhedron& p, const std::vector<EdgePair>& edges) {
  Shells faces(p.face_count());
  for (const EdgePair& e : edges)
    if (e.right != kNoFace) faces.join(e.left, e.right, false);
  std::vector<Shell> shells(p.face_count());
  for (const EdgePair& e : edges)
    if (e.right == kNoFace) shells[faces.root(e.left)].closed = false;
  std::vector<Index> roots;
  for (Index f = 0; f < p.face_count(); ++f) {
    Shell& shell = shells[faces.root(f)];
    if (faces.root(f) == f) {
      roots.push_back(f);
      shell.base = p.vertices[p.loop(p.first_loop(f))[0]];
    }
    shell.volume += cone_volume(p, f, shell.base);
    for (const Index v : p.loop(p.first_loop(f)))
      shell.low = glm::min(shell.low, p.vertices[v]),
      shell.high = glm::max(shell.high, p.vertices[v]);
  }
  return turned_shells(p, faces, shells, roots);
}

}  // namespace overstrike
