#pragma once
// What is seen where faces of one plane lie over one another (TK 3.3.4): what the faces are
// decides, nowhere where they are looked at; never the order of input.
#include <cstdint>
#include <span>
#include <vector>

#include "core/visibility/canonical.h"

namespace overstrike {

/// True when face f is seen before g: a cut face before others, then the face of the body with the
/// greater density factor, which is the darker one wherever both are flat (they share a normal, so
/// light and shadow); then a flat body's before a smooth one's; then the one with the
/// lexicographically smaller plane, or else vertices, or else pen, or else number.
bool wins_tie(const Canonical& canonical, Index f, Index g);

/// The first of many faces by wins_tie(), asked for again and again where mostly the same ones are
/// there: a face that has lost to another one is not compared while that is there too.
class FirstOfTied {
 public:
  explicit FirstOfTied(const Canonical& canonical) : canonical_(canonical) {}
  /// Precondition: there is one, and none is there twice.
  Index of(std::span<const Index> faces);

 private:
  bool loses(Index face);

  const Canonical& canonical_;
  std::vector<Index> lost_to_;        ///< per face; itself: to none yet
  std::vector<std::uint64_t> asked_;  ///< per face: the last question in which it was there
  std::uint64_t question_ = 0;
};

}  // namespace overstrike
