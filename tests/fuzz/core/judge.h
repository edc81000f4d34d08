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

  /// Looks at the middle of every run and gap, at places between and just within the ends. What is
  /// drawn must be what the oracle sees there or kEndError beside it (more where the view magnifies
  /// without end); or what it would be were an
  /// end of the stretch off by that, times its condition number.
  void judge(const DrawnLine& line) const;

 private:
  struct Stretch;
  std::vector<Stretch> stretches_of(const DrawnLine& line) const;
  oracle::Seen seen_in(const DensityRun& run) const;
  oracle::Seen shown(const Stretch& stretch, double s) const;
  bool grazed(Index face) const;
  bool same_face(Index expected, Index drawn) const;
  bool same_body(const oracle::Seen& expected, const oracle::Seen& found) const;
  bool same(const oracle::Seen& expected, const oracle::Seen& found) const;
  bool agree(const oracle::Seen& expected, const oracle::Seen& found) const;
  bool is_right(const DrawnLine& line, double s, const oracle::Seen& found) const;
  void judge(const DrawnLine& line, const std::vector<Stretch>& all, std::size_t i, double s) const;
  bool is_uncertain(const DrawnLine& line, const std::vector<Stretch>& all, std::size_t i,
                    double s) const;

  const Canonical& in_;
  const View& view_;
  double place_error_;
  bool clipped_ = false;
  Canonical left_;                    ///< after clipping: what runs have the numbers of
  std::vector<Index> body_of_drawn_;  ///< of bodies that are left after clipping
  oracle::Oracle oracle_;
  oracle::Crossings crossings_;
};

}  // namespace overstrike::fuzz
