#include "core/error.h"

#include <utility>

namespace overstrike {
namespace {

std::string joined(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& d : diagnostics) {
    if (!text.empty()) text += '\n';
    text += to_string(d);
  }
  return text;
}

}  // namespace

std::string to_string(const Diagnostic& d) {
  std::string text;
  if (!d.place.file.empty()) {
    text += d.place.file;
    if (d.place.line > 0) text += ':' + std::to_string(d.place.line);
    if (d.place.line > 0 && d.place.column > 0) text += ':' + std::to_string(d.place.column);
    text += ": ";
  }
  text += d.severity == Severity::error ? "error: " : "warning: ";
  text += d.message;
  if (!d.hint.empty()) text += " (" + d.hint + ")";
  if (!d.excerpt.empty()) {
    text += "\n    " + d.excerpt;
    const int caret = d.caret > 0 ? d.caret : d.place.column;
    if (caret > 0) text += "\n    " + std::string(static_cast<std::size_t>(caret - 1), ' ') + '^';
  }
  return text;
}

InputError::InputError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(joined(diagnostics)), diagnostics_(std::move(diagnostics)) {}

InputError::InputError(Place place, std::string message, std::string hint)
    : InputError(std::vector<Diagnostic>{
          {Severity::error, std::move(place), std::move(message), std::move(hint), {}}}) {}

}  // namespace overstrike
