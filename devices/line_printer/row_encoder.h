#pragma once
// From a row of densities to a line printer's bytes.
//
//   cr     strikes of a row joined by CR (0x0D), ended by one LF (0x0A)
//   asa    one record a strike, ended by LF: ' ' and the first strike, '+' (no advance) and each
//          further one; FORTRAN's carriage control acts before printing
//   plain  one strike, ended by one LF
//
// Trailing blanks of a strike are not sent; a strike that would be blank in the whole row is not
// sent at all. A row always has exactly one LF (asa: one record that advances), blank rows too.
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "devices/line_printer/tone_table.h"

namespace overstrike {

enum class PrinterStream : std::uint8_t { cr, asa, plain };

constexpr int kMostLevels = 64;
constexpr int kMostStrikes = 16;

class RowEncoder {
 public:
  /// Preconditions: at most kMostLevels levels of at most kMostStrikes strikes; one for plain.
  RowEncoder(const ToneTable& table, PrinterStream stream);

  /// Appends the row's bytes.
  void append(std::span<const float> densities, std::string& bytes);

 private:
  int levels_;
  PrinterStream stream_;
  /// strike_[k][level]: the character of the k-th strike or a blank.
  std::array<std::array<char, kMostLevels>, kMostStrikes> strike_;
  std::array<std::uint8_t, kMostLevels> strikes_of_level_{};
  std::vector<std::uint8_t> row_;
};

}  // namespace overstrike
