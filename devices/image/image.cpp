#include "devices/image/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <tuple>
#include <utility>

#include "devices/image/formats.h"
#include "devices/image/load_module.h"
#include "devices/srgb.h"

namespace overstrike {
namespace {

constexpr int kLargest = 65536;
// From here on a PNG is written quickly rather than small: about four times as fast.
constexpr std::int64_t kManyCells = std::int64_t{1} << 22;
constexpr std::array<std::string_view, 4> kDepths = {"auto", "8", "16", "float"};

struct Request {
  const ImageFormat* format;
  std::string output;
  int columns, rows;
  int bits;
  double aspect;
};

std::string known_formats() {
  std::string text;
  for (const ImageFormat& format : image_formats())
    for (std::string_view extension : format.extensions)
      text += (text.empty() ? "" : ", ") + std::string(extension.substr(1));
  return text;
}

/// The name that chooses the format: the setting, the file's extension, or png for a stream.
std::string format_name(const SettingReader& settings, std::string_view output) {
  const std::string given = settings.text("format");
  if (given != "auto") return given;
  const std::string extension = std::filesystem::path(output).extension().string();
  return extension.empty() ? "png" : extension.substr(1);
}

const ImageFormat& format_of(const std::string& name) {
  if (const ImageFormat* format = find_image_format(name)) return *format;
  throw InputError({}, fmt::format("'{}' is no picture format that is known", name),
                   "known are " + known_formats());
}

int bits_of(const SettingReader& settings, const ImageFormat& format) {
  const std::string depth = settings.choice("depth", kDepths);
  if (depth == "auto") return format.eight ? 8 : 32;
  const bool holds = depth == "8" ? format.eight : depth == "16" ? format.sixteen : format.real;
  if (holds) return depth == "float" ? 32 : depth == "16" ? 16 : 8;
  std::string most = format.eight ? "8" : "";
  if (format.sixteen) most += most.empty() ? "16" : ", 16";
  if (format.real) most += most.empty() ? "float" : ", float";
  settings.refuse("depth", fmt::format("one that {} holds ({})", format.name, most));
}

Request read_request(const SettingReader& settings, std::string_view output) {
  Request request;
  request.format = &format_of(format_name(settings, output));
  request.output = output;
  std::tie(request.columns, request.rows) =
      settings.size("size", std::min(kLargest, request.format->largest));
  request.bits = bits_of(settings, *request.format);
  request.aspect = settings.number("aspect", 0.1, 10);
  return request;
}

class Image final : public Device {
 public:
  Image(Request request, std::unique_ptr<Transport> transport)
      : request_(std::move(request)), transport_(std::move(transport)) {
    if (request_.bits != 32) encode_.emplace(request_.bits == 8 ? 255 : 65535);
  }
  Image(const Image&) = delete;
  Image& operator=(const Image&) = delete;
  ~Image() override {
    if (writer_ != nullptr) image_module().abandon(writer_);
  }

  Layout layout() const override {
    Layout layout;
    layout.grid = {static_cast<double>(request_.columns), static_cast<double>(request_.rows),
                   request_.aspect, 1};
    layout.cells = true;
    return layout;
  }

  void begin() override {
    const std::string path = transport_->path_to_write().string();
    OverstrikeImageRequest open{};
    open.path = path.c_str();
    open.format = request_.format->name.data();
    open.width = request_.columns;
    open.height = request_.rows;
    open.channels = request_.format->channels;
    open.bits = request_.bits;
    open.pixel_aspect = request_.aspect;
    open.fast = std::int64_t{request_.columns} * request_.rows >= kManyCells;
    writer_ = image_module().open(&open, error_.data(), error_.size());
    if (writer_ == nullptr) fail();
  }

  void cells(const CellRow& row) override {
    assert(row.density.size() == static_cast<std::size_t>(request_.columns));
    const void* samples = nullptr;
    if (request_.bits == 8)
      samples = encoded(row.density, eight_);
    else if (request_.bits == 16)
      samples = encoded(row.density, sixteen_);
    else
      samples = linear(row.density);
    if (!image_module().write_row(writer_, samples, error_.data(), error_.size())) fail();
  }

  void end() override {
    void* writer = std::exchange(writer_, nullptr);
    if (!image_module().close(writer, error_.data(), error_.size())) fail();
    transport_->finish();
  }

 private:
  template <typename Code>
  const void* encoded(std::span<const float> density, std::vector<Code>& codes) {
    codes.resize(density.size());
    for (std::size_t i = 0; i < density.size(); ++i)
      codes[i] = static_cast<Code>((*encode_)(1 - density[i]));
    return codes.data();
  }

  const void* linear(std::span<const float> density) {
    real_.resize(density.size());
    for (std::size_t i = 0; i < density.size(); ++i) real_[i] = 1 - density[i];
    return real_.data();
  }

  [[noreturn]] void fail() const {
    const bool stream = request_.output == "-";
    const std::string where = stream ? "to standard output" : "'" + request_.output + "'";
    throw WorkError(fmt::format("cannot write {}: {}", where, error_.data()));
  }

  Request request_;
  std::unique_ptr<Transport> transport_;
  std::optional<SrgbEncoder> encode_;
  void* writer_ = nullptr;
  std::vector<std::uint8_t> eight_;
  std::vector<std::uint16_t> sixteen_;
  std::vector<float> real_;
  std::array<char, 512> error_{};
};

std::vector<std::string_view> all_extensions() {
  std::vector<std::string_view> all;
  for (const ImageFormat& format : image_formats())
    all.insert(all.end(), format.extensions.begin(), format.extensions.end());
  return all;
}

}  // namespace

DeviceKind image_device() {
  DeviceKind kind;
  kind.name = "image";
  kind.summary = "grey pictures in any format that OpenImageIO writes";
  kind.extensions = all_extensions();
  kind.settings = {
      {"size", "800x600", "columns x rows of pixels"},
      {"format", "auto", "png, tiff, exr, ...; auto: by the output's extension, png for a stream"},
      {"depth", "auto", "8, 16 (sRGB) or float (linear); auto: 8, or float where there is no 8"},
      {"aspect", "1", "width of a pixel in units of its height (0.1 to 10)"}};
  kind.make = [kind](const Settings& given, std::string_view output,
                     std::unique_ptr<Transport> transport) {
    return std::make_unique<Image>(read_request(SettingReader(kind, given), output),
                                   std::move(transport));
  };
  return kind;
}

}  // namespace overstrike
