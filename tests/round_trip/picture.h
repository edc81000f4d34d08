#pragma once
// Scenes drawn on devices, and the image device's picture read back.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "devices/device.h"

namespace overstrike {

/// Density, cell by cell.
struct Picture {
  int columns = 0, rows = 0;
  std::vector<float> density;
  float at(int x, int y) const { return density[static_cast<std::size_t>(y) * columns + x]; }
};

/// A file of scenes/.
Scene scene_of(const std::string& name);

/// What the device writes.
std::string drawn(const Scene& scene, std::string_view device, const Settings& settings);

/// The image device's picture of a window that is `columns` x `rows` cells, each `aspect` times as
/// wide as high: written as float TIFF and read back.
Picture picture_of(const Scene& scene, int columns, int rows, double aspect);

/// A name for a file of this process, gone when this is.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& extension);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace overstrike
