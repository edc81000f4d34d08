#pragma once
// The contract of a device: what plugs in between core and a transport. docs/add-a-device.md begins
// with the null device.
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/picture.h"
#include "devices/transport/transport.h"

namespace overstrike {

/// What a device asks of core for one picture.
struct Layout {
  Grid grid;
  bool cells = false;               ///< area averages, row by row
  bool strokes = false;             ///< visible lines
  std::vector<ScanFamily> hatches;  ///< density runs on these families of lines
  double tolerance =
      0.05;  ///< the default for --tolerance, in grid units: what the device can resolve
};

/// Virtual because devices really plug in. Calls come from one thread, in this order: layout,
/// begin, strokes (once, if wanted), hatch (family by family, rows in order), cells (rows in
/// order), end. After an exception only the destructor. A device may block in its transport; it
/// throws WorkError only; it never prints, exits or keeps rows.
class Device {
 public:
  virtual ~Device() = default;
  /// Called first, once; pure: asks for nothing, opens nothing.
  virtual Layout layout() const = 0;
  virtual void begin() {}
  virtual void strokes(std::span<const Stroke>) {}
  /// `family` is an index into Layout::hatches.
  virtual void hatch(std::size_t /*family*/, const RunRow&) {}
  virtual void cells(const CellRow&) {}
  /// Everything was said: write what is left and call the transport's finish().
  virtual void end() = 0;
  /// After end(): what could not be drawn as asked (lines cut at the border of a sheet).
  virtual std::vector<Diagnostic> warnings() const { return {}; }
};

/// One setting a device takes, as `overstrike devices NAME` and --help list it. Values are text; a
/// factory throws InputError that names the setting, what was found and what was expected.
struct Setting {
  std::string_view name;     ///< "lpi"
  std::string_view value;    ///< default, as text
  std::string_view meaning;  ///< "lines to the inch (6 or 8)"
};

using Settings = std::vector<std::pair<std::string, std::string>>;

struct DeviceKind {
  std::string_view name;  ///< "line-printer"
  std::string_view summary;
  std::vector<std::string_view> extensions;  ///< ".txt", ".lpt"
  std::vector<Setting> settings;
  /// Settings not given are at their defaults. `output_name` is the final file name or "-" (its
  /// extension can choose the format).
  std::function<std::unique_ptr<Device>(const Settings& given, std::string_view output_name,
                                        std::unique_ptr<Transport> transport)>
      make;
};

/// All devices; the registry has one line for each (devices/registry.cpp).
const std::vector<DeviceKind>& device_kinds();
/// By name; nullptr when there is none.
const DeviceKind* find_device(std::string_view name);
/// By the output's extension, case ignored; nullptr when none claims it.
const DeviceKind* device_for_file(std::string_view output_name);

/// Reads settings against a device's list: unknown names throw InputError with the nearest known
/// one. Helpers parse values and throw InputError with the setting's name, what was found and what
/// was expected. Asking for a name that the device does not list is a mistake in the device.
class SettingReader {
 public:
  SettingReader(const DeviceKind& kind, const Settings& given);
  std::string text(std::string_view name) const;
  double number(std::string_view name, double low, double high) const;
  int integer(std::string_view name, int low, int high) const;
  /// One of a list of words.
  std::string choice(std::string_view name, std::span<const std::string_view> words) const;
  /// "COLSxROWS", each 1..most.
  std::pair<int, int> size(std::string_view name, int most) const;
  bool given(std::string_view name) const;
  /// For values that the helpers do not know: throws InputError "NAME must be EXPECTED, found 'X'".
  [[noreturn]] void refuse(std::string_view name, std::string_view expected) const;

 private:
  const std::string& value(std::string_view name) const;

  std::vector<std::pair<std::string, std::string>> values_;
  std::vector<std::string> given_;
  std::string device_;
};

}  // namespace overstrike
