// Any bytes are a print stream, with control characters or with FORTRAN's carriage control: what is
// struck stands on the paper or is counted as lost, and no page is longer than asked.
#include <sstream>

#include "emulators/line_printer/carriage.h"
#include "tests/fuzz/fuzz.h"

namespace overstrike::fuzz {
namespace {

using namespace emulator;

constexpr int kColumns = 20;
constexpr std::size_t kMostLines = 50;

void print(const std::string& bytes, void (*reader)(std::istream&, Carriage&, LinePrinterReport&)) {
  std::istringstream in(bytes);
  LinePrinterReport report;
  std::uint64_t pages = 0, lines = 0, struck = 0;
  Carriage carriage(kColumns, kMostLines, report, [&](const PrintedPage& page) {
    expect(page.size() <= kMostLines, "a page is no longer than the paper takes");
    ++pages, lines += page.size();
    for (const PrintedLine& line : page) {
      expect(line.size() <= kColumns, "nothing is struck right of the carriage");
      for (const StruckCell& cell : line) struck += !cell.blank();
    }
  });
  try {
    reader(in, carriage, report);
  } catch (const Error&) {
    return;  // the page was too long
  }
  expect(pages > 0 && pages == report.pages && lines == report.lines, "pages are counted");
  expect(struck + report.overstrikes + report.beyond == report.strikes,
         "strikes are accounted for");
  expect(report.strikes + report.unprintable <= bytes.size(), "a strike takes a byte");
}

}  // namespace
}  // namespace overstrike::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(overstrike::fuzz::text_of(data, size));
  overstrike::fuzz::print(bytes, overstrike::emulator::print_ascii);
  overstrike::fuzz::print(bytes, overstrike::emulator::print_asa);
  return 0;
}
