#pragma once
// What passes between the image device and overstrike_image.so, the module that links OpenImageIO
// (loading it takes 0.3 s and 128 MB, which a page or a plot should not pay). C, so that nothing of
// C++ has to match; no exception crosses it.
#include <cstddef>

extern "C" {

/// Raised whenever a struct or a meaning here changes; a module of another number is refused.
#define OVERSTRIKE_IMAGE_ABI 1

struct OverstrikeImageRequest {
  const char* path;
  const char* format;  ///< OpenImageIO's name or an extension of it: "png"
  int width, height;
  int channels;  ///< 1, or 3: the grey is repeated
  int bits;      ///< 8 or 16: unsigned, sRGB-encoded; 32: float, linear
  double pixel_aspect;
  int fast;  ///< not 0: large, to be written quickly rather than small
};

/// Functions that can fail return 0 or null and leave a text in `error`.
struct OverstrikeImageModule {
  int abi;
  void* (*open)(const OverstrikeImageRequest*, char* error, std::size_t error_size);
  /// `samples`: `width` values of the request's type. Rows come in order, top to bottom.
  int (*write_row)(void* writer, const void* samples, char* error, std::size_t error_size);
  /// After the last row. The writer is gone, whatever is returned.
  int (*close)(void* writer, char* error, std::size_t error_size);
  /// Instead of close(): the file is of no use.
  void (*abandon)(void* writer);
};

/// The one symbol of the module.
const OverstrikeImageModule* overstrike_image_module();
}
