#include "emulators/plotter/machine.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "emulators/plotter/hpgl_parser.h"

namespace overstrike::emulator {
namespace {

/// The part of a move inside the clip, as two parameters of a + t (b - a).
struct Inside {
  double from = 0, to = 1;
  bool any() const { return from <= to; }
  bool whole() const { return from == 0 && to == 1; }
};

void keep(double start, double step, double most, Inside& inside) {
  if (step == 0) {
    if (start < 0 || start > most) inside.to = -1;
    return;
  }
  const double at_zero = -start / step, at_most = (most - start) / step;
  inside.from = std::max(inside.from, std::min(at_zero, at_most));
  inside.to = std::min(inside.to, std::max(at_zero, at_most));
}

class Machine {
 public:
  Machine(const PlotterLimits& limits, Ink& ink) : limits_(limits), ink_(ink) {}
  void take(const HpglEvent& event);
  PlotterReport finish();

 private:
  void start(const HpglEvent& event);
  void parameter(const HpglEvent& event);
  void complete();
  void skip(const HpglEvent& event);
  void lower();
  void raise();
  void select(double pen);
  void move(PenPoint to);
  void draw(PenPoint to);
  void add(PenPoint p);
  void flush();
  void warn(std::string text);

  PlotterLimits limits_;
  Ink& ink_;
  PlotterReport report_;
  std::map<std::string, SkippedInstruction> skipped_;
  std::uint64_t stray_ = 0, first_stray_ = 0, warned_ = 0;

  std::string instruction_;
  std::uint64_t instruction_byte_ = 0;
  std::size_t parameters_ = 0;
  double first_of_pair_ = 0;

