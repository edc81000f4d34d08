#include "cli/timings.h"

#include <fmt/core.h>

#include <fstream>

namespace overstrike {

std::uint64_t peak_resident_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::uint64_t kibibytes = 0;
    if (word == "VmHWM:" && status >> kibibytes) return kibibytes * 1024;
  }
  return 0;
}

namespace {

bool has_solids(const RunTimings& t) { return t.phases.solids.spans > 0; }

std::string solids_as_json(const SolidCounts& c) {
  return fmt::format(
      ",\"solids\":{{\"spans\":{},\"crossings\":{},\"resorts\":{},\"decisions\":{},\"flips\":{},"
      "\"updates\":{}}}",
      c.spans, c.crossings, c.resorts, c.decisions, c.flips, c.updates);
}

std::string solids_as_text(const SolidCounts& c) {
  return fmt::format(
      "\nsolids: {} spans, {} crossings, {} layers put in order; followed {} times with {} "
      "operands "
      "entered or left and {} counters updated",
      c.spans, c.crossings, c.resorts, c.decisions, c.flips, c.updates);
}

}  // namespace

std::string timings_as_json(const RunTimings& t) {
  return fmt::format(
      "{{\"light_ms\":{:.3f},\"eye_ms\":{:.3f},\"scan_ms\":{:.3f},\"output_ms\":{:.3f},"
      "\"total_ms\":{:.3f},\"peak_bytes\":{}{}}}",
      t.phases.light_ms, t.phases.eye_ms, t.phases.scan_ms, t.phases.output_ms, t.total_ms,
      t.peak_bytes, has_solids(t) ? solids_as_json(t.phases.solids) : "");
}

std::string timings_as_text(const RunTimings& t) {
  return fmt::format(
      "I light {:.1f} ms, II eye {:.1f} ms, III scan {:.1f} ms, output {:.1f} ms; "
      "total {:.1f} ms, peak {:.1f} MB{}",
      t.phases.light_ms, t.phases.eye_ms, t.phases.scan_ms, t.phases.output_ms, t.total_ms,
      static_cast<double>(t.peak_bytes) / 1e6,
      has_solids(t) ? solids_as_text(t.phases.solids) : "");
}

}  // namespace overstrike
