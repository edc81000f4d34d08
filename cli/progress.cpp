#include "cli/progress.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>

namespace overstrike {
namespace {

constexpr auto kPatience = std::chrono::milliseconds(500);  // shorter work shows no bar
constexpr auto kRefresh = std::chrono::milliseconds(100);
constexpr int kWidth = 40;

}  // namespace

std::string progress_bar(double fraction) {
  const double part = std::clamp(fraction, 0.0, 1.0);
  const int full = static_cast<int>(part * kWidth);
  return fmt::format("[{:#<{}}{:.<{}}] {:3}%", "", full, "", kWidth - full,
                     static_cast<int>(part * 100));
}

Progress::Progress(bool shown) : shown_(shown), next_(Clock::now() + kPatience) {}

void Progress::show(double fraction) {
  if (!shown_ || Clock::now() < next_) return;
  next_ = Clock::now() + kRefresh;
  drawn_ = true;
  fmt::print(stderr, "\r{}", progress_bar(fraction));
  std::fflush(stderr);
}

Progress::~Progress() {
  if (!drawn_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
}

}  // namespace overstrike
