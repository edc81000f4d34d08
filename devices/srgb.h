#pragma once
// The sRGB transfer (IEC 61966-2-1) with the same codes on every machine: no pow.
#include <cstdint>
#include <vector>

namespace overstrike {

/// The linear value that the encoded value v (0..1) stands for: v / 12.92 up to 0.04045, else
/// ((v + 0.055) / 1.055) ^ 2.4. Basic arithmetic only; within a few units of the last place.
double srgb_to_linear(double v);

/// Linear values to codes 0..most, rounded to nearest: code k from where k - 1/2 decodes to.
class SrgbEncoder {
 public:
  /// 255 or 65535.
  explicit SrgbEncoder(int most);
  /// Not a number and what is below 0 gives 0; above 1 gives the largest code.
  std::uint16_t operator()(float linear) const {
    if (!(linear > 0)) return 0;
    if (linear >= 1) return most_;
    std::uint16_t code = first_[static_cast<std::size_t>(linear * kBins)];
    while (code < most_ && linear >= from_[code + 1u]) ++code;
    return code;
  }

 private:
  // A power of two, so that the product is exact. In the darkest bin lie 13 of 65536 codes.
  static constexpr float kBins = 65536;
  std::uint16_t most_;
  std::vector<double> from_;          ///< per code the least value that has it
  std::vector<std::uint16_t> first_;  ///< per bin the code of its least value
};

}  // namespace overstrike
