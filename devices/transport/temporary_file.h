#pragma once
// A file under a name of its own that goes away unless somebody keeps it.
#include <filesystem>
#include <string_view>

namespace overstrike {

/// Removed by the destructor, and by remove_unfinished_files() (transport.h), unless it was
/// renamed.
class TemporaryFile {
 public:
  /// Creates `.NAME.XXXXXX.EXT` beside `target` (NAME.EXT), open for writing, with the mode that
  /// the umask leaves of 0666. Throws WorkError that names the target.
  static TemporaryFile beside(const std::filesystem::path& target);
  /// A spool in the system's directory for temporary files.
  static TemporaryFile spool();
  TemporaryFile(TemporaryFile&&) noexcept;
  ~TemporaryFile();

  const std::filesystem::path& path() const { return path_; }
  /// Open for reading and writing; closed by the destructor or by close().
  int descriptor() const { return descriptor_; }
  /// Throws WorkError: some file systems report a full disk only here.
  void close();
  /// Takes the target's name, over what is there; it is no longer temporary. Throws WorkError.
  void rename_to(const std::filesystem::path& target);

 private:
  TemporaryFile() = default;
  static TemporaryFile create(const std::filesystem::path& directory, std::string_view stem,
                              std::string_view extension, const std::filesystem::path& target);

  std::filesystem::path path_;
  std::filesystem::path target_;  ///< for messages
  int descriptor_ = -1;
  int slot_ = -1;  ///< its entry in the table of unfinished files, or -1
};

}  // namespace overstrike
