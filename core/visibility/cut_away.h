#pragma once
// Translucent display of what was cut away (TK 4: walking the active list back).
//
// What was cut away of a solid is seen where the solid with nothing taken from it (solid_forms.h)
// is seen before what is left of it. Of all that was cut away before what is seen the nearest
// counts: the density is mixed, (1 - f) of what is seen and f of what was cut away, f its solid's
// factor.
#include <vector>

#include "core/picture.h"
#include "core/visibility/face_order.h"
#include "core/visibility/run_shader.h"
#include "core/visibility/span_split.h"

namespace overstrike {

/// One a thread.
class CutAway {
 public:
  CutAway(const FrontTable& table, const FaceOrder& order, RunShader& shader)
      : table_(table), order_(order), shader_(shader), columns_(table.columns) {}

  /// Mixes what was cut away into runs from `first` on, which are those of `seen` on the level.
  void mix(double y, const std::vector<SpanPiece>& seen, std::vector<SpanPiece>& cut_away,
           std::vector<DensityRun>& runs, std::size_t first);

 private:
  void find_first(double y, const std::vector<SpanPiece>& seen,
                  const std::vector<SpanPiece>& cut_away);
  void compare(double y, const SpanPiece& over, Index seen);
  double factor_of(const DensityRun& run) const;
  void merge(std::span<const DensityRun> runs, std::vector<DensityRun>& mixed) const;

  const FrontTable& table_;
  const FaceOrder& order_;
  RunShader& shader_;
  double columns_;
  // Of one level.
  struct End {
    double x;
    float slack;
  };
  std::vector<End> ends_;
  std::vector<Index> active_;
  std::vector<SpanPiece> split_, first_;
  std::vector<DensityRun> before_, mixed_;
};

}  // namespace overstrike
