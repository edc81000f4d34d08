#pragma once
// What every method that resolves scan lines offers.
#include <memory>
#include <vector>

#include "core/picture.h"

namespace overstrike {

/// Resolves lines y = const of one picture, in any order. One a thread.
class RunScanner {
 public:
  virtual ~RunScanner() = default;
  /// Appends the runs on the line at y, sorted, within [0, columns).
  virtual void resolve(double y, std::vector<DensityRun>& runs) = 0;
};

/// A picture ready to be scanned (phases I and II done). Safe to share between threads.
class RunSource {
 public:
  virtual ~RunSource() = default;
  virtual std::unique_ptr<RunScanner> scanner() const = 0;
};

}  // namespace overstrike
