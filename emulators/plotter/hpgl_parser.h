#pragma once
// HP-GL as a plotter's parser takes it: instructions and their numbers, one after another.
#include <cstdint>
#include <istream>
#include <string>

namespace overstrike::emulator {

/// One thing found in the stream. `byte` counts from 0.
struct HpglEvent {
  enum class Kind {
    instruction,  ///< `name` is its mnemonic in capitals; one letter when the second is missing
    number,       ///< a parameter of the instruction
    end,          ///< the instruction is complete: `;`, the next mnemonic or the end of the stream
    stray,        ///< a number outside any instruction, or a byte that means nothing
    none,         ///< the stream has ended
  };
  Kind kind = Kind::none;
  std::string name;
  double number = 0;
  std::uint64_t byte = 0;
};

/// Takes mnemonics in both cases, parameters separated by commas, blanks, control characters or a
/// sign, instructions ended by `;` or by the next mnemonic. Skips what is no HP-GL: ESC . device
/// control even between two digits (a plotter acts on it at once and never buffers it), PCL's
/// ESC % and ESC letter with PJL lines after them, the texts of labels and messages, encoded
/// polylines, symbols. Keeps no more than one number: memory is bounded whatever the input.
class HpglParser {
 public:
  explicit HpglParser(std::istream& in) : in_(*in.rdbuf()) { advance(); }
  HpglEvent next();

 private:
  static constexpr int kEnd = -1;
  static constexpr int kNoByte = -2;

  int raw();
  /// Moves on to the next byte of HP-GL.
  void advance();
  void skip_escape();
  void skip_device_control();
  void skip_pcl();
  HpglEvent mnemonic();
  bool number(double& value);
  void skip_text(const std::string& name);
  void skip_through(int last);
  void skip_quoted();

  std::streambuf& in_;
  std::uint64_t read_ = 0;
  int pushed_back_ = kNoByte;  ///< a raw byte to be read again
  int look_ = kEnd;            ///< the byte of HP-GL that comes next
  std::uint64_t look_byte_ = 0;
  bool in_instruction_ = false;
  int label_end_ = 3;  ///< ETX, until DT says otherwise
};

}  // namespace overstrike::emulator
