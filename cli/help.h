#pragma once
// What --help says: names, values with units and defaults, meanings, examples.
#include <string_view>

namespace overstrike {

struct OptionHelp {
  std::string_view names;  ///< "-o,--output"
  std::string_view value;  ///< "AZ,EL"; empty for flags
  std::string_view meaning;
  std::string_view group;
};

struct SubcommandHelp {
  std::string_view name;
  std::string_view usage;  ///< what follows the program's name
  std::string_view summary;
  std::string_view footer;  ///< examples
};

extern const std::string_view kProgramSummary;
extern const std::string_view kProgramFooter;
extern const std::string_view kVersionText;

/// Precondition: there is such an option of `render`.
const OptionHelp& option_help(std::string_view names);
/// Precondition: there is such a subcommand.
const SubcommandHelp& subcommand_help(std::string_view name);
/// True for the names that subcommand_help() knows.
bool is_subcommand(std::string_view name);

}  // namespace overstrike
