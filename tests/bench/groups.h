#pragma once
// Groups of lines that compare Overstrike with itself.
#include "tests/bench/lines.h"
#include "tests/bench/scenes.h"

namespace overstrike::bench {

/// Methods "plain" and "lit": the same scene without and with light (and ground). x_plain: how many
/// times as long.
std::vector<Line> light_lines(const Scene& plain, const Scene& lit, int size);

/// For each size, "z_buffer/SIZE" then "overstrike/SIZE". x_first: how many times as long as at the
/// first size.
std::vector<std::string> growth_methods(const std::vector<int>& sizes);
std::vector<Line> growth_lines(const Scene&, const std::vector<int>& sizes);

/// By one thread and by two; x_one: how many times faster than by one, by the wall's clock.
inline const std::vector<std::string> kThreadMethods = {"z_buffer/1", "z_buffer/2", "overstrike/1",
                                                        "overstrike/2"};
std::vector<Line> thread_lines(const Scene&, int size);

/// A scene of NN74's Table 1 on the grid of 135 x 180; `seconds_1974`: I + II + III there. x_1974:
/// how many times faster.
std::vector<Line> nn74_lines(const std::string& scene, double seconds_1974);

}  // namespace overstrike::bench
