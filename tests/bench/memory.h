#pragma once
// What drawing takes in memory, measured in a process of its own.
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace overstrike::bench {

/// Largest resident sizes, in MB of 10^6 bytes: `all` from the scene on, `drawing` from the
/// canonical input (and the scene) on.
struct Peak {
  double all = 0, drawing = 0;
};

/// A scene that can be asked for by its name in another process.
struct NamedScene {
  std::string name;
  Scene (*make)();
};

/// Runs this program anew to draw the scene once, one thread. Zeros where the system does not tell.
Peak peak_of(const std::string& name, int size);
/// In that other process: draws and prints; false when the command line asks for no such thing.
bool answer_peak(int argc, char** argv, const std::vector<NamedScene>& scenes);

}  // namespace overstrike::bench
