#include "devices/srgb.h"

namespace overstrike {
namespace {

// x^(1/5) for x in (0, 1] by Newton's iteration from above, which falls until rounding stops it.
double fifth_root(double x) {
  double root = 1;
  for (;;) {
    const double next = (4 * root + x / (root * root * root * root)) / 5;
    if (next >= root) return root;
    root = next;
  }
}

}  // namespace

double srgb_to_linear(double v) {
  if (v <= 0.04045) return v / 12.92;
  const double u = (v + 0.055) / 1.055;
  if (u >= 1) return 1;
  const double root = fifth_root(u * u);  // u^2.4 = u^2 * (u^2)^(1/5)
  return u * u * root;
}

SrgbEncoder::SrgbEncoder(int most)
    : most_(static_cast<std::uint16_t>(most)),
      from_(static_cast<std::size_t>(most) + 1),
      first_(static_cast<std::size_t>(kBins)) {
  for (std::size_t code = 1; code < from_.size(); ++code)
    from_[code] = srgb_to_linear((static_cast<double>(code) - 0.5) / most);
  std::uint16_t code = 0;
  for (std::size_t bin = 0; bin < first_.size(); ++bin) {
    while (code < most_ && static_cast<double>(bin) / kBins >= from_[code + 1u]) ++code;
    first_[bin] = code;
  }
}

}  // namespace overstrike
