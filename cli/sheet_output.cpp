#include "cli/sheet_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

#include "cli/console.h"
#include "cli/usage.h"
#include "core/error.h"

namespace overstrike {
namespace {

namespace fs = std::filesystem;

fs::path temporary_folder() {
  std::error_code error;
  const fs::path place = fs::temp_directory_path(error);
  if (error) throw WorkError("the folder for temporary files: " + error.message());
  std::string name = (place / "overstrike-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw WorkError(fmt::format("{}: {}", name, std::strerror(errno)));
  return name;
}

std::string_view checked(const std::string& format, std::span<const std::string_view> formats) {
  if (format.empty()) return formats.front();
  const auto found = std::find(formats.begin(), formats.end(), format);
  if (found != formats.end()) return *found;
  throw UsageError(fmt::format("--format: expected one of {}, found '{}'{}",
                               fmt::join(formats, ", "), format, suggestion(format, formats)));
}

}  // namespace

SheetOutput::SheetOutput(const std::string& output, const std::string& format,
                         std::span<const std::string_view> formats)
    : path_(output) {
  if (output != "-") {
    if (format.empty()) return;
    throw UsageError("--format is for standard output; a file's extension says what it is");
  }
  const std::string name = fmt::format("sheet.{}", checked(format, formats));
  folder_ = temporary_folder();
  path_ = folder_ / name;
}

SheetOutput::~SheetOutput() {
  std::error_code ignored;  // what cannot be removed is left to the system's housekeeping
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

void SheetOutput::deliver() const {
  if (folder_.empty()) return;
  const auto pages = std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  if (pages > 1)
    throw UsageError(
        fmt::format("-o -: {} pages are {} pictures; --format pdf holds them all", pages, pages));
  std::ifstream sheet(path_, std::ios::binary);
  std::vector<char> buffer(1 << 16);
  while (sheet.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) ||
         sheet.gcount() > 0)
    print({buffer.data(), static_cast<std::size_t>(sheet.gcount())});
  if (!sheet.eof()) throw WorkError(path_.string() + ": cannot be read");
}

}  // namespace overstrike
