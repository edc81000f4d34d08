#pragma once
// The lines of a table of costs: measured in groups, each group's methods in one run, and handed to
// Google Benchmark one by one.
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tests/bench/timing.h"

namespace overstrike::bench {

/// A method's line: its medians, and what stands beside them.
struct Line {
  Times times;
  std::map<std::string, double> counters;
};

/// `measure` gives one line for each of `methods`; it is called once, when the first of them is
/// asked for.
struct Group {
  std::string name;
  std::vector<std::string> methods;
  std::function<std::vector<Line>()> measure;
};

/// Registers group/method for every method.
void register_lines(Group);
/// Runs what the options of the command line (Google Benchmark's) ask for; 0 when all went well.
int run_lines(int argc, char** argv);

}  // namespace overstrike::bench
