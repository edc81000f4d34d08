#include "scenes/readers/openscad/program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>

#include "scenes/readers/openscad/scene.h"

extern char** environ;

namespace overstrike::openscad {
namespace {

namespace fs = std::filesystem;

/// A folder of our own, gone with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "overstrike-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw WorkError("cannot make a temporary folder: " + std::string(std::strerror(errno)));
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Its exit status; what it prints goes to the file `log`.
int run(std::vector<std::string> words, const fs::path& log) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT)
    throw WorkError(
        "OpenSCAD is not installed: it turns .scad into .csg (Debian's package openscad)");
  if (error != 0) throw WorkError("cannot run openscad: " + std::string(std::strerror(error)));
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw WorkError("openscad: " + std::string(std::strerror(errno)));
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

/// "... in file NAME, line 12": where it is, and what is said without it.
void take_place(Diagnostic& said, const fs::path& path) {
  constexpr std::string_view kFile = " in file ", kLine = ", line ";
  const std::size_t file = said.message.rfind(kFile);
  const std::size_t line = said.message.rfind(kLine);
  if (file == std::string::npos || line == std::string::npos || line < file) return;
  std::string name = said.message.substr(file + kFile.size(), line - file - kFile.size());
  std::erase(name, '"');
  const char* const digits = said.message.data() + line + kLine.size();
  int number = 0;
  std::from_chars(digits, said.message.data() + said.message.size(), number);
  const bool own = fs::path(name).filename() == path.filename();
  said.place = {own ? path.string() : name, number, 0};
  said.message.resize(file);
}

}  // namespace

std::vector<Diagnostic> said(std::string_view output, const fs::path& path) {
  std::vector<Diagnostic> all;
  while (!output.empty()) {
    const std::size_t end = std::min(output.find('\n'), output.size());
    const std::string_view line = output.substr(0, end);
    output.remove_prefix(std::min(end + 1, output.size()));
    for (const auto& [prefix, severity] :
         {std::pair("ERROR: ", Severity::error), std::pair("WARNING: ", Severity::warning)}) {
      if (!line.starts_with(prefix)) continue;
      Diagnostic one;
      one.severity = severity;
      one.place.file = path.string();
      one.message = line.substr(std::strlen(prefix));
      take_place(one, path);
      one.message = "OpenSCAD: " + one.message;
      all.push_back(std::move(one));
    }
  }
  return all;
}

ReadResult read_program(const fs::path& path, std::span<const std::string> definitions) {
  const TemporaryFolder folder;
  const fs::path exported = folder.path() / "model.csg", log = folder.path() / "log";
  std::vector<std::string> words{"openscad", "-o", exported.string()};
  for (const std::string& definition : definitions) {
    words.push_back("-D");
    words.push_back(definition);
  }
  words.push_back(fs::absolute(path).string());
  const int status = run(std::move(words), log);
  std::vector<Diagnostic> diagnostics = said(bytes_of(log), path);
  const auto is_error = [](const Diagnostic& d) { return d.severity == Severity::error; };
  if (std::any_of(diagnostics.begin(), diagnostics.end(), is_error))
    throw InputError(std::move(diagnostics));
  if (status != 0 || !fs::exists(exported))
    throw InputError({path.string(), 0, 0},
                     "OpenSCAD cannot export it (status " + std::to_string(status) + ")",
                     bytes_of(log).substr(0, 400));
  ReadResult result =
      read_scene(bytes_of(exported), path.string() + " (as .csg)", path.parent_path());
  result.scene.source = path.string();
  result.warnings.insert(result.warnings.begin(), diagnostics.begin(), diagnostics.end());
  return result;
}

}  // namespace overstrike::openscad
