#pragma once
// Where the files in data/ are: profiles, type faces, tone tables. Devices and emulators each look
// for themselves, by the same rule.
#include <filesystem>
#include <string_view>

namespace overstrike {

/// The file `relative` ("plotters/hp7475a.profile") in the first of these folders that has it:
/// $OVERSTRIKE_DATA, share/overstrike beside the program's own bin, data/ of the source tree that
/// it was built from, the share/overstrike it was configured to be installed to. Throws InputError
/// that names the file and the folders tried.
std::filesystem::path find_data_file(std::string_view relative);

}  // namespace overstrike
