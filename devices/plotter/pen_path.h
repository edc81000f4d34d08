#pragma once
// The pen's way: lines whose ends meet become one, and the pen goes to the nearest end next.
#include <vector>

#include "devices/plotter/hpgl_writer.h"

namespace overstrike {

using PlotLine = std::vector<PlotPoint>;

/// Joins lines at ends that meet, so that the pen is lifted less: open chains first, each from an
/// end where an odd number of lines meet, then closed ones. Every piece of ink stays, once; a
/// line may be turned round. The order of the input decides between equals.
std::vector<PlotLine> joined(std::vector<PlotLine> lines);

/// The lines in the order of a greedy walk from `start`: the nearest end of what is left, each line
/// drawn from that end. Time is near linear, memory linear.
std::vector<PlotLine> ordered(std::vector<PlotLine> lines, PlotPoint start);

}  // namespace overstrike
