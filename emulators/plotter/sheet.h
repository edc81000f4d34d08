#pragma once
// The sheet of paper that the ink falls on, drawn with Cairo.
#include <filesystem>
#include <memory>

#include "emulators/plotter/machine.h"
#include "emulators/plotter/profile.h"

namespace overstrike::emulator {

/// White paper. Ink covers what is below; ink of one pen over itself changes nothing.
class Sheet : public Ink {
 public:
  /// Writes the file; called once, last. Throws Error.
  virtual void finish() = 0;
};

/// Pixels. Each is the average over its area of the light that paper and ink reflect, sRGB-encoded:
/// seen from afar, a sheet half covered with black is as bright as reflectance 1/2. Up to 8 x 8
/// samples a pixel, fewer where they would take more than kMostSamples bytes.
std::unique_ptr<Sheet> png_sheet(const MachineProfile& machine, double dpi,
                                 const std::filesystem::path& file);
constexpr double kMostSamples = 256e6;

/// Lines, for `.pdf` and `.svg`.
std::unique_ptr<Sheet> vector_sheet(const MachineProfile& machine,
                                    const std::filesystem::path& file, bool pdf);

}  // namespace overstrike::emulator
