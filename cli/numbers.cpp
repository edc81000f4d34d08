#include "cli/numbers.h"

#include <charconv>
#include <cmath>
#include <string>

#include "cli/usage.h"

namespace overstrike {
namespace {

/// from_chars takes no plus sign; people write one.
std::string_view without_plus(std::string_view text) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return plus ? text.substr(1) : text;
}

template <class Number>
bool read_whole(std::string_view text, Number& value) {
  text = without_plus(text);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

void refuse(const NumberRule& rule, std::string_view text) {
  throw UsageError(std::string(rule.option) + ": expected " + std::string(rule.expected) +
                   ", found '" + std::string(text) + "'");
}

std::vector<double> read_numbers(const NumberRule& rule, std::string_view text) {
  std::vector<double> numbers;
  for (std::string_view rest = text;;) {
    const std::size_t comma = rest.find(',');
    double value = 0;
    if (!read_whole(rest.substr(0, comma), value) || !std::isfinite(value)) refuse(rule, text);
    numbers.push_back(value);
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  if (numbers.size() != rule.count) refuse(rule, text);
  return numbers;
}

double read_number_above(const NumberRule& rule, std::string_view text, double low, double high) {
  const double value = read_numbers(rule, text).front();
  if (!(value > low && value <= high)) refuse(rule, text);
  return value;
}

int read_integer(const NumberRule& rule, std::string_view text, int low, int high) {
  int value = 0;
  if (!read_whole(text, value) || value < low || value > high) refuse(rule, text);
  return value;
}

}  // namespace overstrike
