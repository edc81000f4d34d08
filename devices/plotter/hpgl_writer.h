#pragma once
// HP-GL as every pen plotter takes it: IN VS SP PU PD with integers, in absolute coordinates.
#include <span>
#include <string>

#include "devices/transport/transport.h"

namespace overstrike {

/// A place in plotter units, y up from the lower left corner of the hard clip.
struct PlotPoint {
  int x = 0, y = 0;
  friend bool operator==(const PlotPoint&, const PlotPoint&) = default;
};

/// Longest instruction, mnemonic and terminator included: old parsers keep no longer lists.
constexpr std::size_t kLongestInstruction = 240;

/// Writes each line as it comes and keeps none. Laws: the pen is up before SP; no instruction is
/// longer than kLongestInstruction; an instruction's parameters are complete pairs.
class HpglWriter {
 public:
  explicit HpglWriter(Transport& transport) : transport_(transport) {}
  void begin();
  /// In cm/s, with at most two decimals.
  void speed(double cm_s);
  /// Nothing when the pen is already in the holder.
  void select_pen(int pen);
  /// One point makes a dot. Precondition: not empty.
  void polyline(std::span<const PlotPoint> points);
  /// The pen goes back to its stall.
  void end();

 private:
  Transport& transport_;
  int pen_ = 0;
  std::string text_;
};

}  // namespace overstrike
