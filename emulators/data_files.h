#pragma once
// Where the files in data/ are. Emulators share these files with the devices, and no code.
#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace overstrike::emulator {

/// What an emulator throws: a file that it cannot read or write, an option that makes no sense.
/// Odd bytes in a stream are no errors; they are in the report.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A sheet that cannot be written: the work failed, whoever asked for it is not to blame.
class OutputError : public Error {
 public:
  using Error::Error;
};

/// The file `relative` ("plotters/hp7475a.profile") in the first of these folders that has it:
/// $OVERSTRIKE_DATA, share/overstrike beside the program's own bin, data/ of the source tree that
/// it was built from, the share/overstrike it was configured to be installed to. Throws Error.
std::filesystem::path find_data_file(std::string_view relative);

}  // namespace overstrike::emulator
