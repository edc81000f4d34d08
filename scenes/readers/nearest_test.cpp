#include "scenes/readers/nearest.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace overstrike {
namespace {

TEST(EditDistance, CountsEdits) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("", "box"), 3u);
  EXPECT_EQ(edit_distance("radius", "radius"), 0u);
  EXPECT_EQ(edit_distance("raduis", "radius"), 1u);  // a swap is one edit
  EXPECT_EQ(edit_distance("radus", "radius"), 1u);
  EXPECT_EQ(edit_distance("raddius", "radius"), 1u);
  EXPECT_EQ(edit_distance("rodius", "radius"), 1u);
  EXPECT_EQ(edit_distance("ca", "abc"), 3u);  // no part is edited twice
}

TEST(EditDistance, IsSymmetricAndBounded) {
  std::mt19937 random(7);
  const auto word = [&] {
    std::string s(random() % 9, 'a');
    for (char& c : s) c = static_cast<char>('a' + random() % 3);
    return s;
  };
  for (int i = 0; i < 5000; ++i) {
    const std::string a = word(), b = word();
    const std::size_t d = edit_distance(a, b);
    EXPECT_EQ(d, edit_distance(b, a)) << a << ' ' << b;
    EXPECT_LE(d, std::max(a.size(), b.size()));
    EXPECT_GE(d + std::min(a.size(), b.size()), std::max(a.size(), b.size()));
    EXPECT_EQ(d == 0, a == b);
  }
}

TEST(Nearest, FindsWhatWasMeant) {
  const std::string_view known[] = {"radius", "height", "sides", "look-at", "at"};
  EXPECT_EQ(nearest("raduis", known), "radius");
  EXPECT_EQ(nearest("Height", known), "height");
  EXPECT_EQ(nearest("look_at", known), "look-at");
  EXPECT_EQ(nearest("side", known), "sides");
  EXPECT_EQ(nearest("colour", known), "");
  EXPECT_EQ(nearest("x", known), "");
  EXPECT_EQ(nearest("", known), "");
  EXPECT_EQ(nearest(std::string(5000, 'r'), known), "");
  EXPECT_EQ(did_you_mean("raduis", known), "did you mean 'radius'?");
  EXPECT_EQ(did_you_mean("zebra", known), "");
}

}  // namespace
}  // namespace overstrike
