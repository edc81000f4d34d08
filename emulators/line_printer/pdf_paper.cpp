#include <cairo-pdf.h>
#include <fmt/core.h>

#include "emulators/line_printer/paper.h"
#include "emulators/line_printer/type_element.h"

namespace overstrike::emulator {
namespace {

constexpr double kPointsInInch = 72;
constexpr double kLongestPage = 14400;  // PDF 32000-1, annex C
constexpr std::size_t kMostPages = 10000;

class PdfPaper final : public Paper {
 public:
  PdfPaper(const LinePrinterOptions& options, const std::filesystem::path& file)
      : type_(options, kPointsInInch),
        output_(file),
        surface_(cairo_pdf_surface_create_for_stream(PrinterOutput::write, &output_, type_.width(),
                                                     type_.height(1))) {
    if (type_.width() > kLongestPage || type_.height(1) > kLongestPage)
      throw Error(fmt::format("paper {} inches wide is more than a PDF takes",
                              type_.width() / kPointsInInch));
    // The same stream makes the same file.
    cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                   "1970-01-01T00:00:00Z");
    context_.reset(cairo_create(surface_.get()));
    check();
    const double line = kPointsInInch / options.lpi;
    most_lines_ = 1 + static_cast<std::size_t>((kLongestPage - type_.height(1)) / line);
  }

  std::size_t most_lines() const override { return most_lines_; }

  void page(const PrintedPage& page) override {
    if (pages_++ == kMostPages) throw Error(fmt::format("more than {} pages", kMostPages));
    cairo_pdf_surface_set_size(surface_.get(), type_.width(), type_.height(page.size()));
    type_.use_on(context_.get());
    for (std::size_t number = 0; number < page.size(); ++number) {
      const std::vector<cairo_glyph_t>& glyphs = type_.place(page[number], number);
      if (!glyphs.empty())
        cairo_show_glyphs(context_.get(), glyphs.data(), static_cast<int>(glyphs.size()));
    }
    cairo_show_page(context_.get());
    check();
  }

  void finish() override {
    check();
    cairo_surface_finish(surface_.get());
    output_.settle(cairo_surface_status(surface_.get()));
    output_.file.commit();
  }

 private:
  void check() const { output_.settle(cairo_status(context_.get())); }

  TypeElement type_;
  PrinterOutput output_;
  PrinterSurface surface_;
  PrinterContext context_;
  std::size_t most_lines_ = 0, pages_ = 0;
};

}  // namespace

std::unique_ptr<Paper> pdf_paper(const LinePrinterOptions& options,
                                 const std::filesystem::path& file) {
  return std::make_unique<PdfPaper>(options, file);
}

}  // namespace overstrike::emulator
