#include "core/drawing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <optional>

#include "core/float_environment.h"
#include "core/geometry/trig.h"
#include "core/in_order.h"
#include "core/visibility/bands.h"
#include "core/visibility/canonical.h"
#include "core/visibility/cell_scanner.h"
#include "core/visibility/clip.h"
#include "core/visibility/eye_table.h"
#include "core/visibility/line_averager.h"
#include "core/visibility/nn74/conditions.h"
#include "core/visibility/nn74/paint.h"
#include "core/visibility/run_shader.h"
#include "core/visibility/scan_line.h"
#include "core/visibility/shadows.h"
#include "core/visibility/solid_forms.h"
#include "core/visibility/strokes.h"
#include "core/visibility/view.h"

namespace overstrike {
namespace {

class Stopwatch {
 public:
  double ms() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_)
        .count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Things of which each thread needs one at a time, made when there are too few.
template <class T>
class Pool {
 public:
  explicit Pool(std::function<std::unique_ptr<T>()> make) : make_(std::move(make)) {}

  template <class Use>
  void use(const Use& work) {
    std::unique_ptr<T> one = take();
    work(*one);
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(one));
  }

 private:
  std::unique_ptr<T> take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) return make_();
    std::unique_ptr<T> one = std::move(free_.back());
    free_.pop_back();
    return one;
  }

  std::function<std::unique_ptr<T>()> make_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<T>> free_;
};

/// The lines of a family over a grid, and the turned grid in which they are y = const.
struct FamilyFrame {
  FamilyFrame(const ScanFamily& f, const Grid& grid)
      : FamilyFrame(f, grid, TurnBack(f.angle_deg)) {}
  FamilyFrame(const ScanFamily& f, const Grid& grid, const TurnBack& turn)
      : family(f), c(turn.cosine), s(turn.sine), minus_s(turn.minus_sine) {
    const Vec2 corners[4] = {{0, 0}, {grid.columns, 0}, {grid.columns, grid.rows}, {0, grid.rows}};
    low = Vec2(1e300), high = Vec2(-1e300);
    for (const Vec2& p : corners) {
      const Vec2 q(c * p.x + s * p.y, minus_s * p.x + c * p.y);
      low = glm::min(low, q), high = glm::max(high, q);
    }
    first = static_cast<std::int64_t>(std::ceil((low.y - family.offset) / family.spacing));
    last = static_cast<std::int64_t>(std::floor((high.y - family.offset) / family.spacing));
    if (position(last) >= high.y) --last;
  }

  double position(std::int64_t index) const {
    return family.offset + static_cast<double>(index) * family.spacing;
  }
  /// The turned grid's origin in the grid.
  Vec2 origin() const { return Vec2(c * low.x + minus_s * low.y, s * low.x + c * low.y); }

  /// Where the line n . p = at lies in the grid, along the line.
  std::pair<double, double> within(double at, const Grid& grid) const {
    double t0 = low.x, t1 = high.x;
    // The point at t is t (c, s) + at (-s, c).
    const auto keep = [&](double base, double direction, double size) {
      if (direction == 0) {
        if (base < 0 || base > size) t1 = t0;
        return;
      }
      const double a = -base / direction, b = (size - base) / direction;
      t0 = std::max(t0, std::min(a, b)), t1 = std::min(t1, std::max(a, b));
    };
    keep(-s * at, c, grid.columns);
    keep(c * at, s, grid.rows);
    return {t0, t1};
  }

  ScanFamily family;
  double c, s, minus_s;
  Vec2 low, high;
  std::int64_t first, last;
};

void shift_and_clip(std::vector<DensityRun>& runs, std::size_t from, double shift, double t0,
                    double t1) {
  std::size_t out = from;
  for (std::size_t i = from; i < runs.size(); ++i) {
    DensityRun r = runs[i];
    r.x0 += shift, r.x1 += shift;
    const double slope = (r.density1 - r.density0) / (r.x1 - r.x0);
    if (r.x0 < t0) r.density0 += slope * (t0 - r.x0), r.x0 = t0;
    if (r.x1 > t1) r.density1 += slope * (t1 - r.x1), r.x1 = t1;
    if (r.x0 < r.x1) runs[out++] = r;
  }
  runs.resize(out);
}

/// Rows of cells, of whatever method.
class RowResolver {
 public:
  virtual ~RowResolver() = default;
  /// The row's cells; `band` holds the row. Valid until the next call.
  virtual std::span<const float> resolve(std::int64_t row, std::size_t band) = 0;
};

