#include "core/visibility/edge_order.h"

namespace overstrike {

void EdgeOrder::set_line(std::size_t at, const SlackLine& line) {
  x0_[at] = line.x0, y0_[at] = line.y0, slope_[at] = line.slope;
  others_[at].y1 = line.y1, others_[at].slack = line.slack;
}

std::size_t EdgeOrder::next_due(std::size_t from, double y) const {
  while (from < size() && until_[from] > y) ++from;
  return from;
}

std::size_t EdgeOrder::next_showing_other(std::size_t from, Index face) const {
  while (from < size() && (shows_[from] == face || shows_[from] == kNoSpan)) ++from;
  return from;
}

double EdgeOrder::due() const {
  // Side by side, as each would wait for the one before.
  double due[4] = {HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL};
  std::size_t i = 0;
  for (; i + 4 <= until_.size(); i += 4)
    for (std::size_t k = 0; k < 4; ++k) due[k] = until_[i + k] < due[k] ? until_[i + k] : due[k];
  for (; i < until_.size(); ++i) due[0] = until_[i] < due[0] ? until_[i] : due[0];
  return std::min(std::min(due[0], due[1]), std::min(due[2], due[3]));
}

void EdgeOrder::turn_to(double y) {
  for (std::size_t i = 0; i < x_.size(); ++i) x_[i] = x0_[i] + (y - y0_[i]) * slope_[i];
}

std::size_t EdgeOrder::next_out_of_order(std::size_t from) const {
  if (from == 0) from = 1;
  while (from < x_.size() && x_[from - 1] < x_[from]) ++from;
  return std::min(from, x_.size());
}

void EdgeOrder::insert(std::size_t at, Index node, const SlackLine& line, double y) {
  each([at](auto& of) { of.emplace(of.begin() + static_cast<std::ptrdiff_t>(at)); });
  others_[at].node = node, shows_[at] = kNoSpan;
  set_line(at, line), touch(at);
  x_[at] = line.x_at(y);
}

void EdgeOrder::erase(std::size_t at) {
  each([at](auto& of) { of.erase(of.begin() + static_cast<std::ptrdiff_t>(at)); });
}

void EdgeOrder::swap(std::size_t at) {
  each([at](auto& of) { std::swap(of[at], of[at - 1]); });
}

void EdgeOrder::clear() {
  each([](auto& of) { of.clear(); });
}

}  // namespace overstrike
