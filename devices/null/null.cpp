#include "devices/null/null.h"

#include <fmt/format.h>

#include <utility>

namespace overstrike {
namespace {

constexpr int kLargest = 65536;

class Null final : public Device {
 public:
  Null(const SettingReader& settings, std::unique_ptr<Transport> transport)
      : transport_(std::move(transport)) {
    const auto [columns, rows] = settings.size("size", kLargest);
    layout_.grid = {static_cast<double>(columns), static_cast<double>(rows), 1, 1};
    layout_.cells = true;
    layout_.strokes = true;
    layout_.hatches = {ScanFamily{}};
  }

  Layout layout() const override { return layout_; }

  void strokes(std::span<const Stroke> strokes) override {
    strokes_ += strokes.size();
    for (const Stroke& stroke : strokes) points_ += stroke.points.size();
  }

  void hatch(std::size_t, const RunRow& row) override {
    ++lines_;
    runs_ += row.runs.size();
  }

  void cells(const CellRow& row) override {
    ++rows_;
    cells_ += row.density.size();
    for (float density : row.density) inked_ += density > 0;
  }

  void end() override {
    transport_->write(fmt::format("strokes {} of {} points\nlines {} of {} runs\n", strokes_,
                                  points_, lines_, runs_));
    transport_->write(fmt::format("rows {} of {} cells, {} inked\n", rows_, cells_, inked_));
    transport_->finish();
  }

 private:
  std::unique_ptr<Transport> transport_;
  Layout layout_;
  std::size_t strokes_ = 0, points_ = 0, lines_ = 0, runs_ = 0, rows_ = 0, cells_ = 0, inked_ = 0;
};

}  // namespace

DeviceKind null_device() {
  DeviceKind kind;
  kind.name = "null";
  kind.summary = "draws nothing and counts what it gets";
  kind.settings = {{"size", "135x180", "columns x rows of the grid"}};
  kind.make = [kind](const Settings& given, std::string_view,
                     std::unique_ptr<Transport> transport) {
    return std::make_unique<Null>(SettingReader(kind, given), std::move(transport));
  };
  return kind;
}

}  // namespace overstrike
