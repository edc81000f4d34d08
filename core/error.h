#pragma once
// What goes wrong, and where. One exception type, thrown at boundaries, caught once in cli/.
#include <stdexcept>
#include <string>
#include <vector>

namespace overstrike {

/// A place in a file that a user wrote. `line` and `column` count from 1; 0 means "not known".
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

enum class Severity { warning, error };

/// One thing to tell the user. `hint` holds what helps ("did you mean 'radius'?") or is empty;
/// `excerpt` holds the offending source line, for the caret, or is empty; of a long line it holds
/// the part round the place, and `caret` says under which of its characters (from 1; 0: under
/// place.column) the caret stands.
struct Diagnostic {
  Severity severity = Severity::error;
  Place place;
  std::string message;
  std::string hint;
  std::string excerpt;
  int caret = 0;
};

/// `scene.yaml:12:7: error: message (hint)`, then the excerpt and a caret under the column.
std::string to_string(const Diagnostic&);

/// Bad input: every diagnostic of one file at once. The command exits with status 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Diagnostic> diagnostics);
  InputError(Place place, std::string message, std::string hint = {});
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// The work failed (a disk is full, a pipe is closed): the command exits with status 1.
class WorkError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace overstrike
