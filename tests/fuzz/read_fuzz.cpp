// Any bytes are a scene that core may be given, or an InputError that says why not; nothing else
// comes out of a reader.
#include "core/geometry/tessellate.h"
#include "scenes/readers/read.h"
#include "tests/fuzz/fuzz.h"

namespace overstrike::fuzz {
namespace {

void expect_sound(const Polyhedron& p) {
  for (const Index i : p.indices) expect(i < p.vertices.size(), "faces number their vertices");
  for (std::size_t l = 1; l < p.loop_ends.size(); ++l)
    expect(p.loop_ends[l - 1] <= p.loop_ends[l], "loops follow one another");
  for (std::size_t f = 1; f < p.face_ends.size(); ++f)
    expect(p.face_ends[f - 1] <= p.face_ends[f], "faces follow one another");
  expect(p.loop_ends.empty() || p.loop_ends.back() == p.indices.size(), "loops hold all corners");
  expect(p.face_ends.empty() || p.face_ends.back() == p.loop_ends.size(), "faces hold all loops");
  expect(p.corner_normals.empty() || p.corner_normals.size() == p.indices.size(),
         "every corner has a normal, or none has");
}

void expect_sound(const Scene& scene) {
  for (const Body& body : scene.bodies) {
    expect(body.shape != nullptr, "a body has a shape");
    expect(body.density_factor >= 0, "densities are not negative");
    if (const auto* mesh = std::get_if<Mesh>(body.shape.get())) expect_sound(mesh->polyhedron);
    const std::string fault = validate(*body.shape);
    expect(fault.empty(), "a shape that was read can be drawn: " + fault);
  }
}

}  // namespace
}  // namespace overstrike::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace overstrike;
  try {
    // A folder that holds nothing: no file that the text names is opened.
    const ReadResult read =
        read_scene_text(fuzz::text_of(data, size), OVERSTRIKE_FUZZ_FORMAT, "fuzz", "/nonexistent");
    fuzz::expect_sound(read.scene);
  } catch (const InputError& error) {
    fuzz::expect(!error.diagnostics().empty(), "an error says what is wrong");
  }
  return 0;
}
