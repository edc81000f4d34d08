#include <gtest/gtest.h>

#include "scenes/readers/mesh_test_files.h"

namespace overstrike::mesh_tests {
namespace {

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string kSquareDump = "0,0,0 1,0,0 1,1,0 0,1,0";

TEST(Obj, Reads) {
  const Case cases[] = {
      {"a polygon", kSquare + "f 1 2 3 4\n", kSquareDump + " | 0 1 2 3 @5"},
      {"all forms of indices",
       kSquare + "vt 0 0\nvn 0 0 1\nf 1/1 2/1 3/1\nf 1//1 3//1 4//1\n"
                 "f 1/1/1 2/1/1 4/1/1",
       kSquareDump + " | 0 1 2 @7 | 0 2 3 @8 | 0 1 3 @9"},
      {"backwards", kSquare + "f -4 -3 -2 -1\nv 2 0 0\nf -1 -2 -3",
       kSquareDump + " 2,0,0 | 0 1 2 3 @5 | 4 3 2 @7"},
      {"faces before vertices", "f 1 2 3\n" + kSquare, "0,0,0 1,0,0 1,1,0 | 0 1 2 @1"},
      {"unused vertices go", "v 9 9 9\n" + kSquare + "f 2 3 4", "0,0,0 1,0,0 1,1,0 | 0 1 2 @6"},
      {"equal vertices",
       "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -0 0 0\nv 1.0 0 0\nv 1 1 0\nf 1 2 3\nf 5 6 3"
       "\nf 4 6 3",
       "0,0,0 1,0,0 0,1,0 1,1,0 | 0 1 2 @7 | 1 3 2 @8 | 0 3 2 @9"},
      {"what is left out",
       "# comment\nmtllib a.mtl\no thing\ng a b\ns off\n" + kSquare +
           "usemtl x # y\nl 1 2\nf 1 2 3 # comment\n",
       "0,0,0 1,0,0 1,1,0 | 0 1 2 @12"},
      {"weights and colours", "v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0\nf 1 2 3",
       "0,0,0 1,0,0 0,1,0 | 0 1 2 @4"},
      {"joined lines", "v 0 0 \\\n0\nv 1 0 0\nv 0 1 0\nf 1 2\\\r\n\\\r\n 3\nf 3 2 1",
       "0,0,0 1,0,0 0,1,0 | 0 1 2 @5 | 2 1 0 @8"},
      {"an unknown statement", kSquare + "usmtl 1\nf 1 2 3\nusmtl 2",
       "0,0,0 1,0,0 1,1,0 | 0 1 2 @6\nm.obj:5:1: warning: unknown statement 'usmtl' is left out "
       "(did "
       "you mean 'usemtl'?)\n    usmtl 1\n    ^"},
  };
  for (const Case& c : cases) EXPECT_EQ(outcome(c.text, "obj"), c.outcome) << c.name;
}

TEST(Obj, SaysWhatIsWrong) {
  const Case cases[] = {
      {"empty", "", "m.obj: error: the file is empty"},
      {"no faces", "v 0 0 0\n",
       "m.obj:1:8: error: the file ends without a face ('f')\n    v 0 0 0\n           ^"},
      {"too few corners", kSquare + "f 1 2\n",
       "m.obj:5:2: error: a face needs at least 3 vertices, found 2\n    f 1 2\n     ^"},
      {"a vertex too many", kSquare + "f 1 2 7\n",
       "m.obj:5:7: error: vertex 7 does not exist (there are 4 vertices, numbered from 1)\n"
       "    f 1 2 7\n          ^"},
      {"zero", kSquare + "f 0 1 2\n",
       "m.obj:5:3: error: vertex 0 does not exist (they are numbered from 1)\n    f 0 1 2\n"
       "      ^"},
      {"too far back", kSquare + "f -1 -2 -5\n",
       "m.obj:5:9: error: vertex -5 does not exist (so far there are 4)\n    f -1 -2 -5\n"
       "            ^"},
      {"far too large", kSquare + "f 1 2 99999999999\n",
       "m.obj:5:7: error: vertex 99999999999 does not exist (so far there are 4)\n"
       "    f 1 2 99999999999\n          ^"},
      {"no such normal", kSquare + "f 1 2 3//1\n",
       "m.obj:5:10: error: normal 1 does not exist (there are 0 normals, numbered from 1)\n"
       "    f 1 2 3//1\n             ^"},
      {"not a number", kSquare + "f 1 2 3x 4/y/\nv 1 2 three\n",
       "m.obj:5:7: error: the number of a vertex must be a whole number, found '3x'\n"
       "    f 1 2 3x 4/y/\n          ^\n"
       "m.obj:5:12: error: the number of a texture point must be a whole number, found 'y'\n"
       "    f 1 2 3x 4/y/\n               ^\n"
       "m.obj:6:7: error: vertex's z must be a number, found 'three'\n    v 1 2 three\n"
       "          ^"},
      {"long and odd", kSquare + "f 1 2 \x1b" + std::string(50, '7') + "\n",
       "m.obj:5:7: error: the number of a vertex must be a whole number, found '?" +
           std::string(39, '7') + "...'\n    f 1 2 \x1b" + std::string(50, '7') + "\n          ^"},
      {"a comma", "v 1,5 2 3\nf 1 1 1",
       "m.obj:1:3: error: vertex's x must be a number, found '1,5'\n    v 1,5 2 3\n      ^"},
      {"on a joined line", "v 0 0 \\\n x\nf 1 1 1",
       "m.obj:2:2: error: vertex's z must be a number, found 'x'\n     x\n     ^"},
      {"a zero byte", std::string("v 0\n\0", 5),
       "m.obj:2:1: error: is not text: found a zero byte"},
  };
  for (const Case& c : cases) EXPECT_EQ(outcome(c.text, "obj"), c.outcome) << c.name;
}

TEST(Obj, TakesNormalsIfAllCornersHaveThem) {
  std::vector<Diagnostic> warnings;
  const std::string normals = kSquare + "vn 0 0 2\nvn 0 3 4\n";
  const auto read = [&](const std::string& faces) {
    return read_mesh_text(normals + faces, "obj", "m", warnings).polyhedron.corner_normals;
  };
  EXPECT_EQ(read("f 1//1 2//2 3//-1"),
            (std::vector<Vec3>{{0, 0, 1}, {0, 0.6, 0.8}, {0, 0.6, 0.8}}));
  EXPECT_TRUE(read("f 1//1 2//2 3").empty());
  EXPECT_TRUE(read("vn 0 0 0\nf 1//1 2//2 3//3").empty());
}

TEST(Obj, TellsThePrecisionOfItsNumbers) {
  std::vector<Diagnostic> warnings;
  const auto precision = [&](const std::string& x) {
    return read_mesh_text("v 0 0 0\nv 1 0 0\nv " + x + "\nf 1 2 3", "obj", "m", warnings).precision;
  };
  EXPECT_EQ(precision("0 100000 0"), 0);                // whole numbers are meant
  EXPECT_EQ(precision("0 0.125 0.5"), 0);               // and so are short ones
  EXPECT_EQ(precision("0.333333 0.5 0"), 5e-7);         // trailing zeros left out
  EXPECT_EQ(precision("0.333333 123.457 0"), 5e-4);     // six digits (%g)
  EXPECT_EQ(precision("0.333333 123.456789 0"), 5e-7);  // six places (%f)
  EXPECT_EQ(precision("1.2345e+02 -0.012345 2e9"), 5e-3);
  EXPECT_EQ(precision("0.1234567890123456789012345 0 0"), 5e-26);
}

}  // namespace
}  // namespace overstrike::mesh_tests
