#include <gtest/gtest.h>

#include <limits>

#include "scenes/readers/mesh_test_files.h"

namespace overstrike::mesh_tests {
namespace {

const std::string kFacet =
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n"
    " endloop\nendfacet\n";
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
const std::vector<float> kTwo = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, -0.0f, 1, 1, 0, 0, 1, 0};

std::vector<float> two_with(std::size_t i, float value) {
  std::vector<float> corners = kTwo;
  corners[i] = value;
  return corners;
}

TEST(Stl, ReadsText) {
  const std::string one = "0,0,0 1,0,0 0,1,0 | 0 1 2 @2";
  const Case cases[] = {
      {"plain", "solid a b c\n" + kFacet + "endsolid a b c\n", one},
      {"no names", "solid\n" + kFacet + "endsolid", one},
      {"upper case",
       "SOLID\nFACET NORMAL nan nan nan\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\n"
       "VERTEX 0 1 0\nENDLOOP\nENDFACET\nENDSOLID\n",
       one},
      {"in few lines",
       "solid\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0\n"
       "vertex 0 1 0 endloop endfacet endsolid",
       one},
      {"a byte order mark", "\xEF\xBB\xBFsolid\n" + kFacet + "endsolid", one},
      {"carriage returns",
       "solid\r\nfacet normal 0 0 1\r\nouter loop\r\nvertex 0 0 0\r\n"
       "vertex 1 0 0\r\nvertex 0 1 0\r\nendloop\r\nendfacet\r\nendsolid\r\n",
       one},
      {"two solids", "solid a\n" + kFacet + "endsolid a\nsolid b\n" + kFacet + "endsolid b\n",
       "0,0,0 1,0,0 0,1,0 | 0 1 2 @2 | 0 1 2 @11"},
      {"forms of numbers",
       "solid\nfacet normal 0 0 1\nouter loop\nvertex +1 -2.5e-1 1E1\n"
       "vertex .5 -0 1e-999\nvertex 0 0 2.\nendloop\nendfacet\nendsolid",
       "1,-0.25,10 0.5,0,0 0,0,2 | 0 1 2 @2"},
  };
  for (const Case& c : cases) EXPECT_EQ(outcome(c.text, "stl"), c.outcome) << c.name;
}

TEST(Stl, ReadsBinary) {
  const std::string two = "0,0,0 1,0,0 0,1,0 1,1,0 | 0 1 2 | 1 3 2";
  const Case cases[] = {
      {"plain", binary_stl(kTwo, 2), two},
      {"a header like text's", binary_stl(kTwo, 2, "solid made by a careless program"), two},
      {"a header of zeros", binary_stl(kTwo, 2, std::string(80, '\0')), two},
      {"more behind", binary_stl(kTwo, 2) + "abc",
       two + "\nm.stl: warning: byte 184: 3 bytes after the last triangle are left out"},
  };
  for (const Case& c : cases) EXPECT_EQ(outcome(c.text, "stl"), c.outcome) << c.name;
}

TEST(Stl, SaysWhatIsWrongInText) {
  const std::string head = "solid x\nfacet normal 0 0 1\nouter loop\n";
  const Case cases[] = {
      {"empty", "", "m.stl: error: the file is empty (expected an STL mesh)"},
      {"other text", "a: b\n",
       "m.stl: error: is no STL file: text begins with 'solid', and binary files have a header of "
       "84 bytes, found 5"},
      {"long other text", std::string(100, 'a'),
       "m.stl: error: is no STL file: it is text, but does not begin with 'solid'"},
      {"no end", "solid\n",
       "m.stl:1:6: error: expected 'facet' or 'endsolid', found the end of the file after 0 "
       "triangles\n    solid\n         ^"},
      {"nothing in it", "solid\nendsolid\n",
       "m.stl:2:9: error: the mesh has no triangles\n    endsolid\n            ^"},
      {"ends early", head + "vertex 1 2 3\n",
       "m.stl:4:13: error: the file ends within triangle 0: expected 'vertex'\n    vertex 1 2 3\n"
       "                ^"},
      {"ends between facets", "solid\n" + kFacet,
       "m.stl:8:9: error: expected 'facet' or 'endsolid', found the end of the file after 1 "
       "triangle\n    endfacet\n            ^"},
      {"not a number", head + "vertex 1 x 3\n endfacet endsolid",
       "m.stl:4:10: error: vertex's y must be a number, found 'x'\n    vertex 1 x 3\n"
       "             ^"},
      {"too few", head + "vertex 1 2\n endfacet endsolid",
       "m.stl:4:11: error: vertex's z must be a number, found the end of the line\n"
       "    vertex 1 2\n              ^"},
      {"not finite", head + "vertex nan inf 1e999\n endfacet endsolid",
       "m.stl:4:8: error: vertex's x must be a finite number, found 'nan'\n"
       "    vertex nan inf 1e999\n           ^\n"
       "m.stl:4:12: error: vertex's y must be a finite number, found 'inf'\n"
       "    vertex nan inf 1e999\n               ^\n"
       "m.stl:4:16: error: vertex's z must be a finite number, found '1e999'\n"
       "    vertex nan inf 1e999\n                   ^"},
      {"too large", head + "vertex 0 0 -2e100\n endfacet endsolid",
       "m.stl:4:12: error: vertex's z must be at most 1e+100, found '-2e100'\n"
       "    vertex 0 0 -2e100\n               ^"},
      {"a polygon",
       head + "vertex 0 0 0 vertex 1 0 0 vertex 1 1 0 vertex 0 1 0\nendloop endfacet "
              "endsolid",
       "m.stl:4:40: error: expected 'endloop', found 'vertex'\n"
       "    vertex 0 0 0 vertex 1 0 0 vertex 1 1 0 vertex 0 1 0\n"
       "                                           ^"},
      {"two errors", "solid\nfact\n" + kFacet + "endsolid\nmore",
       "m.stl:2:1: error: expected 'facet' or 'endsolid', found 'fact'\n    fact\n    ^\n"
       "m.stl:11:1: error: expected 'solid' or the end of the file, found 'more'\n    more\n"
       "    ^\nm.stl:11:5: error: expected 'facet' or 'endsolid', found the end of the file after "
       "1 triangle\n    more\n        ^"},
      {"a zero byte", "solid\n" + std::string(5000, ' ') + "\nab" + std::string(1, '\0'),
       "m.stl:3:3: error: is not text: found a zero byte"},
  };
  for (const Case& c : cases) EXPECT_EQ(outcome(c.text, "stl"), c.outcome) << c.name;
}

TEST(Stl, SaysWhatIsWrongInBinary) {
  const std::string two = binary_stl(kTwo, 2);
  const Case cases[] = {
      {"a short header", std::string(20, '\1'),
       "m.stl: error: is no STL file: text begins with 'solid', and binary files have a header of "
       "84 bytes, found 20"},
      {"no triangles", binary_stl({}, 0, "solid"),
       "m.stl: error: byte 80: the binary STL file has 0 triangles (expected at least one)"},
      {"cut short", two.substr(0, 150),
       "m.stl: error: ends after 1 of 2 triangles (byte 80 counts the triangles of this binary STL "
       "file)"},
      {"a lying count", binary_stl(kTwo, 4'294'967'295u),
       "m.stl: error: ends after 2 of 4 294 967 295 triangles (byte 80 counts the triangles of "
       "this binary STL file)"},
      {"NaN", binary_stl(two_with(13, kNan), 2),
       "m.stl: error: byte 162: y of the second vertex of triangle 1 must be a finite number, "
       "found "
       "NaN"},
      {"infinity", binary_stl(two_with(0, -kInfinity), 2),
       "m.stl: error: byte 96: x of the first vertex of triangle 0 must be a finite number, found "
       "-infinity"},
  };
  for (const Case& c : cases) EXPECT_EQ(outcome(c.text, "stl"), c.outcome) << c.name;
}

TEST(Stl, StopsAfterTwentyErrors) {
  std::string text = "solid\n";
  for (int i = 0; i < 100; ++i) text += "x\n";
  std::vector<Diagnostic> warnings;
  try {
    read_mesh_text(text, "stl", "m", warnings);
    FAIL();
  } catch (const InputError& e) {
    ASSERT_EQ(e.diagnostics().size(), 20u);
    EXPECT_EQ(e.diagnostics().back().hint, "reading stops after so many errors");
  }
}

TEST(Stl, TellsThePrecisionOfFloats) {
  std::vector<Diagnostic> warnings;
  const auto precision = [&](const std::string& bytes) {
    return read_mesh_text(bytes, "stl", "m", warnings).precision;
  };
  EXPECT_EQ(precision(binary_stl(kTwo, 2)), 0x1p-24);
  EXPECT_EQ(precision(binary_stl(two_with(4, -1000), 2)), 0x1p-15);
  EXPECT_EQ(precision("solid\n" + kFacet + "endsolid"), 0);
}

}  // namespace
}  // namespace overstrike::mesh_tests
