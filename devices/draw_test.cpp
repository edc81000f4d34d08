#include "devices/draw.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace overstrike {
namespace {

using testing::ElementsAre;

/// Writes down what it is called with, each kind of call once in a row.
class Witness : public Device {
 public:
  explicit Witness(Layout layout) : layout_(std::move(layout)) {}
  Layout layout() const override { return layout_; }
  void begin() override { note("begin"); }
  void strokes(std::span<const Stroke> strokes) override {
    note(strokes.empty() ? "no strokes" : "strokes");
  }
  void hatch(std::size_t family, const RunRow& row) override {
    note("hatch " + std::to_string(family));
    runs += row.runs.size();
  }
  void cells(const CellRow& row) override {
    note("cells");
    EXPECT_EQ(row.row, rows++);
  }
  void end() override { note("end"); }
  std::vector<Diagnostic> warnings() const override {
    return {{Severity::warning, {}, "the pen is dry", {}, {}}};
  }

  std::vector<std::string> calls;
  std::size_t runs = 0;
  std::int64_t rows = 0;

 private:
  void note(const std::string& call) {
    if (calls.empty() || calls.back() != call) calls.push_back(call);
  }
  Layout layout_;
};

Scene box() {
  Scene scene;
  Body body;
  body.shape = std::make_shared<const Shape>(Box{{2, 2, 2}});
  scene.bodies.push_back(std::move(body));
  scene.light = Direction{-20, 45};
  return scene;
}

Layout layout_of_everything() {
  Layout layout;
  layout.grid = {30, 20, 1, 1};
  layout.cells = layout.strokes = true;
  layout.hatches = {ScanFamily{}, ScanFamily{45, 2, 0}};
  return layout;
}

TEST(Draw, ADeviceIsCalledInTheOrderOfItsContract) {
  Witness device(layout_of_everything());
  const DrawReport report = draw(box(), device, {});
  EXPECT_THAT(device.calls, ElementsAre("begin", "strokes", "hatch 0", "hatch 1", "cells", "end"));
  EXPECT_EQ(device.rows, 20);
  EXPECT_GT(device.runs, 0u);
  EXPECT_GE(report.timings.output_ms, 0);
}

TEST(Draw, ADeviceGetsNothingThatItDoesNotWant) {
  Layout layout;
  layout.grid = {30, 20, 1, 1};
  Witness device(layout);
  draw(box(), device, {});
  EXPECT_THAT(device.calls, ElementsAre("begin", "end"));
}

TEST(Draw, WarningsOfTheDeviceComeLast) {
  Witness device(layout_of_everything());
  const DrawReport report = draw(box(), device, {});
  ASSERT_FALSE(report.warnings.empty());
  EXPECT_EQ(report.warnings.back().message, "the pen is dry");
}

TEST(Draw, TheLayoutsToleranceIsTheDefault) {
  // A coarser tolerance gives a round body fewer facets: fewer runs on the same lines.
  Scene scene;
  Body body;
  body.shape = std::make_shared<const Shape>(Ellipsoid{{1, 1, 1}});
  scene.bodies.push_back(std::move(body));
  scene.light = Direction{-20, 45};
  const auto runs = [&](double of_layout, double of_options) {
    Layout layout;
    layout.grid = {100, 100, 1, 1};
    layout.hatches = {ScanFamily{}};
    layout.tolerance = of_layout;
    Witness device(layout);
    DrawOptions options;
    options.tolerance = of_options;
    draw(scene, device, options);
    return device.runs;
  };
  EXPECT_EQ(runs(2, 0), runs(0.05, 2));
  EXPECT_GT(runs(0.05, 0), runs(2, 0));
}

}  // namespace
}  // namespace overstrike
