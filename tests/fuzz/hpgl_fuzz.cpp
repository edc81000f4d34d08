// Any bytes are HP-GL to the emulated plotter: it reports, and draws inside its hard clip only.
#include <cmath>
#include <sstream>

#include "emulators/plotter/hpgl_parser.h"
#include "emulators/plotter/machine.h"
#include "tests/fuzz/fuzz.h"

namespace overstrike::fuzz {
namespace {

using namespace emulator;

constexpr PlotterLimits kLimits{0.025, 1000, 700, 32767, 6};

class Witness final : public Ink {
 public:
  void line(int pen, std::span<const PenPoint> points) override {
    expect(pen >= 1 && pen <= kLimits.pens, "lines are drawn by a pen of the carousel");
    expect(!points.empty() && points.size() <= kLongestLine, "lines come in pieces");
    for (const PenPoint& p : points)
      expect(p.x >= 0 && p.x <= kLimits.clip_x && p.y >= 0 && p.y <= kLimits.clip_y,
             "ink stays in the hard clip");
  }
};

void parse(const std::string& bytes) {
  std::istringstream in(bytes);
  HpglParser parser(in);
  std::uint64_t last = 0;
  for (auto event = parser.next(); event.kind != HpglEvent::Kind::none; event = parser.next()) {
    expect(event.byte >= last && event.byte <= bytes.size(), "events come in the stream's order");
    expect(std::isfinite(event.number), "numbers are finite");
    last = event.byte;
  }
}

void plot(const std::string& bytes) {
  std::istringstream in(bytes);
  Witness ink;
  const PlotterReport report = run_plotter(in, kLimits, ink);
  expect(report.instructions <= bytes.size(), "an instruction takes a byte at least");
  expect(std::isfinite(report.pen_down_mm) && report.pen_down_mm >= 0, "the pen's way is a length");
  expect(std::isfinite(report.pen_up_mm) && report.pen_up_mm >= 0, "the way aside is a length");
  // Each of the three sums adds one sentence.
  expect(report.warnings.size() <= kMostWarnings + 3, "warnings are bounded");
}

}  // namespace
}  // namespace overstrike::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(overstrike::fuzz::text_of(data, size));
  overstrike::fuzz::parse(bytes);
  overstrike::fuzz::plot(bytes);
  return 0;
}
