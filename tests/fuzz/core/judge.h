#pragma once
// The law that matters most: what is drawn is what the oracle sees.
#include "core/visibility/canonical.h"
#include "core/visibility/view.h"
#include "tests/fuzz/core/drawn.h"
#include "tests/oracle/oracle.h"

namespace overstrike::fuzz {

class Judge {
 public:
  /// Both must outlive the judge.
  Judge(const Canonical& canonical, const View& view);

  /// Looks at the middle of every run and gap, and at places between. What differs is excused
  /// where a true edge is near, and where the stretch is no wider than its ends are uncertain.
  void judge(const DrawnLine& line) const;

 private:
  struct Stretch;
  oracle::Seen seen_in(const DensityRun& run) const;
  bool agree(const oracle::Seen& expected, const oracle::Seen& found) const;
  void judge(const DrawnLine& line, const Stretch& stretch, double s) const;
  bool is_uncertain(const DrawnLine& line, const Stretch& stretch, double s) const;

  const Canonical& in_;
  const View& view_;
  bool clipped_ = false;
  std::vector<Index> body_of_drawn_;  ///< of bodies that are left after clipping
  oracle::Oracle oracle_;
  oracle::Crossings crossings_;
};

}  // namespace overstrike::fuzz
