#pragma once
// Scan lines: the line resolver for lines y = const, as a method. Two levels: the fronts of bodies,
// and which of them is seen (row_sweep.h); then tones and shadows (run_shader.h).
#include <memory>
#include <vector>

#include "core/visibility/receiver_shadows.h"
#include "core/visibility/row_sweep.h"
#include "core/visibility/run_source.h"

namespace overstrike {

class LineSource : public RunSource {
 public:
  /// `canonical` and `caster` (null: no light) must outlive this. `density_tolerance`: a run whose
  /// density bends farther than this from a straight line is split.
  LineSource(const Canonical& canonical, const View& view, const ShadowCaster* caster,
             double density_tolerance, int threads, const SolidOptions& solids = {});
  std::unique_ptr<RunScanner> scanner() const override;

 private:
  SweepTable table_;
  ReceiverShadows shadows_;
  double density_tolerance_;
};

}  // namespace overstrike
