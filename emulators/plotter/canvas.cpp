#include "emulators/plotter/canvas.h"

#include <exception>
#include <string>

namespace overstrike::emulator {

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) {
    throw OutputError(std::string("the sheet cannot be drawn: ") + cairo_status_to_string(status));
  }
}

Context pen_context(cairo_surface_t* surface, const MachineProfile& machine, double dots_per_mm) {
  check(cairo_surface_status(surface));
  Context context(cairo_create(surface));
  const double dots = dots_per_mm * machine.limits.unit_mm;
  cairo_translate(context.get(), machine.origin_x_mm * dots_per_mm,
                  (machine.height_mm - machine.origin_y_mm) * dots_per_mm);
  cairo_scale(context.get(), dots, -dots);
  cairo_set_line_cap(context.get(), CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(context.get(), CAIRO_LINE_JOIN_ROUND);
  check(cairo_status(context.get()));
  return context;
}

void stroke(cairo_t* context, std::span<const PenPoint> points, double width) {
  cairo_set_line_width(context, width);
  cairo_move_to(context, points[0].x, points[0].y);
  for (const PenPoint& p : points.subspan(points.size() > 1 ? 1 : 0)) {
    cairo_line_to(context, p.x, p.y);
  }
  cairo_stroke(context);
}

cairo_status_t CairoOutput::write(void* self, const unsigned char* bytes, unsigned count) {
  CairoOutput& output = *static_cast<CairoOutput*>(self);
  if (output.failure) return CAIRO_STATUS_WRITE_ERROR;
  try {
    output.file.write(bytes, count);
    return CAIRO_STATUS_SUCCESS;
  } catch (...) {
    output.failure = std::current_exception();
    return CAIRO_STATUS_WRITE_ERROR;
  }
}

void CairoOutput::settle(cairo_status_t status) const {
  if (failure) std::rethrow_exception(failure);
  check(status);
}

}  // namespace overstrike::emulator
