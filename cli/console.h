#pragma once
// The command's two voices: the product on standard output, everything else on standard error.
#include <span>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/scene/scene.h"
#include "scenes/readers/read.h"

namespace overstrike {

/// All of it, flushed. Throws WorkError when standard output takes no more.
void print(std::string_view text);
/// One line on standard error.
void say(std::string_view text);
/// Warnings as `file:line:col: warning: ...`, each once.
void say_warnings(std::span<const Diagnostic> warnings);

bool stdout_is_terminal();
bool stderr_is_terminal();

/// Throws UsageError where they are given for what is no OpenSCAD program.
void check_definitions(const std::string& scene, const std::vector<std::string>& definitions);

/// A scene of a file or of standard input (`-`; `format` is then an extension without its dot,
/// empty for yaml; `definitions` are for OpenSCAD). Throws InputError, UsageError (a format given
/// for a file, or an unknown one).
ReadResult read_scene_argument(const std::string& scene, const std::string& format,
                               const std::vector<std::string>& definitions = {});

/// Everything on standard input. Throws WorkError.
std::string read_stdin();

/// "3 bodies", "1 body".
std::string counted(std::size_t count, std::string_view one, std::string_view many);

}  // namespace overstrike
