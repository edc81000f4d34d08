#pragma once
// What took how long: NN74's phases, as text and as one line of JSON.
#include <cstdint>
#include <string>

#include "core/drawing.h"

namespace overstrike {

struct RunTimings {
  Timings phases;
  double total_ms = 0;           ///< reading the scene and everything else included
  std::uint64_t peak_bytes = 0;  ///< the process's largest resident size
};

/// VmHWM of /proc/self/status in bytes; 0 where there is none.
std::uint64_t peak_resident_bytes();

/// {"light_ms":0.123,"eye_ms":...,"scan_ms":...,"output_ms":...,"total_ms":...,"peak_bytes":...}
/// and, where Boolean solids were drawn along lines, before the last brace
/// ,"solids":{"spans":...,"crossings":...,"resorts":...,"decisions":...,"flips":...,"updates":...}
std::string timings_as_json(const RunTimings&);
/// I light 0.1 ms, II eye 0.2 ms, III scan 0.3 ms, output 0.4 ms; total 1.0 ms, peak 12.3 MB
/// and a second line that says the same of solids in words.
std::string timings_as_text(const RunTimings&);

}  // namespace overstrike
