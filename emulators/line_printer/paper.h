#pragma once
// Paper that the printed pages are drawn on.
#include <filesystem>
#include <memory>

#include "emulators/line_printer/carriage.h"

namespace overstrike::emulator {

/// Virtual: PNGs or one PDF.
class Paper {
 public:
  virtual ~Paper() = default;
  /// The longest page, in lines.
  virtual std::size_t most_lines() const = 0;
  virtual void page(const PrintedPage& page) = 0;
  /// Gives the files their names.
  virtual void finish() = 0;
};

std::unique_ptr<Paper> png_paper(const LinePrinterOptions& options,
                                 const std::filesystem::path& file);
std::unique_ptr<Paper> pdf_paper(const LinePrinterOptions& options,
                                 const std::filesystem::path& file);

}  // namespace overstrike::emulator