  PenPoint at_;
  bool down_ = false, relative_ = false;
  int pen_ = 0;
  bool marked_ = false;         ///< the lowered pen has drawn something
  double without_pen_mm_ = 0;   ///< moved with the pen down and none in the holder
  std::vector<PenPoint> line_;  ///< not yet given to ink_
};

void Machine::take(const HpglEvent& event) {
  switch (event.kind) {
    case HpglEvent::Kind::instruction:
      return start(event);
    case HpglEvent::Kind::number:
      return parameter(event);
    case HpglEvent::Kind::end:
      return complete();
    case HpglEvent::Kind::stray:
      if (stray_++ == 0) first_stray_ = event.byte;
      return;
    case HpglEvent::Kind::none:
      return;
  }
}

void Machine::start(const HpglEvent& event) {
  ++report_.instructions;
  instruction_ = event.name;
  instruction_byte_ = event.byte;
  parameters_ = 0;
  if (instruction_ == "PU") raise();
  if (instruction_ == "PD") lower();
  if (instruction_ == "PA" || instruction_ == "DF") relative_ = false;
  if (instruction_ == "PR") relative_ = true;
  if (instruction_ == "IN") {
    raise();
    relative_ = false;
  }
  for (const char* known : {"PU", "PD", "PA", "PR", "DF", "IN", "SP", "VS"}) {
    if (instruction_ == known) return;
  }
  skip(event);
}

void Machine::skip(const HpglEvent& event) {
  SkippedInstruction& skipped = skipped_[event.name];
  if (skipped.count++ == 0) {
    skipped.name = event.name;
    skipped.first_byte = event.byte;
  }
}

void Machine::parameter(const HpglEvent& event) {
  ++parameters_;
  if (instruction_ == "SP" && parameters_ == 1) select(event.number);
  if (instruction_ != "PU" && instruction_ != "PD" && instruction_ != "PA" &&
      instruction_ != "PR") {
    return;
  }
  if (parameters_ % 2 == 1) {
    first_of_pair_ = event.number;
    return;
  }
  const PenPoint given{first_of_pair_, event.number};
  const double least = std::min(given.x, given.y), most = std::max(given.x, given.y);
  if (least < -limits_.range - 1 || most > limits_.range) {
    warn(fmt::format("byte {}: {} is out of range, the move is left out", event.byte,
                     most > limits_.range ? most : least));
    return;
  }
  move(relative_ ? PenPoint{at_.x + given.x, at_.y + given.y} : given);
}

void Machine::complete() {
  const bool moves =
      instruction_ == "PU" || instruction_ == "PD" || instruction_ == "PA" || instruction_ == "PR";
  if (moves && parameters_ % 2 == 1) {
    warn(fmt::format("byte {}: {} ends with half a pair of coordinates", instruction_byte_,
                     instruction_));
  }
  if (instruction_ == "SP" && parameters_ == 0) select(0);
}

void Machine::lower() {
  if (down_) return;
  down_ = true;
  marked_ = false;
}

void Machine::raise() {
  if (!down_) return;
  // A pen that was lowered and never moved has left a dot.
  if (!marked_) draw(at_);
  flush();
  down_ = false;
  ++report_.lifts;
}

void Machine::select(double pen) {
  if (pen < 0 || pen > limits_.pens || pen != std::floor(pen)) {
    warn(fmt::format("byte {}: SP {} is out of range 0 to {}, the pen stays", instruction_byte_,
                     pen, limits_.pens));
    return;
  }
  if (static_cast<int>(pen) == pen_) return;
  flush();
  pen_ = static_cast<int>(pen);
  if (pen_ != 0) ++report_.pen_changes;
}

void Machine::move(PenPoint to) {
  if (down_) {
    draw(to);
  } else {
    report_.pen_up_mm += std::hypot(to.x - at_.x, to.y - at_.y) * limits_.unit_mm;
  }
  at_ = to;
}

/// From where the pen is to there, as far as the hard clip lets it.
void Machine::draw(PenPoint to) {
  marked_ = true;
  Inside inside;
  const double dx = to.x - at_.x, dy = to.y - at_.y;
  keep(at_.x, dx, limits_.clip_x, inside);
  keep(at_.y, dy, limits_.clip_y, inside);
  if (!inside.whole()) ++report_.clipped;
  if (!inside.any()) return flush();
  const double drawn_mm = (inside.to - inside.from) * std::hypot(dx, dy) * limits_.unit_mm;
  if (pen_ == 0) {
    without_pen_mm_ += drawn_mm;
    return;
  }
  report_.pen_down_mm += drawn_mm;
  const auto point = [&](double t) {
    return PenPoint{std::clamp(at_.x + t * dx, 0.0, limits_.clip_x),
                    std::clamp(at_.y + t * dy, 0.0, limits_.clip_y)};
  };
  if (inside.from > 0) flush();
  if (line_.empty()) add(point(inside.from));
  if (dx != 0 || dy != 0) add(inside.to == 1 ? to : point(inside.to));
  if (inside.to < 1) flush();
}

void Machine::add(PenPoint p) {
  if (line_.size() == kLongestLine) {
    const PenPoint last = line_.back();
    flush();
    line_.push_back(last);
  }
  line_.push_back(p);
}

void Machine::flush() {
  if (!line_.empty()) ink_.line(pen_, line_);
  line_.clear();
}

void Machine::warn(std::string text) {
  if (++warned_ <= kMostWarnings) report_.warnings.push_back(std::move(text));
}

PlotterReport Machine::finish() {
  raise();
  for (const auto& [name, skipped] : skipped_) {
    report_.skipped.push_back(skipped);
    report_.unknown += skipped.count;
  }
  std::sort(report_.skipped.begin(), report_.skipped.end(),
            [](const auto& a, const auto& b) { return a.first_byte < b.first_byte; });
  report_.unknown += stray_;
  if (warned_ > kMostWarnings) {
    report_.warnings.push_back(fmt::format("and {} more of these", warned_ - kMostWarnings));
  }
  if (stray_ > 0) {
    report_.warnings.push_back(
        fmt::format("byte {}: {} bytes or numbers that belong to no instruction from here on",
                    first_stray_, stray_));
  }
  if (without_pen_mm_ > 0) {
    report_.warnings.push_back(
        fmt::format("{:.1f} mm were drawn with no pen in the holder", without_pen_mm_));
  }
  return std::move(report_);
}

}  // namespace

PlotterReport run_plotter(std::istream& hpgl, const PlotterLimits& limits, Ink& ink) {
  HpglParser parser(hpgl);
  Machine machine(limits, ink);
  for (HpglEvent event = parser.next(); event.kind != HpglEvent::Kind::none;
       event = parser.next()) {
    machine.take(event);
  }
  return machine.finish();
}

}  // namespace overstrike::emulator