class ScannedRows : public RowResolver {
 public:
  ScannedRows(const EyeTable& table, const Bands& bands, double tolerance,
              std::function<std::unique_ptr<RunScanner>()> lines)
      : bands_(bands), scanner_(table, tolerance, std::move(lines)) {}
  std::span<const float> resolve(std::int64_t row, std::size_t band) override {
    return scanner_.resolve(row, bands_.edges(band), bands_.flat_edges(band));
  }

 private:
  const Bands& bands_;
  CellScanner scanner_;
};

class AveragedRows : public RowResolver {
 public:
  AveragedRows(const RunSource& source, double columns, double tolerance)
      : lines_(source.scanner(), columns, tolerance) {}
  std::span<const float> resolve(std::int64_t row, std::size_t) override {
    return lines_.resolve(row);
  }

 private:
  LineAverager lines_;
};

}  // namespace

struct Drawing::Impl {
  Impl(const Scene& scene, const Grid& asked_grid, const DrawOptions& draw_options)
      : options(draw_options), grid(asked_grid), view(make_view(scene, grid, options.margin)) {
    Stopwatch eye_watch;
    Canonical canonical = canonicalize(scene, view, options.tolerance, warnings);
    canonical.solids = solids_in_form(canonical, options.boolean, options.translucent);
    whole = std::make_shared<const Canonical>(std::move(canonical));
    timings.eye_ms += eye_watch.ms();
    check_solids(scene.solids.empty() ? Place{} : scene.solids.front().place);
    clip_near();
    if (options.method == Method::nn74) {
      prepare_nn74(scene);
    }
  }

  Impl(std::shared_ptr<const Canonical> canonical, const View& in_view,
       const DrawOptions& draw_options)
      : options(draw_options), grid(in_view.grid), view(in_view), whole(std::move(canonical)) {
    take_solids_in_form();
    check_solids({});
    clip_near();
  }

  /// The canonical input stays as it is where they need no change.
  void take_solids_in_form() {
    auto solids = solids_in_form(*whole, options.boolean, options.translucent);
    if (solids == whole->solids) return;
    Canonical changed = *whole;
    changed.solids = std::move(solids);
    whole = std::make_shared<const Canonical>(std::move(changed));
  }

  /// What cannot be drawn of solids, the first of which the scene names at `place`.
  void check_solids(const Place& place) {
    if (whole->solids.empty()) return;
    if (options.method == Method::nn74)
      throw InputError(place, "method nn74 draws no unions, differences and intersections",
                       "method line draws them");
  }

  void clip_near() {
    Stopwatch watch;
    clipped = view.near_plane && needs_clip(*whole, *view.near_plane);
    if (clipped) cut = clip(*whole, *view.near_plane, view.eye);
    timings.eye_ms += watch.ms();
  }

  /// I: the light's view, when it is first wanted; null without a light.
  const ShadowCaster* caster() {
    if (!caster_ && whole->light) {
      Stopwatch watch;
      caster_ = std::make_unique<ShadowCaster>(*whole, seen(), view, options.threads);
      timings.light_ms += watch.ms();
    }
    return caster_.get();
  }
  /// I: all shadows, for what cannot wait until a receiver is seen.
  const std::vector<Shadow>& shadows() {
    if (shadows_) return *shadows_;
    const ShadowCaster* const casting = caster();
    Stopwatch watch;
    shadows_ = casting != nullptr ? casting->all() : std::vector<Shadow>{};
    timings.light_ms += watch.ms();
    return *shadows_;
  }
  /// II, for lines y = const.
  const LineSource& lines() {
    if (lines_) return *lines_;
    const ShadowCaster* const casting = caster();
    Stopwatch watch;
    lines_ = std::make_unique<LineSource>(seen(), view, casting, density_tolerance(),
                                          options.threads, solid_options());
    timings.eye_ms += watch.ms();
    return *lines_;
  }
  /// II, for cells.
  const EyeTable& table() {
    if (table_) return *table_;
    const std::vector<Shadow>& cast = shadows();
    Stopwatch watch;
    table_ = std::make_unique<EyeTable>(seen(), view, cast);
    timings.eye_ms += watch.ms();
    return *table_;
  }

  void prepare_nn74(const Scene& scene) {
    Stopwatch check_watch;
    nn74::check_conditions(scene, *whole, view);
    timings.eye_ms += check_watch.ms();
    Stopwatch light_watch;
    light = nn74::cast(*whole, seen(), view);
    timings.light_ms += light_watch.ms();
    Stopwatch picture_watch;
    painted = std::make_unique<nn74::PaintSource>(seen(), view, light);
    timings.eye_ms += picture_watch.ms();
  }

