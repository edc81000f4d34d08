#include "devices/line_printer/row_encoder.h"

#include <algorithm>
#include <cassert>

namespace overstrike {

RowEncoder::RowEncoder(const ToneTable& table, PrinterStream stream)
    : levels_(static_cast<int>(table.levels.size())), stream_(stream) {
  assert(levels_ <= kMostLevels && table.most_strikes() <= kMostStrikes);
  assert(stream != PrinterStream::plain || table.most_strikes() <= 1);
  for (auto& characters : strike_) characters.fill(' ');
  for (int level = 0; level < levels_; ++level) {
    const std::string& strikes = table.levels[level].strikes;
    strikes_of_level_[level] = static_cast<std::uint8_t>(strikes.size());
    for (std::size_t k = 0; k < strikes.size(); ++k) strike_[k][level] = strikes[k];
  }
}

void RowEncoder::append(std::span<const float> densities, std::string& bytes) {
  row_.resize(densities.size());
  int strikes = 1;
  for (std::size_t i = 0; i < densities.size(); ++i) {
    row_[i] = static_cast<std::uint8_t>(nearest_level(densities[i], levels_));
    strikes = std::max<int>(strikes, strikes_of_level_[row_[i]]);
  }
  for (int k = 0; k < strikes; ++k) {
    if (stream_ == PrinterStream::asa) {
      bytes += k == 0 ? ' ' : '+';
    } else if (k > 0) {
      bytes += '\r';
    }
    const std::size_t begin = bytes.size();
    bytes.resize(begin + row_.size());
    std::transform(row_.begin(), row_.end(), bytes.begin() + static_cast<std::ptrdiff_t>(begin),
                   [&](std::uint8_t level) { return strike_[k][level]; });
    while (bytes.size() > begin && bytes.back() == ' ') bytes.pop_back();
    if (stream_ == PrinterStream::asa) bytes += '\n';
  }
  if (stream_ != PrinterStream::asa) bytes += '\n';
}

}  // namespace overstrike
