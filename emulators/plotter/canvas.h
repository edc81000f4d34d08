#pragma once
// Cairo surfaces and contexts that free themselves and report their failures.
#include <cairo.h>

#include <memory>
#include <span>

#include "emulators/output_file.h"
#include "emulators/plotter/profile.h"

namespace overstrike::emulator {

struct FreeCairo {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, FreeCairo>;
using Context = std::unique_ptr<cairo_t, FreeCairo>;

/// Throws OutputError with Cairo's message unless all is well.
void check(cairo_status_t status);

/// A context whose units are the machine's: plotter units from its origin, y up, on a surface with
/// `dots_per_mm`; round pens. Ink is drawn in place of what is below.
Context pen_context(cairo_surface_t* surface, const MachineProfile& machine, double dots_per_mm);

/// Strokes the line; a single point is a dot.
void stroke(cairo_t* context, std::span<const PenPoint> points, double width);

/// Cairo's writer to an OutputFile (the closure); an exception is kept in it for rethrow().
struct CairoOutput {
  explicit CairoOutput(const std::filesystem::path& path) : file(path) {}
  static cairo_status_t write(void* self, const unsigned char* bytes, unsigned count);
  /// What went wrong while Cairo was writing, or check(status).
  void settle(cairo_status_t status) const;
  OutputFile file;
  std::exception_ptr failure;
};

}  // namespace overstrike::emulator
