#include "devices/image/formats.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace overstrike {
namespace {

using Names = std::string_view;

constexpr std::array kPng = {Names(".png")};
constexpr std::array kOpenexr = {Names(".exr")};
constexpr std::array kTiff = {Names(".tif"), Names(".tiff")};
constexpr std::array kJpeg = {Names(".jpg"), Names(".jpeg"), Names(".jpe"), Names(".jfif")};
constexpr std::array kPgm = {Names(".pgm"), Names(".pnm")};
constexpr std::array kPpm = {Names(".ppm")};
constexpr std::array kWebp = {Names(".webp")};
constexpr std::array kBmp = {Names(".bmp"), Names(".dib")};
constexpr std::array kTarga = {Names(".tga")};
constexpr std::array kHdr = {Names(".hdr")};
constexpr std::array kGif = {Names(".gif")};
constexpr std::array kFits = {Names(".fits")};
constexpr std::array kSgi = {Names(".sgi"), Names(".bw")};
constexpr std::array kZfile = {Names(".zfile")};

constexpr int kLargest = 65536;

// Not here, for what was seen when they were tried (docs/image.md): IFF refuses scan lines; HEIF
// reads beyond the end of a row (AddressSanitizer); RLA puts in the time, and DPX the name of the
// temporary file; JPEG 2000 files under a limit of size were reported as written, and small ones
// could not be read back; ICO overruns memory; PBM comes out as PGM.
constexpr ImageFormat kFormats[] = {
    {"png", kPng, true, true, false, 1, kLargest},
    {"openexr", kOpenexr, false, false, true, 1, kLargest},
    {"tiff", kTiff, true, true, true, 1, kLargest},
    {"jpeg", kJpeg, true, false, false, 1, 65500},
    {"pgm", kPgm, true, false, false, 1, kLargest},
    {"ppm", kPpm, true, false, false, 3, kLargest},
    {"webp", kWebp, true, false, false, 3, 16383},
    {"bmp", kBmp, true, false, false, 1, kLargest},
    {"targa", kTarga, true, false, false, 1, 65535},
    {"hdr", kHdr, false, false, true, 3, kLargest},
    {"gif", kGif, true, false, false, 3, 65535},
    {"fits", kFits, true, false, true, 1, kLargest},
    {"sgi", kSgi, true, true, false, 1, 65535},
    {"zfile", kZfile, false, false, true, 1, 32767},
};

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

}  // namespace

std::span<const ImageFormat> image_formats() { return kFormats; }

const ImageFormat* find_image_format(std::string_view name) {
  const std::string wanted = lower(name.starts_with('.') ? name.substr(1) : name);
  const auto is = [&](std::string_view extension) { return extension.substr(1) == wanted; };
  for (const ImageFormat& format : kFormats)
    if (format.name == wanted ||
        std::any_of(format.extensions.begin(), format.extensions.end(), is))
      return &format;
  return nullptr;
}

}  // namespace overstrike
