// The overstrike command: the only place that prints errors and exits.
#include <cstdio>
#include <new>
#include <vector>

#include "cli/commands.h"
#include "cli/help.h"
#include "cli/interrupt.h"
#include "cli/standard_streams.h"
#include "cli/usage.h"

namespace overstrike {
namespace {

void say(const std::string& text) { std::fprintf(stderr, "%s\n", text.c_str()); }

int run_words(const std::vector<std::string>& words) {
  try {
    return std::visit([](const auto& command) { return run(command); }, parse_command_line(words));
  } catch (const UsageError& error) {
    const bool in_subcommand = !words.empty() && is_subcommand(words.front());
    say(std::string("overstrike: error: ") + error.what());
    say("try 'overstrike " + (in_subcommand ? words.front() + " " : std::string()) + "--help'");
    return kBadUsage;
  } catch (const InputError& error) {
    say(error.what());
    return kBadUsage;
  } catch (const WorkError& error) {
    say(std::string("overstrike: error: ") + error.what());
  } catch (const std::bad_alloc&) {
    say("overstrike: error: not enough memory");
  } catch (const std::exception& error) {
    say(std::string("overstrike: error: ") + error.what());
  }
  return kWorkFailed;
}

}  // namespace
}  // namespace overstrike

int main(int argc, char** argv) {
  overstrike::fill_closed_standard_streams();
  overstrike::catch_interrupts();
  return overstrike::run_words(std::vector<std::string>(argv + (argc > 0), argv + argc));
}
