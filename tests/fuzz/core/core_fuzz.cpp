// Core on tiny scenes: it draws, and the laws of core/picture.h, docs/visibility.md and the oracle
// hold.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "core/error.h"
#include "tests/fuzz/core/drawn.h"
#include "tests/fuzz/core/judge.h"
#include "tests/fuzz/core/tiny_scene.h"
#include "tests/fuzz/core/tiny_solids.h"

namespace overstrike::fuzz {
namespace {

/// Middles of rows; lines on the corners of cells, where the tiny set's vertices fall in many
/// views; upright; along diagonals, through the corners of cells; aslant.
constexpr ScanFamily kFamilies[] = {
    {0, 1, 0.5}, {0, 4, 2}, {90, 4, -14}, {45, 2.8284271247461903, 0}, {33, 5.3, 0.71}};

void expect_jump_equals_step(Drawing& drawing, const std::vector<DrawnLine>& rows) {
  for (const std::size_t i : {std::size_t{3}, rows.size() / 2}) {
    const auto jumped = draw_lines(drawing, {0, 1000, static_cast<double>(i) + 0.5});
    expect(jumped.size() == 1, "one line is drawn where one is asked for");
    expect(std::equal(jumped[0].runs.begin(), jumped[0].runs.end(), rows[i].runs.begin(),
                      rows[i].runs.end(), same_bits),
           "jumping to a line gives what stepping to it gives");
  }
}

/// So many lines that each thread gets some.
void expect_threads_agree(const Prepared& prepared) {
  constexpr ScanFamily kMany{0, 0.2, 0.1};
  Drawing one = prepared.drawing(1), two = prepared.drawing(2);
  const auto a = draw_lines(one, kMany), b = draw_lines(two, kMany);
  expect(a.size() == b.size(), "threads draw all lines");
  for (std::size_t i = 0; i < a.size(); ++i)
    expect(std::equal(a[i].runs.begin(), a[i].runs.end(), b[i].runs.begin(), b[i].runs.end(),
                      same_bits),
           "two threads draw what one draws");
  expect(draw_cells(one) == draw_cells(two), "two threads draw the cells that one draws");
}

/// Lines so near to one another that much is kept from line to line.
void expect_keeping_changes_nothing(const Prepared& prepared) {
  constexpr ScanFamily kNear{0, 1.0 / 16, 1.0 / 32};
  Drawing keeping = prepared.drawing(), anew = prepared.drawing(1, Coherence::span_and_behind);
  const auto a = draw_lines(keeping, kNear), b = draw_lines(anew, kNear);
  expect(a.size() == b.size(), "both draw all lines");
  for (std::size_t i = 0; i < a.size(); ++i)
    expect(std::equal(a[i].runs.begin(), a[i].runs.end(), b[i].runs.begin(), b[i].runs.end(),
                      same_bits),
           "what is kept from line to line is what lines show by themselves");
}

std::string text_of(const DrawnLine& line) {
  std::string text;
  char number[64];
  for (const DensityRun& run : line.runs) {
    std::snprintf(number, sizeof number, " %.17g..%.17g %.3g", run.x0, run.x1, run.density0);
    text += number;
  }
  return text;
}

/// But for the numbers of faces and bodies.
bool same_ink(const DensityRun& a, const DensityRun& b) {
  return a.x0 == b.x0 && a.x1 == b.x1 && a.density0 == b.density0 && a.density1 == b.density1 &&
         a.kind == b.kind;
}

/// Runs of one ink that touch made one: of two solids with one surface either may show it, the one
/// whose faces come first where both have it.
std::vector<DensityRun> joined(const DrawnLine& line) {
  std::vector<DensityRun> runs;
  for (const DensityRun& run : line.runs) {
    const bool goes_on = !runs.empty() && runs.back().x1 == run.x0 &&
                         run.kind == runs.back().kind && run.density0 == run.density1 &&
                         run.density0 == runs.back().density0 &&
                         run.density0 == runs.back().density1;
    if (goes_on) {
      runs.back().x1 = run.x1;
    } else {
      runs.push_back(run);
    }
  }
  return runs;
}

/// Bodies thinner than rounding, and slivers no wider than an end may be off, may differ, but not
/// be wrong.
void expect_order_does_not_count(const Scene& scene, const std::vector<DrawnLine>& rows) {
  const Prepared turned(in_opposite_order(scene));
  const Judge judge(*turned.canonical, turned.view);
  Drawing drawing = turned.drawing();
  const auto others = draw_lines(drawing, kFamilies[0]);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto a = joined(rows[i]), b = joined(others[i]);
    if (std::equal(a.begin(), a.end(), b.begin(), b.end(), same_ink)) continue;
    if (scene.solids.empty())
      broken("the order of the bodies does not count: row " + std::to_string(i) + ":" +
             text_of(rows[i]) + " against" + text_of(others[i]));
    judge.judge(others[i]);
  }
}

void expect_method_agrees(const Scene& scene, const Judge& judge) {
  DrawOptions options;
  options.method = Method::nn74;
  options.tolerance = kTolerance;
  options.threads = 1;
  try {
    Drawing drawing(scene, kGrid, options);
    for (const DrawnLine& line : draw_lines(drawing, kFamilies[0])) judge.judge(line);
  } catch (const InputError&) {
    return;  // not a scene for the method
  }
}

void try_all(const TinyScene& tiny) {
  const Prepared prepared(tiny.scene);
  const Judge judge(*prepared.canonical, prepared.view);
  Drawing drawing = prepared.drawing();
  const auto rows = draw_lines(drawing, kFamilies[0]);
  for (const DrawnLine& line : rows) judge.judge(line);
  for (const ScanFamily& family : std::span(kFamilies).subspan(1))
    for (const DrawnLine& line : draw_lines(drawing, family)) judge.judge(line);
  draw_cells(drawing);
  draw_strokes(drawing, tiny.scene.bodies.size());
  expect_jump_equals_step(drawing, rows);
  if (!tiny.scene.solids.empty()) expect_keeping_changes_nothing(prepared);
  if (tiny.asked.threads) expect_threads_agree(prepared);
  if (tiny.asked.order) expect_order_does_not_count(tiny.scene, rows);
  if (tiny.asked.means) expect_means(drawing, place_error_of(*prepared.canonical, prepared.view));
  if (tiny.asked.method) expect_method_agrees(tiny.scene, judge);
}

}  // namespace
}  // namespace overstrike::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace overstrike::fuzz;
  const TinyScene tiny = tiny_scene(ByteSource(data, size));
  const WhenBroken tell([&] { return to_yaml(tiny.scene); });
  try_all(tiny);
  return 0;
}
