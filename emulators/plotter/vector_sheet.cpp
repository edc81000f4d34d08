#include <cairo-pdf.h>
#include <cairo-svg.h>

#include "emulators/plotter/canvas.h"
#include "emulators/plotter/sheet.h"

namespace overstrike::emulator {
namespace {

constexpr double kPointsPerMm = 72 / 25.4;

class VectorSheet final : public Sheet {
 public:
  VectorSheet(const MachineProfile& machine, const std::filesystem::path& file, bool pdf)
      : machine_(machine), output_(file) {
    const double width = machine.width_mm * kPointsPerMm, height = machine.height_mm * kPointsPerMm;
    surface_.reset(
        pdf ? cairo_pdf_surface_create_for_stream(CairoOutput::write, &output_, width, height)
            : cairo_svg_surface_create_for_stream(CairoOutput::write, &output_, width, height));
    check(cairo_surface_status(surface_.get()));
    // The same input makes the same bytes: no time of day. The 7475A came out in 1983.
    if (pdf) {
      cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                     "1983-01-01T00:00:00Z");
    }
    context_ = pen_context(surface_.get(), machine, kPointsPerMm);
    cairo_set_source_rgb(context_.get(), 1, 1, 1);
    cairo_paint(context_.get());
  }

  void line(int pen, std::span<const PenPoint> points) override {
    const Pen& with = machine_.pens[static_cast<std::size_t>(pen - 1)];
    cairo_set_source_rgb(context_.get(), with.colour.red / 255.0, with.colour.green / 255.0,
                         with.colour.blue / 255.0);
    stroke(context_.get(), points, with.width_mm / machine_.limits.unit_mm);
  }

  void finish() override {
    check(cairo_status(context_.get()));
    cairo_surface_finish(surface_.get());
    output_.settle(cairo_surface_status(surface_.get()));
    output_.file.commit();
  }

 private:
  MachineProfile machine_;
  CairoOutput output_;  // outlives the surface, which may write when it is destroyed
  Surface surface_;
  Context context_;
};

}  // namespace

std::unique_ptr<Sheet> vector_sheet(const MachineProfile& machine,
                                    const std::filesystem::path& file, bool pdf) {
  return std::make_unique<VectorSheet>(machine, file, pdf);
}

}  // namespace overstrike::emulator
