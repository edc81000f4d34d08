#pragma once
// A set of numbers below n that finds the next one up or down quickly.
#include <bit>
#include <cstdint>
#include <vector>

namespace overstrike {

/// Two levels of bits: a word of the upper level tells which of 64 words below are not empty.
class RankSet {
 public:
  static constexpr std::size_t kNothing = ~std::size_t{0};

  explicit RankSet(std::size_t n) : low_(n / 64 + 1), high_(n / 4096 + 1) {}

  void insert(std::size_t i) {
    low_[i / 64] |= std::uint64_t{1} << i % 64;
    high_[i / 4096] |= std::uint64_t{1} << i / 64 % 64;
  }
  void erase(std::size_t i) {
    low_[i / 64] &= ~(std::uint64_t{1} << i % 64);
    if (low_[i / 64] == 0) high_[i / 4096] &= ~(std::uint64_t{1} << i / 64 % 64);
  }
  /// The smallest member >= i, or kNothing.
  std::size_t up(std::size_t i) const {
    std::size_t word = next(low_, i);
    if (word != kNothing || i / 64 + 1 >= low_.size()) return word;
    std::size_t block = i / 64 + 1;
    const std::size_t found = next(high_, block);
    if (found != kNothing) return next(low_, found * 64);
    for (block = block / 64 + 1; block < high_.size(); ++block)
      if (high_[block] != 0) return next(low_, next(high_, block * 64) * 64);
    return kNothing;
  }
  /// The largest member <= i, or kNothing.
  std::size_t down(std::size_t i) const {
    const std::size_t word = last(low_, i);
    if (word != kNothing || i < 64) return word;
    std::size_t block = i / 64 - 1;
    const std::size_t found = last(high_, block);
    if (found != kNothing) return last(low_, found * 64 + 63);
    for (block /= 64; block-- > 0;)
      if (high_[block] != 0) return last(low_, last(high_, block * 64 + 63) * 64 + 63);
    return kNothing;
  }

 private:
  /// The first set bit at or after i within i's own word.
  static std::size_t next(const std::vector<std::uint64_t>& words, std::size_t i) {
    const std::uint64_t rest = words[i / 64] >> i % 64;
    return rest == 0 ? kNothing : i + static_cast<std::size_t>(std::countr_zero(rest));
  }
  /// The last set bit at or before i within i's own word.
  static std::size_t last(const std::vector<std::uint64_t>& words, std::size_t i) {
    const std::uint64_t rest = words[i / 64] << (63 - i % 64);
    return rest == 0 ? kNothing : i - static_cast<std::size_t>(std::countl_zero(rest));
  }

  std::vector<std::uint64_t> low_, high_;
};

}  // namespace overstrike
