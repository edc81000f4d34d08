// Loads a scene and draws it on the line printer, into memory.
#include <iostream>

#include "devices/draw.h"
#include "scenes/readers/read.h"

int main(int argc, char** argv) {
  using namespace overstrike;
  if (argc != 2) return 2;
  std::string page;
  const DeviceKind* printer = find_device("line-printer");
  if (printer == nullptr) return 3;
  const auto device =
      printer->make({{"size", "40x20"}, {"stream", "plain"}}, "-", open_memory(page));
  draw(read_scene(argv[1]).scene, *device, DrawOptions{});
  std::cout << page;
}