  const Canonical& seen() const { return clipped ? cut : *whole; }

  SolidOptions solid_options() { return {options.coherence, &tally}; }

  double density_tolerance() const { return density_tolerance_of(options.tolerance); }

  void report(std::size_t done, std::size_t all) const {
    if (options.progress)
      options.progress(static_cast<double>(done) /
                       static_cast<double>(std::max<std::size_t>(all, 1)));
  }

  DrawOptions options;
  Grid grid;
  View view;
  std::shared_ptr<const Canonical> whole;
  Canonical cut;
  bool clipped = false;
  SolidTally tally;
  // Of the line resolver, each made when it is first wanted.
  std::unique_ptr<ShadowCaster> caster_;
  std::optional<std::vector<Shadow>> shadows_;
  std::unique_ptr<LineSource> lines_;
  std::unique_ptr<EyeTable> table_;
  nn74::LightPhase light;
  std::unique_ptr<nn74::PaintSource> painted;  ///< of NN74's method
  std::vector<Diagnostic> warnings;
  Timings timings;

  void cells(const std::function<void(const CellRow&)>& sink);
  void runs(const ScanFamily& family, const std::function<void(const RunRow&)>& sink);
  void scan(const RunSource& source, const FamilyFrame& frame, double shift,
            const std::function<void(const RunRow&)>& sink);
};

void Drawing::Impl::cells(const std::function<void(const CellRow&)>& sink) {
  // A solid is resolved along lines.
  const bool by_lines = painted != nullptr || !seen().solids.empty();
  if (!by_lines) table();
  const RunSource* const source = painted    ? painted.get()
                                  : by_lines ? static_cast<const RunSource*>(&lines())
                                             : nullptr;
  Stopwatch watch;
  double output_ms = 0;
  const std::size_t columns = static_cast<std::size_t>(std::ceil(grid.columns));
  const std::size_t rows = static_cast<std::size_t>(std::ceil(grid.rows));
  constexpr std::size_t kMostRows = 16, kMostCells = std::size_t{1} << 18;
  const std::size_t at_once =
      std::clamp<std::size_t>(kMostCells / std::max<std::size_t>(columns, 1), 1, kMostRows);
  std::optional<Bands> bands;
  if (!by_lines) bands.emplace(*table_, static_cast<double>(at_once));
  std::mutex crowded;
  const auto lines_for_crowds = [&] {
    const std::lock_guard lock(crowded);
    return lines().scanner();
  };
  Pool<RowResolver> resolvers([&]() -> std::unique_ptr<RowResolver> {
    if (!by_lines)
      return std::make_unique<ScannedRows>(*table_, *bands, options.tolerance, lines_for_crowds);
    return std::make_unique<AveragedRows>(*source, grid.columns, options.tolerance);
  });
  std::vector<std::vector<float>> slots(slots_for(options.threads));
  const std::size_t count = (rows + at_once - 1) / at_once;
  const auto compute = [&](std::size_t band, std::size_t slot) {
    const FloatEnvironment ours;
    slots[slot].clear();
    resolvers.use([&](RowResolver& resolver) {
      for (std::size_t row = band * at_once; row < std::min(rows, (band + 1) * at_once); ++row) {
        const std::span<const float> cells = resolver.resolve(static_cast<std::int64_t>(row), band);
        slots[slot].insert(slots[slot].end(), cells.begin(), cells.end());
      }
    });
  };
  const auto consume = [&](std::size_t band, std::size_t slot) {
    Stopwatch output;
    for (std::size_t i = 0; i * columns < slots[slot].size(); ++i)
      sink({static_cast<std::int64_t>(band * at_once + i),
            std::span(slots[slot]).subspan(i * columns, columns)});
    report(band + 1, count);
    output_ms += output.ms();
  };
  in_order(count, options.threads, slots.size(), compute, consume);
  timings.output_ms += output_ms;
  timings.scan_ms += watch.ms() - output_ms;
}

