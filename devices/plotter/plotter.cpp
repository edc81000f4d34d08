#include "devices/plotter/plotter.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "core/error.h"
#include "devices/data_files.h"
#include "devices/plotter/clip.h"
#include "devices/plotter/hatching.h"
#include "devices/plotter/hpgl_writer.h"
#include "devices/plotter/pen_path.h"
#include "devices/plotter/profile.h"

namespace overstrike {
namespace {

/// A pen's line is ten times as wide as this and more: 2 units are 0.05 mm.
constexpr double kToleranceUnits = 2;

struct PlotterOptions {
  double unit_mm = 0;
  PlotPoint low, high;  ///< the drawable part of the sheet, within the hard clip
  int line_pen = 1, hatch_pen = 2, pens = 1;
  bool hatched = true;
  Hatching hatching;
  std::optional<double> speed_cm_s;
};

class Plotter final : public Device {
 public:
  Plotter(PlotterOptions options, std::unique_ptr<Transport> transport)
      : options_(options), transport_(std::move(transport)), writer_(*transport_) {}

  Layout layout() const override;
  void begin() override;
  void strokes(std::span<const Stroke> strokes) override;
  void hatch(std::size_t family, const RunRow& row) override;
  void end() override;
  std::vector<Diagnostic> warnings() const override;

 private:
  Vec2 size() const { return {options_.high.x - options_.low.x, options_.high.y - options_.low.y}; }
  /// The plotter unit nearest to a place in the grid; the border's for one outside.
  PlotPoint point_of(Vec2 p) const;
  /// Cuts a polyline in grid coordinates at the grid's border and rounds it to plotter units.
  void place_on_sheet(std::span<const Vec2> points, std::vector<PlotLine>& lines);
  int pen_of(const Stroke& stroke) const;

