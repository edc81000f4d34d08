#include "tests/round_trip/picture.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <unistd.h>

#include <stdexcept>

#include "devices/draw.h"
#include "scenes/readers/read.h"

namespace overstrike {
namespace {

/// To the device's own tolerance.
void draw_on(const Scene& scene, Device& device) {
  DrawOptions options;
  options.tolerance = 0;
  draw(scene, device, options);
}

}  // namespace

Scene scene_of(const std::string& name) {
  return read_scene(std::filesystem::path(OVERSTRIKE_SOURCE_DIR) / "scenes" / name).scene;
}

std::string drawn(const Scene& scene, std::string_view device, const Settings& settings) {
  std::string bytes;
  draw_on(scene, *find_device(device)->make(settings, "-", open_memory(bytes)));
  return bytes;
}

Picture picture_of(const Scene& scene, int columns, int rows, double aspect) {
  const ScratchFile file(".tif");
  const Settings settings{{"size", fmt::format("{}x{}", columns, rows)},
                          {"aspect", fmt::format("{}", aspect)},
                          {"depth", "float"}};
  const std::string name = file.path().string();
  draw_on(scene, *find_device("image")->make(settings, name, open_file(name)));
  const auto input = OIIO::ImageInput::open(name);
  Picture picture{columns, rows, std::vector<float>(std::size_t(columns) * rows)};
  if (!input || input->spec().width != columns || input->spec().height != rows ||
      !input->read_image(0, 0, 0, 1, OIIO::TypeDesc::FLOAT, picture.density.data()))
    throw std::runtime_error(name + " cannot be read back");
  for (float& value : picture.density) value = 1 - value;
  return picture;
}

ScratchFile::ScratchFile(const std::string& extension) {
  static int count = 0;
  path_ = std::filesystem::temp_directory_path() /
          fmt::format("round_trip.{}.{}{}", ::getpid(), ++count, extension);
}

ScratchFile::~ScratchFile() {
  std::error_code gone;
  std::filesystem::remove(path_, gone);
}

}  // namespace overstrike
