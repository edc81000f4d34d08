#pragma once
// Where an emulated sheet goes. The emulators write files; standard output gets a copy.
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace overstrike {

/// For `output` a file's name, or - for standard output: then the sheet is drawn in a folder of its
/// own among the system's temporary files, which is gone with the object.
class SheetOutput {
 public:
  /// `format` says what standard output gets: one of `formats`, or empty for the first of them.
  /// Throws UsageError (another format, or one beside a file's name) and WorkError.
  SheetOutput(const std::string& output, const std::string& format,
              std::span<const std::string_view> formats);
  ~SheetOutput();
  SheetOutput(const SheetOutput&) = delete;
  SheetOutput& operator=(const SheetOutput&) = delete;

  /// Where the emulator is to draw.
  const std::filesystem::path& path() const { return path_; }
  /// After drawing: copies to standard output, if that was asked for. Throws UsageError when there
  /// are several files (pages), WorkError when they cannot be read or written.
  void deliver() const;

 private:
  std::filesystem::path folder_, path_;
};

}  // namespace overstrike
