#include "devices/plotter/hpgl_writer.h"

#include <fmt/core.h>

#include <cassert>
#include <iterator>

namespace overstrike {

void HpglWriter::begin() { transport_.write("IN;\n"); }

void HpglWriter::speed(double cm_s) {
  std::string number = fmt::format("{:.2f}", cm_s);
  while (number.back() == '0') number.pop_back();
  if (number.back() == '.') number.pop_back();
  transport_.write("VS" + number + ";\n");
}

void HpglWriter::select_pen(int pen) {
  if (pen == pen_) return;
  pen_ = pen;
  transport_.write(fmt::format("PU;SP{};\n", pen));
}

void HpglWriter::polyline(std::span<const PlotPoint> points) {
  assert(!points.empty());
  text_.clear();
  const auto out = std::back_inserter(text_);
  fmt::format_to(out, "PU{},{};PD", points[0].x, points[0].y);
  std::size_t start = text_.size() - 2;  // of the PD being written
  bool first = true;
  for (const PlotPoint& p : points.subspan(1)) {
    const std::string pair = fmt::format("{},{}", p.x, p.y);
    if (text_.size() - start + 1 + pair.size() + 1 > kLongestInstruction) {
      text_ += ";\nPD";
      start = text_.size() - 2;
      first = true;
    }
    if (!first) text_ += ',';
    text_ += pair;
    first = false;
  }
  text_ += ";\n";
  transport_.write(text_);
}

void HpglWriter::end() { transport_.write("PU;SP0;\n"); }

}  // namespace overstrike
