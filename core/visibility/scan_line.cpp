#include "core/visibility/scan_line.h"

#include "core/visibility/cut_away.h"
#include "core/visibility/run_shader.h"

namespace overstrike {
namespace {

class LineScanner : public RunScanner {
 public:
  LineScanner(const SweepTable& table, const ReceiverShadows& shadows, double density_tolerance)
      : sweep_(table),
        shader_(table.fronts, shadows, sweep_.faces(), density_tolerance),
        cut_away_(table.fronts, sweep_.faces(), shader_),
        beside_(beside_line(table.fronts.columns, table.fronts.rows)) {}
  void resolve(double y, std::vector<DensityRun>& runs) override {
    pieces_.clear();
    y += beside_;
    sweep_.resolve(y, pieces_);
    const std::size_t first = runs.size();
    shader_.shade(y, pieces_, runs);
    std::vector<SpanPiece>* const cut_away = sweep_.cut_away();
    if (cut_away != nullptr && !cut_away->empty())
      cut_away_.mix(y, pieces_, *cut_away, runs, first);
  }

 private:
  RowSweep sweep_;
  RunShader shader_;
  CutAway cut_away_;
  double beside_;
  std::vector<SpanPiece> pieces_;
};

}  // namespace

LineSource::LineSource(const Canonical& canonical, const View& view, const ShadowCaster* caster,
                       double density_tolerance, int threads, const SolidOptions& solids)
    : table_(canonical, view, threads, solids),
      shadows_(table_.fronts, caster, solids.coherence),
      density_tolerance_(density_tolerance) {}

std::unique_ptr<RunScanner> LineSource::scanner() const {
  return std::make_unique<LineScanner>(table_, shadows_, density_tolerance_);
}

}  // namespace overstrike