  PlotterOptions options_;
  std::unique_ptr<Transport> transport_;
  HpglWriter writer_;
  std::vector<HatchPiece> pieces_;
  bool backwards_ = false;  ///< the direction of the next row that has ink
  std::size_t cut_ = 0;
};

Layout Plotter::layout() const {
  Layout layout;
  layout.grid = {double(options_.high.x - options_.low.x), double(options_.high.y - options_.low.y),
                 options_.unit_mm, options_.unit_mm};
  layout.strokes = true;
  layout.tolerance = kToleranceUnits;
  for (int level = 1; options_.hatched && level < options_.hatching.levels; ++level) {
    layout.hatches.push_back(hatch_family(options_.hatching, level));
  }
  return layout;
}

void Plotter::begin() {
  writer_.begin();
  if (options_.speed_cm_s) writer_.speed(*options_.speed_cm_s);
}

PlotPoint Plotter::point_of(Vec2 p) const {
  const Vec2 cell = glm::clamp(glm::floor(p + 0.5), Vec2{0}, size());
  return {options_.low.x + static_cast<int>(cell.x), options_.high.y - static_cast<int>(cell.y)};
}

void Plotter::place_on_sheet(std::span<const Vec2> points, std::vector<PlotLine>& lines) {
  // What rounds onto the border is not cut.
  const Rectangle sheet{Vec2{-0.5}, size() + 0.5};
  cut_ += clip_polyline(points, sheet, [&](std::span<const Vec2> part) {
    PlotLine line;
    for (const Vec2& p : part) {
      if (const PlotPoint q = point_of(p); line.empty() || q != line.back()) line.push_back(q);
    }
    lines.push_back(std::move(line));
  });
}

int Plotter::pen_of(const Stroke& stroke) const {
  return stroke.pen >= 1 && stroke.pen <= options_.pens ? stroke.pen : options_.line_pen;
}

void Plotter::strokes(std::span<const Stroke> strokes) {
  std::map<int, std::vector<PlotLine>> by_pen;
  for (const Stroke& stroke : strokes) {
    if (!stroke.hidden) place_on_sheet(stroke.points, by_pen[pen_of(stroke)]);
  }
  PlotPoint at{0, 0};
  for (auto& [pen, lines] : by_pen) {
    if (lines.empty()) continue;
    writer_.select_pen(pen);
    for (const PlotLine& line : ordered(joined(std::move(lines)), at)) {
      writer_.polyline(line);
      at = line.back();
    }
  }
}

void Plotter::hatch(std::size_t family, const RunRow& row) {
  const int level = static_cast<int>(family) + 1;
  hatch_pieces(options_.hatching, level, row.runs, pieces_);
  if (pieces_.empty()) return;
  const HatchLine line(hatch_family(options_.hatching, level), row.index);
  if (backwards_) std::reverse(pieces_.begin(), pieces_.end());
  writer_.select_pen(options_.hatch_pen);
  for (HatchPiece piece : pieces_) {
    if (backwards_) std::swap(piece.x0, piece.x1);
    const PlotPoint ends[] = {point_of(line.nearest_unit(piece.x0)),
                              point_of(line.nearest_unit(piece.x1))};
    writer_.polyline(ends);
  }
  backwards_ = !backwards_;
}

void Plotter::end() {
  writer_.end();
  transport_->finish();
}

std::vector<Diagnostic> Plotter::warnings() const {
  if (cut_ == 0) return {};
  Diagnostic cut;
  cut.severity = Severity::warning;
  cut.message = fmt::format("{} {} cut at the border of the sheet", cut_,
                            cut_ == 1 ? "line was" : "lines were");
  return {cut};
}

/// The part of the sheet that the margin leaves and the pen can reach.
void place_on_paper(const SettingReader& settings, const PlotterProfile& profile,
                    PlotterOptions& options) {
  std::vector<std::string_view> papers;
  for (const PlotterPaper& one : profile.papers) papers.push_back(one.name);
  const PlotterPaper* paper = profile.paper(settings.choice("paper", papers));
  const double unit = profile.unit_mm;
  const double most = std::min(paper->width_mm, paper->height_mm) / 2;
  const double margin = settings.number("margin", 0, most);
  const auto units = [&](double mm) { return mm / unit; };
  options.low = {static_cast<int>(std::ceil(std::max(0.0, units(margin - paper->origin_x_mm)))),
                 static_cast<int>(std::ceil(std::max(0.0, units(margin - paper->origin_y_mm))))};
  options.high = {static_cast<int>(std::floor(std::min<double>(
                      paper->clip_x, units(paper->width_mm - margin - paper->origin_x_mm)))),
                  static_cast<int>(std::floor(std::min<double>(
                      paper->clip_y, units(paper->height_mm - margin - paper->origin_y_mm))))};
  if (options.high.x <= options.low.x || options.high.y <= options.low.y) {
    throw InputError(Place{}, fmt::format("margin {} mm leaves nothing of the paper", margin));
  }
}

PlotterOptions read_options(const SettingReader& settings, const PlotterProfile& profile) {
  PlotterOptions options;
  options.unit_mm = profile.unit_mm;
  options.pens = profile.pens;
  place_on_paper(settings, profile, options);
  options.line_pen = settings.integer("line-pen", 1, profile.pens);
  options.hatch_pen = settings.integer("hatch-pen", 1, profile.pens);
  options.hatching.levels = settings.integer("levels", 2, 64);
  options.hatching.pen_width = settings.number("pen-width", 0.1, 5) / profile.unit_mm;
  // On paper angles turn against the clock; in the grid, whose y points down, with it.
  options.hatching.angle_deg = -settings.number("hatch-angle", -180, 180);
  constexpr std::array<std::string_view, 2> kTones{"hatch", "none"};
  options.hatched = settings.choice("tone", kTones) == "hatch";
  if (!settings.text("speed").empty()) {
    options.speed_cm_s = settings.number("speed", profile.slowest_cm_s, profile.fastest_cm_s);
  }
  return options;
}

std::unique_ptr<Device> make_plotter(const Settings& given, std::string_view,
                                     std::unique_ptr<Transport> transport) {
  for (const auto& [name, value] : given) {
    if (name == "size") {
      throw InputError(Place{}, fmt::format("a plot has no size in cells, found size '{}'", value),
                       "paper and margin say how large it is");
    }
  }
  const DeviceKind kind = plotter_kind();
  const SettingReader settings(kind, given);
  const PlotterProfile profile = read_plotter_profile(find_data_file("plotters/hp7475a.profile"));
  return std::make_unique<Plotter>(read_options(settings, profile), std::move(transport));
}

}  // namespace

DeviceKind plotter_kind() {
  return {"plotter",
          "pen plotter: visible lines and hatched tone as HP-GL (HP 7475A)",
          {".hpgl", ".plt", ".hgl", ".gl"},
          {{"paper", "A4", "A4, A3, A or B, the long side across"},
           {"margin", "10", "bare paper on every side in mm; at least what the pen cannot reach"},
           {"pen-width", "0.3", "width of the hatching pen's line in mm (0.1 to 5)"},
           {"levels", "10", "levels of tone, bare paper included (2 to 64)"},
           {"line-pen", "1", "pen for lines (1 to 6)"},
           {"hatch-pen", "2", "pen for hatching (1 to 6)"},
           {"hatch-angle", "45", "of the hatching in degrees, from the right against the clock"},
           {"tone", "hatch", "hatch, or none for lines alone"},
           {"speed", "", "of the lowered pen in cm/s (0.38 to 38.1); empty: the plotter's own"}},
          make_plotter};
}

}  // namespace overstrike
