#pragma once
// Hears when files are saved (inotify).
#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace overstrike {

/// Folders are watched, not files: editors save by renaming another file over the name, which a
/// watch on the file would not outlive. Names that are links are watched where they lead to, too.
class FileWatch {
 public:
  /// Throws WorkError when the system has no more watches to give.
  FileWatch();
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  /// Readable when something has happened.
  int descriptor() const { return descriptor_; }
  /// True when it was not watched so far. A folder that does not exist is left out.
  bool add(const std::filesystem::path& file);
  /// Forgets what has happened. True when it was the saving of a watched file, or of any file that
  /// lies beside one when `beside`: a file that was missed may be there now.
  bool saved(bool beside);

 private:
  bool add_name(const std::filesystem::path& file);

  int descriptor_;
  std::map<int, std::set<std::string>> names_;  ///< by the watch of their folder
};

}  // namespace overstrike
