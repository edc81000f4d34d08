#include "core/geometry/winged_edges.h"

#include <algorithm>

namespace overstrike {
namespace {

/// One side of an edge, as a face has it in a loop.
struct HalfEdge {
  Index high;  ///< the higher vertex; the lower one is the bucket's number
  Index face;
  Index corner;
  bool up;  ///< from the lower to the higher
};

/// Half-edges by their lower vertex, in order of the loops inside a bucket.
class Buckets {
 public:
  explicit Buckets(const Polyhedron& p) : starts_(p.vertices.size() + 1, 0) {
    each(p, [&](Index a, Index b, Index, Index) { ++starts_[std::min(a, b) + 1]; });
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    halves_.resize(starts_.back());
    std::vector<Index> next(starts_.begin(), starts_.end() - 1);
    each(p, [&](Index a, Index b, Index face, Index corner) {
      halves_[next[std::min(a, b)]++] = {std::max(a, b), face, corner, a < b};
    });
  }
  std::size_t size() const { return starts_.size() - 1; }
  std::span<HalfEdge> of(std::size_t low) {
    return {halves_.data() + starts_[low], halves_.data() + starts_[low + 1]};
  }

 private:
  template <class Visit>
  static void each(const Polyhedron& p, Visit visit) {
    for (Index face = 0; face < p.face_count(); ++face)
      for (Index l = p.first_loop(face); l < p.face_ends[face]; ++l) {
        const std::span<const Index> loop = p.loop(l);
        for (std::size_t i = 0; i < loop.size(); ++i)
          visit(loop[i], loop[i + 1 == loop.size() ? 0 : i + 1], face,
                p.first_index(l) + static_cast<Index>(i));
      }
  }

  std::vector<Index> starts_;
  std::vector<HalfEdge> halves_;
};

/// Pairs the sides of one edge: ups first, then downs, each in order.
void pair_group(Index low, std::span<const HalfEdge> group, std::vector<EdgePair>& out) {
  const std::size_t ups =
      std::find_if(group.begin(), group.end(), [](const HalfEdge& h) { return !h.up; }) -
      group.begin();
  const std::size_t downs = group.size() - ups;
  for (std::size_t i = 0; i < std::max(ups, downs); ++i) {
    const Index high = group[0].high;
    const HalfEdge none{high, kNoFace, kNoFace, false};
    const HalfEdge& down = i < downs ? group[ups + i] : none;
    if (i < ups)
      out.push_back({low, high, group[i].face, down.face, group[i].corner, down.corner});
    else
      out.push_back({high, low, down.face, kNoFace, down.corner, kNoFace});
  }
}

/// By the higher vertex, ups first, the order of the loops kept. Few sides begin in a vertex: for
/// those the library's sort, which asks for memory, takes longer than the rest of the pairing.
void sort_bucket(std::span<HalfEdge> bucket) {
  const auto before = [](const HalfEdge& a, const HalfEdge& b) {
    return a.high != b.high ? a.high < b.high : a.up > b.up;
  };
  constexpr std::size_t kFew = 16;
  if (bucket.size() > kFew) return std::stable_sort(bucket.begin(), bucket.end(), before);
  for (std::size_t i = 1; i < bucket.size(); ++i)
    for (std::size_t k = i; k > 0 && before(bucket[k], bucket[k - 1]); --k)
      std::swap(bucket[k], bucket[k - 1]);
}

}  // namespace

std::vector<EdgePair> pair_edges(const Polyhedron& polyhedron) {
  Buckets buckets(polyhedron);
  std::vector<EdgePair> pairs;
  pairs.reserve(polyhedron.indices.size() / 2 + 1);
  for (std::size_t low = 0; low < buckets.size(); ++low) {
    const std::span<HalfEdge> bucket = buckets.of(low);
    sort_bucket(bucket);
    for (std::size_t i = 0, end; i < bucket.size(); i = end) {
      for (end = i; end < bucket.size() && bucket[end].high == bucket[i].high;) ++end;
      pair_group(static_cast<Index>(low), bucket.subspan(i, end - i), pairs);
    }
  }
  return pairs;
}

std::vector<Twin> twins_of(const Polyhedron& polyhedron, const std::vector<EdgePair>& edges) {
  std::vector<Twin> twins(polyhedron.indices.size(), {kNoFace, kNoFace});
  for (const EdgePair& e : edges) {
    if (e.right == kNoFace) continue;
    twins[e.left_corner] = {e.right_corner, e.right};
    twins[e.right_corner] = {e.left_corner, e.left};
  }
  return twins;
}

}  // namespace overstrike
