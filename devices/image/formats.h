#pragma once
// The picture formats that OpenImageIO writes, and what each can hold of a grey picture.
#include <span>
#include <string_view>

namespace overstrike {

/// As tried with OpenImageIO 2.4 (docs/image.md).
struct ImageFormat {
  std::string_view name;                         ///< OpenImageIO finds the writer by it
  std::span<const std::string_view> extensions;  ///< with the dot
  bool eight, sixteen, real;                     ///< sample types it keeps
  int channels;                                  ///< 3 where it has no grey
  int largest;                                   ///< columns or rows
};

std::span<const ImageFormat> image_formats();
/// By the format's name or an extension, with or without the dot, case ignored; nullptr when
/// unknown.
const ImageFormat* find_image_format(std::string_view name);

}  // namespace overstrike
