#include <gtest/gtest.h>

#include "scenes/readers/mesh_test_files.h"

namespace overstrike::mesh_tests {
namespace {

const std::string kFour = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const std::string kFourDump = "0,0,0 1,0,0 1,1,0 0,1,0";

TEST(Off, Reads) {
  const Case cases[] = {
      {"plain", "OFF\n4 1 4\n" + kFour + "4 0 1 2 3\n", kFourDump + " | 0 1 2 3 @7"},
      {"counts on the first line", "OFF 4 1 0\n" + kFour + "4 0 1 2 3",
       kFourDump + " | 0 1 2 3 @6"},
      {"no header", "4 1 0\n" + kFour + "4 0 1 2 3", kFourDump + " | 0 1 2 3 @6"},
      {"no count of edges", "OFF\n4 1\n" + kFour + "4 0 1 2 3", kFourDump + " | 0 1 2 3 @7"},
      {"comments and empty lines",
       "# one\nOFF # two\n\n# three\n4 2 0 # four\n\n" + kFour + "# five\n\n3 0 1 2 # six\n3 2 3 0",
       kFourDump + " | 0 1 2 @13 | 2 3 0 @14"},
      {"colours",
       "COFF\n4 1 0\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n1 1 0 0 0 0 0\n0 1 0 0 0 0 0\n"
       "4 0 1 2 3 0.5 0.5 0.5\n",
       kFourDump + " | 0 1 2 3 @7"},
      {"normals and texture points",
       "STCNOFF\n3 1 0\n0 0 0 0 0 1 1 1 1 1 0 0\n1 0 0 0 0 1\n0 1 0 0\n"
       "3 0 1 2\n",
       "0,0,0 1,0,0 0,1,0 | 0 1 2 @6"},
      {"more behind", "OFF\n4 1 4\n" + kFour + "4 0 1 2 3\nwhatever", kFourDump + " | 0 1 2 3 @7"},
  };
  for (const Case& c : cases) EXPECT_EQ(outcome(c.text, "off"), c.outcome) << c.name;
}

TEST(Off, SaysWhatIsWrong) {
  const Case cases[] = {
      {"empty", "", "m.off: error: the file is empty"},
      {"only blanks", "\n\n", "m.off:2:1: error: expected 'OFF', found the end of the line"},
      {"another file", "solid\n",
       "m.off:1:1: error: expected 'OFF', found 'solid'\n    solid\n    ^"},
      {"four dimensions", "4OFF\n1 1 1\n",
       "m.off:1:1: error: expected 'OFF', found '4OFF'\n    4OFF\n    ^"},
      {"binary", "OFF BINARY\n1 1 1\n",
       "m.off:1:5: error: binary OFF files cannot be read\n    OFF BINARY\n        ^"},
      {"no counts", "OFF\n",
       "m.off:1:4: error: the number of vertices must be a whole number, found the end of the "
       "line\n    OFF\n       ^\n"
       "m.off:1:4: error: the number of faces must be a whole number, found the end of the line\n"
       "    OFF\n       ^"},
      {"no faces", "OFF\n4 0 0\n" + kFour,
       "m.off:2:3: error: the number of faces must be above 0, found '0'\n    4 0 0\n      ^"},
      {"a negative count", "OFF\n-4 1 0\n" + kFour,
       "m.off:2:1: error: the number of vertices must be above 0, found '-4'\n    -4 1 0\n    ^"},
      {"a lying count", "OFF\n4000000000 1 0\n" + kFour,
       "m.off:2:1: error: the file is too short for 4 000 000 000 vertices\n    4000000000 1 0\n"
       "    ^"},
      {"ends in the vertices", "OFF\n5 1 0\n" + kFour,
       "m.off:6:6: error: the file ends after 4 of 5 vertices\n    0 1 0\n         ^"},
      {"ends in the faces", "OFF\n4 2 0\n" + kFour + "3 0 1 2",
       "m.off:7:8: error: the file ends after 1 of 2 faces\n    3 0 1 2\n           ^"},
      {"a short face", "OFF\n4 1 0\n" + kFour + "4 0 1 2",
       "m.off:7:8: error: the line ends after 3 of 4 vertices\n    4 0 1 2\n           ^"},
      {"two vertices", "OFF\n4 2 0\n" + kFour + "2 0 1\n3 0 1 2",
       "m.off:7:1: error: a face needs at least 3 vertices, found '2'\n    2 0 1\n    ^"},
      {"out of range", "OFF\n4 1 0\n" + kFour + "3 0 4 -1",
       "m.off:7:5: error: vertex 4 does not exist (there are 4, numbered from 0)\n    3 0 4 -1\n"
       "        ^\n"
       "m.off:7:7: error: vertex -1 does not exist (there are 4, numbered from 0)\n    3 0 4 -1\n"
       "          ^"},
      {"not numbers", "OFF\n3 1 0\n0 0 O\n0 nan 0\n1 2 3\n3 0 1 2.5\n",
       "m.off:3:5: error: vertex's z must be a number, found 'O'\n    0 0 O\n        ^\n"
       "m.off:4:3: error: vertex's y must be a finite number, found 'nan'\n    0 nan 0\n      ^\n"
       "m.off:6:7: error: the number of a vertex must be a whole number, found '2.5'\n"
       "    3 0 1 2.5\n          ^"},
  };
  for (const Case& c : cases) EXPECT_EQ(outcome(c.text, "off"), c.outcome) << c.name;
}

}  // namespace
}  // namespace overstrike::mesh_tests
