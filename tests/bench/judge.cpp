#include "tests/bench/judge.h"

#include <algorithm>
#include <cmath>

#include "core/drawing.h"
#include "tests/oracle/oracle.h"
#include "tests/oracle/random.h"

namespace overstrike::bench {
namespace {

constexpr std::size_t kAgreedAsked = 200;
/// Of one density: far below an 8-bit step, far above the rounding of the density law.
constexpr double kSameDensity = 1e-9;
constexpr double kMillion = 1e6;

/// A cell of the sampled rows: the number of its row among them, and its column.
struct Cell {
  std::size_t row;
  int column;
};

std::size_t below(oracle::Random& random, std::size_t count) {
  return static_cast<std::size_t>(random.in(0, static_cast<double>(count)));
}

/// At most `most` of the cells, any one as likely as another.
std::vector<Cell> some_of(std::vector<Cell> cells, std::size_t most, oracle::Random& random) {
  const std::size_t count = std::min(most, cells.size());
  for (std::size_t i = 0; i < count; ++i)
    std::swap(cells[i], cells[i + below(random, cells.size() - i)]);
  cells.resize(count);
  return cells;
}

double centre(int cell) { return cell + 0.5; }

const DensityRun* run_at(const std::vector<DensityRun>& runs, double x) {
  const auto after = std::upper_bound(runs.begin(), runs.end(), x,
                                      [](double at, const DensityRun& r) { return at < r.x0; });
  return after != runs.begin() && x < (after - 1)->x1 ? &*(after - 1) : nullptr;
}

using Methods = std::vector<std::vector<Shown>>;

Index shown(const Methods& methods, std::size_t method, const Cell& cell) {
  return methods[method][cell.row][static_cast<std::size_t>(cell.column)];
}

bool is_disputed(const Methods& methods, const Cell& cell) {
  for (std::size_t m = 1; m < methods.size(); ++m)
    if (shown(methods, m, cell) != shown(methods, 0, cell)) return true;
  return false;
}

std::vector<Cell> disputed_cells(const Methods& methods) {
  std::vector<Cell> disputed;
  for (std::size_t row = 0; row < methods[0].size(); ++row)
    for (int x = 0; x < static_cast<int>(methods[0][row].size()); ++x)
      if (is_disputed(methods, {row, x})) disputed.push_back({row, x});
  return disputed;
}

double share(std::size_t all, std::size_t asked) {
  return asked == 0 ? 0 : static_cast<double>(all) / static_cast<double>(asked);
}

/// Cells at which each method is wrong.
struct Tally {
  Tally(const Prepared& prepared, const std::vector<int>& asked_rows, const Methods& all)
      : rows(asked_rows),
        methods(all),
        canonical(*prepared.canonical),
        oracle(canonical, prepared.view),
        wrong(all.size()) {}
  void ask(const Cell& cell, double stands_for) {
    const Index truth = oracle.at(centre(cell.column), centre(rows[cell.row])).face;
    for (std::size_t m = 0; m < methods.size(); ++m)
      if (!is_right(m, shown(methods, m, cell), truth)) wrong[m] += stands_for;
  }
  bool is_right(std::size_t method, Index face, Index truth) const {
    if (face == truth || method + 1 == methods.size()) return face == truth;
    return face != kNone && truth != kNone &&
           canonical.faces[face].plane == canonical.faces[truth].plane;
  }

  const std::vector<int>& rows;
  const Methods& methods;
  const Canonical& canonical;
  oracle::Oracle oracle;
  std::vector<double> wrong;
};

bool agrees(const DensityRun* run, const oracle::Seen& seen, double x) {
  if (run == nullptr) return seen.density == 0;
  const double part = (x - run->x0) / (run->x1 - run->x0);
  const double density = run->density0 + (run->density1 - run->density0) * part;
  return run->kind == seen.kind && std::fabs(density - seen.density) < kSameDensity;
}

}  // namespace

std::vector<int> sampled_rows(const Grid& grid, int count) {
  const int all = static_cast<int>(grid.rows);
  oracle::Random random(2026);
  std::vector<int> rows;
  for (int i = 0; i < count; ++i)
    rows.push_back(static_cast<int>(random.in(0, static_cast<double>(all))));
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

std::vector<std::vector<DensityRun>> runs_of_rows(const Prepared& prepared,
                                                  const std::vector<int>& rows, int threads) {
  DrawOptions options;
  options.threads = threads;
  Drawing drawing(prepared.canonical, prepared.view, options);
  std::vector<std::vector<DensityRun>> result;
  drawing.runs({}, [&](const RunRow& row) {
    if (result.size() < rows.size() && row.index == rows[result.size()])
      result.emplace_back(row.runs.begin(), row.runs.end());
  });
  result.resize(rows.size());
  return result;
}

Shown shown_by(const std::vector<DensityRun>& runs, int columns) {
  Shown shown(static_cast<std::size_t>(columns), kNone);
  for (int x = 0; x < columns; ++x)
    if (const DensityRun* run = run_at(runs, centre(x)))
      shown[static_cast<std::size_t>(x)] = run->surface;
  return shown;
}

std::vector<double> wrong_ppm(const Prepared& prepared, const std::vector<int>& rows,
                              const std::vector<std::vector<Shown>>& methods) {
  const int columns = static_cast<int>(prepared.view.grid.columns);
  const std::size_t cells = rows.size() * static_cast<std::size_t>(columns);
  const std::vector<Cell> disputed = disputed_cells(methods);
  Tally tally(prepared, rows, methods);
  oracle::Random random(1);
  const std::vector<Cell> asked = some_of(disputed, kMostAsked, random);
  for (const Cell& cell : asked) tally.ask(cell, share(disputed.size(), asked.size()));
  for (std::size_t i = 0; i < kAgreedAsked; ++i) {
    const Cell cell{below(random, rows.size()), static_cast<int>(random.in(0, columns))};
    if (!is_disputed(methods, cell)) tally.ask(cell, share(cells - disputed.size(), kAgreedAsked));
  }
  for (double& w : tally.wrong) w *= kMillion / static_cast<double>(cells);
  return tally.wrong;
}

double wrong_ppm(const Prepared& prepared, const std::vector<int>& rows,
                 const std::vector<std::vector<DensityRun>>& runs, int count) {
  const oracle::Oracle oracle(*prepared.canonical, prepared.view);
  oracle::Random random(2);
  int wrong = 0;
  for (int i = 0; i < count; ++i) {
    const std::size_t row = below(random, rows.size());
    const double x = std::floor(random.in(0, prepared.view.grid.columns)) + 0.5;
    const oracle::Seen seen = oracle.at(x, centre(rows[row]));
    if (!agrees(run_at(runs[row], x), seen, x)) ++wrong;
  }
  return wrong * kMillion / count;
}

}  // namespace overstrike::bench