void Drawing::Impl::scan(const RunSource& source, const FamilyFrame& frame, double shift,
                         const std::function<void(const RunRow&)>& sink) {
  struct Chunk {
    std::vector<DensityRun> runs;
    std::vector<std::size_t> ends;
  };
  double output_ms = 0;
  Stopwatch watch;
  constexpr std::size_t kLinesAtOnce = 16;
  Pool<RunScanner> scanners([&] { return source.scanner(); });
  std::vector<Chunk> slots(slots_for(options.threads));
  const std::size_t lines =
      frame.last < frame.first ? 0 : static_cast<std::size_t>(frame.last - frame.first + 1);
  const std::size_t count = (lines + kLinesAtOnce - 1) / kLinesAtOnce;
  const auto index_of = [&](std::size_t line) {
    return frame.first + static_cast<std::int64_t>(line);
  };
  const auto compute = [&](std::size_t chunk, std::size_t slot) {
    const FloatEnvironment ours;
    Chunk& c = slots[slot];
    c.runs.clear(), c.ends.clear();
    scanners.use([&](RunScanner& scanner) {
      for (std::size_t line = chunk * kLinesAtOnce;
           line < std::min(lines, (chunk + 1) * kLinesAtOnce); ++line) {
        const double at = frame.position(index_of(line));
        const std::size_t before = c.runs.size();
        scanner.resolve(at - frame.low.y, c.runs);
        const auto [t0, t1] = frame.within(at, grid);
        if (frame.family.angle_deg != 0) shift_and_clip(c.runs, before, shift, t0, t1);
        c.ends.push_back(c.runs.size());
      }
    });
  };
  const auto consume = [&](std::size_t chunk, std::size_t slot) {
    Stopwatch output;
    std::size_t from = 0;
    for (std::size_t i = 0; i < slots[slot].ends.size(); ++i) {
      const std::size_t to = slots[slot].ends[i];
      sink({index_of(chunk * kLinesAtOnce + i),
            std::span(slots[slot].runs).subspan(from, to - from)});
      from = to;
    }
    report(chunk + 1, count);
    output_ms += output.ms();
  };
  in_order(count, options.threads, slots.size(), compute, consume);
  timings.output_ms += output_ms;
  timings.scan_ms += watch.ms() - output_ms;
}

void Drawing::Impl::runs(const ScanFamily& family, const std::function<void(const RunRow&)>& sink) {
  const FamilyFrame frame(family, grid);
  if (family.angle_deg == 0) {
    if (painted) return scan(*painted, frame, 0, sink);
    return scan(lines(), frame, 0, sink);
  }
  Stopwatch watch;
  View turned_view = turned(view, family.angle_deg, frame.origin(), 1);
  turned_view.grid.columns = frame.high.x - frame.low.x;
  turned_view.grid.rows = frame.high.y - frame.low.y;
  if (painted) {
    const nn74::PaintSource turned_picture(seen(), turned_view, light);
    timings.eye_ms += watch.ms();
    return scan(turned_picture, frame, frame.low.x, sink);
  }
  const ShadowCaster* const casting = caster();
  Stopwatch table_watch;
  const LineSource turned_lines(seen(), turned_view, casting, density_tolerance(), options.threads,
                                solid_options());
  timings.eye_ms += table_watch.ms();
  scan(turned_lines, frame, frame.low.x, sink);
}

Drawing::Drawing(const Scene& scene, const Grid& grid, const DrawOptions& options) {
  const FloatEnvironment ours;
  impl_ = std::make_unique<Impl>(scene, grid, options);
}
Drawing::Drawing(std::shared_ptr<const Canonical> canonical, const View& view,
                 const DrawOptions& options) {
  const FloatEnvironment ours;
  impl_ = std::make_unique<Impl>(std::move(canonical), view, options);
}
Drawing::~Drawing() = default;
Drawing::Drawing(Drawing&&) noexcept = default;

void Drawing::cells(const std::function<void(const CellRow&)>& sink) {
  const FloatEnvironment ours;
  impl_->cells(sink);
  impl_->timings.solids = impl_->tally.sum();
}

void Drawing::runs(const ScanFamily& family, const std::function<void(const RunRow&)>& sink) {
  const FloatEnvironment ours;
  impl_->runs(family, sink);
  impl_->timings.solids = impl_->tally.sum();
}

std::vector<Stroke> Drawing::strokes(const StrokeOptions& options) {
  const FloatEnvironment ours;
  Impl& impl = *impl_;
  const std::vector<Shadow>& shadows = impl.shadows();
  Stopwatch watch;
  std::vector<Stroke> strokes = visible_strokes(*impl.whole, impl.seen(), impl.view, shadows,
                                                options, impl.options.tolerance);
  impl_->timings.scan_ms += watch.ms();
  return strokes;
}

const std::vector<Diagnostic>& Drawing::warnings() const { return impl_->warnings; }
const Timings& Drawing::timings() const { return impl_->timings; }

}  // namespace overstrike
