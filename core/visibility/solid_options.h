#pragma once
// How Boolean solids are resolved, for TK's experiments (TK, ch. 3 and 4), and what it took.
#include <cstdint>
#include <mutex>

namespace overstrike {

/// What the expression of a solid is followed as: the tree that was written, or a sum of products
/// (TK 3.3); or the latter where it is no more work (solid_forms.h). What is drawn is the same, to
/// the bit.
enum class BooleanForm : std::uint8_t { automatic, tree, products };

/// What is kept from one span to the next. What is drawn is the same, to the bit.
///
/// none: the layers are put in order, and the expression is followed, anew in each span and after
/// each crossing. span: what is seen is carried on (TK 4: the candidate), crossings are followed
/// anew. span_and_behind: crossings behind what is seen only change the order of layers. all: what
/// is known from line to line besides.
enum class Coherence : std::uint8_t { none, span, span_and_behind, all };

/// The work on solids. Without `all` it hangs on the lines that were resolved, not on the threads
/// that did.
struct SolidCounts {
  std::uint64_t spans = 0;      ///< that were looked at
  std::uint64_t crossings = 0;  ///< of two layers within a span
  std::uint64_t resorts = 0;    ///< layers that were moved past a neighbour at the beginning of one
  std::uint64_t decisions = 0;  ///< times that the expression was followed along depth
  std::uint64_t flips = 0;      ///< operands that were entered or left on the way
  std::uint64_t updates = 0;    ///< of counters of products or terms

  SolidCounts& operator+=(const SolidCounts& other) {
    spans += other.spans, crossings += other.crossings, resorts += other.resorts;
    decisions += other.decisions, flips += other.flips, updates += other.updates;
    return *this;
  }
};

/// Where all threads' counts come together.
class SolidTally {
 public:
  void add(const SolidCounts& counts) {
    const std::lock_guard lock(mutex_);
    sum_ += counts;
  }
  SolidCounts sum() const {
    const std::lock_guard lock(mutex_);
    return sum_;
  }

 private:
  mutable std::mutex mutex_;
  SolidCounts sum_;
};

struct SolidOptions {
  Coherence coherence = Coherence::all;
  SolidTally* tally = nullptr;  ///< where a sweep leaves its counts when it ends; may be null
};

}  // namespace overstrike
