#pragma once
// Whether two drawings show the same picture: their tones differ only where rounding lets borders
// lie elsewhere.
#include <memory>
#include <string>

#include "tests/hard/laws.h"
#include "tests/oracle/crossings.h"
#include "tests/oracle/oracle.h"

namespace overstrike::hard {

/// Rows between the whole and half ones, on which no case has an edge.
constexpr ScanFamily kOddRows{0, 1, 0.2937};

class SamePicture {
 public:
  explicit SamePicture(const Scene& scene);

  /// Empty, or where `other` differs from the scene's rows by more than `error` grid units, times
  /// the condition number of what crosses there, may explain in each of the two. Tones count, not
  /// who has them.
  std::string difference(const Runs& other, double error) const;
  const Runs& rows() const { return rows_; }

  /// Grid units that a vertex's image moves when the vertex moves by one world unit, at most.
  double magnification() const;

 private:
  double condition(const oracle::Line& line, double from, double to) const;

  View view_;
  std::shared_ptr<const Canonical> canonical_;
  oracle::Oracle oracle_;
  oracle::Crossings crossings_;
  Runs rows_;
};

}  // namespace overstrike::hard
