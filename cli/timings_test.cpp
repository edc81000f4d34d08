#include "cli/timings.h"

#include <gtest/gtest.h>

namespace overstrike {
namespace {

constexpr RunTimings kTimings{{0.125, 2, 30.5, 4, {}}, 40.25, 12345678};

TEST(Timings, JsonIsOneLineOfSixNumbers) {
  EXPECT_EQ(timings_as_json(kTimings),
            "{\"light_ms\":0.125,\"eye_ms\":2.000,\"scan_ms\":30.500,\"output_ms\":4.000,"
            "\"total_ms\":40.250,\"peak_bytes\":12345678}");
}

TEST(Timings, TextNamesThePhasesOfThePaper) {
  EXPECT_EQ(timings_as_text(kTimings),
            "I light 0.1 ms, II eye 2.0 ms, III scan 30.5 ms, output 4.0 ms; "
            "total 40.2 ms, peak 12.3 MB");
}

TEST(Timings, SolidsAreCountedWhereThereAreAny) {
  RunTimings timings = kTimings;
  timings.phases.solids = {7, 6, 5, 4, 3, 2};
  EXPECT_EQ(timings_as_json(timings),
            "{\"light_ms\":0.125,\"eye_ms\":2.000,\"scan_ms\":30.500,\"output_ms\":4.000,"
            "\"total_ms\":40.250,\"peak_bytes\":12345678,\"solids\":{\"spans\":7,\"crossings\":6,"
            "\"resorts\":5,\"decisions\":4,\"flips\":3,\"updates\":2}}");
  EXPECT_EQ(timings_as_text(timings),
            timings_as_text(kTimings) +
                "\nsolids: 7 spans, 6 crossings, 5 layers put in order; followed 4 times with 3 "
                "operands entered or left and 2 counters updated");
}

TEST(Timings, TheLargestResidentSizeIsKnown) {
  EXPECT_GT(peak_resident_bytes(), 100'000u);  // a process with a C++ library takes more
}

}  // namespace
}  // namespace overstrike
