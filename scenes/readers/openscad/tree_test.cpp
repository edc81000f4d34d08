#include "scenes/readers/openscad/tree.h"

#include <gtest/gtest.h>

#include <string>

#include "scenes/readers/openscad/tokens.h"
#include "scenes/readers/read.h"

namespace overstrike::openscad {
namespace {

std::string errors_of(const std::string& text) {
  try {
    read_scene_text(text, "csg", "m.csg", "nowhere");
  } catch (const InputError& e) {
    return e.what();
  }
  return "none";
}

/// The first line of the first error.
std::string error_of(const std::string& text) {
  const std::string all = errors_of(text);
  return all.substr(0, all.find('\n'));
}

Token token_of(std::string_view text) {
  Reporter reporter(text, "m.csg");
  return Tokens(text, reporter).next();
}

TEST(Tokens, NumbersOfSixDigitsMayBeOffByHalfOfTheLast) {
  struct Case {
    const char* text;
    double value, precision;
  };
  for (const Case& c : {Case{"0.866025", 0.866025, 5e-7}, Case{"123.457", 123.457, 5e-4},
                        Case{"10", 10, 0}, Case{"1.5", 1.5, 0}, Case{"-77.7778", -77.7778, 5e-5},
                        Case{"1.23457e-09", 1.23457e-09, 5e-15}, Case{"100000", 100000, 0.5},
                        Case{"1e-09", 1e-09, 0}, Case{"0.00012", 0.00012, 0},
                        Case{"3.14159265", 3.14159265, 5e-9}, Case{"-0", 0, 0}}) {
    const Token token = token_of(c.text);
    EXPECT_EQ(token.kind, TokenKind::number) << c.text;
    EXPECT_DOUBLE_EQ(token.number, c.value) << c.text;
    EXPECT_NEAR(token.precision, c.precision, c.precision * 1e-12) << c.text;
  }
}

TEST(Tokens, InfinityAndNotANumberAreNumbers) {
  EXPECT_TRUE(std::isinf(token_of("inf").number));
  EXPECT_TRUE(std::signbit(token_of("-inf").number));
  EXPECT_TRUE(std::isnan(token_of("nan").number));
  EXPECT_EQ(token_of("infinite").kind, TokenKind::word);
}

TEST(Tokens, EscapesOfStrings) {
  EXPECT_EQ(token_of(R"("a\"b\\\n\x41\u00e9")").text, "a\"b\\\nA\xC3\xA9");
}

TEST(Tree, NodesAndValuesStandInPreorder) {
  const std::string text =
      "// one\ngroup() { %cube(size = [1, [2, 3]]); /* two */ *sphere(r = 1); }\n#union();";
  Reporter reporter(text, "m.csg");
  const Tree tree = parse(text, reporter);
  ASSERT_EQ(tree.nodes.size(), 5u);
  EXPECT_EQ(tree.nodes[1].end, 4u);
  EXPECT_TRUE(tree.nodes[2].background);
  EXPECT_TRUE(tree.nodes[3].disabled);
  EXPECT_EQ(tree.nodes[4].name, "union");
  EXPECT_EQ(tree.nodes[2].at.column, 12);
  ASSERT_EQ(tree.values.size(), 6u);
  EXPECT_EQ(tree.values[0].end, 5u);  // the outer list
  EXPECT_EQ(tree.values[2].end, 5u);  // the inner one
}

TEST(Tree, AMarkedNodeIsTheRoot) {
  const std::string text = "cube(); !group() { sphere(); }";
  Reporter reporter(text, "m.csg");
  EXPECT_EQ(parse(text, reporter).root, 2u);
}

TEST(Tree, SaysWhereItIsWrong) {
  EXPECT_EQ(
      error_of("cube(size = [1, 2, 3]"),
      "m.csg:1:22: error: expected ',' after an argument of 'cube', found the end of the file");
  EXPECT_EQ(error_of("group() {\n  cube();\n"),
            "m.csg:3:1: error: expected '}' for the '{' of 'group' in line 1, found the end of the "
            "file");
  EXPECT_EQ(error_of("cube();\n}"), "m.csg:2:1: error: '}' without '{'");
  EXPECT_EQ(error_of("cube(size = x);"),
            "m.csg:1:13: error: expected a value, found 'x' (a .csg file has no variables)");
  EXPECT_EQ(error_of("cube(size = \"a);"),
            "m.csg:1:13: error: the string has no end (it ends with \")");
  EXPECT_EQ(error_of("/* cube();"), "m.csg:1:1: error: the comment has no end (it ends with */)");
  EXPECT_EQ(error_of("cube(size = 1.2.3);"), "m.csg:1:13: error: expected a number, found '1.2.3'");
  EXPECT_EQ(error_of("module f() { cube(); }"),
            "m.csg:1:1: error: 'module' belongs to a program, not to a .csg file (name the file "
            ".scad, and OpenSCAD is asked what it makes)");
  EXPECT_EQ(error_of("x = 3;"),
            "m.csg:1:1: error: 'x' belongs to a program, not to a .csg file (name the file .scad, "
            "and OpenSCAD is asked what it makes)");
}

TEST(Tree, SaysWhichWordIsWrong) {
  EXPECT_EQ(error_of("cub(size = 1);"),
            "m.csg:1:1: error: unknown node 'cub' (did you mean 'cube'?)");
  EXPECT_EQ(error_of("translate() { cube(); }"),
            "m.csg:1:1: error: 'translate' belongs to a program, not to a .csg file (name the file "
            ".scad, and OpenSCAD is asked what it makes)");
  EXPECT_EQ(error_of("group() {\n\troof() { square(); }\n}"),
            "m.csg:2:2: error: 'roof' cannot be drawn: straight skeletons are not computed");
  EXPECT_EQ(error_of("cube(size = [1, \"a\", 2]);"),
            "m.csg:1:17: error: size must be a number, found a string");
  EXPECT_EQ(error_of("multmatrix([[1, 0, 0], [0, 1, 0], [0, 0, 1]]) { cube(); }"),
            "m.csg:1:13: error: a matrix's row must be 4 numbers, found 3");
  EXPECT_EQ(error_of("polyhedron(points = [[0, 0, 0]], faces = [[0, 1, 2]]);"),
            "m.csg:1:47: error: point 1 does not exist (there are 1, numbered from 0)");
}

TEST(Tree, SaysWhichNodeNamesAFileThatCannotBeRead) {
  EXPECT_EQ(error_of("cube();\n  import(file = \"none.stl\");"),
            "m.csg:2:3: error: 'import' cannot be drawn: nowhere/none.stl: No such file or "
            "directory");
  EXPECT_EQ(error_of("linear_extrude() { import(file = \"none.dxf\"); }"),
            "m.csg:1:20: error: 'import' cannot be drawn: nowhere/none.dxf: No such file or "
            "directory");
  EXPECT_EQ(error_of("surface(file = \"none.dat\");"),
            "m.csg:1:1: error: 'surface' cannot be drawn: nowhere/none.dat: No such file or "
            "directory");
  EXPECT_EQ(error_of("cube(); import();"),
            "m.csg:1:9: error: 'import' names no file (file = \"...\")");
  EXPECT_EQ(error_of("surface(file = \"\");"),
            "m.csg:1:1: error: 'surface' names no file (file = \"...\")");
}

std::string nested(const std::string& before, const std::string& inner, const std::string& after) {
  constexpr int kDeep = 100'000;
  std::string text;
  for (int i = 0; i < kDeep; ++i) text += before;
  text += inner;
  for (int i = 0; i < kDeep; ++i) text += after;
  return text;
}

TEST(Tree, NoDepthOverflows) {
  EXPECT_EQ(errors_of(nested("group() {", "cube();", "}")), "none");
  EXPECT_EQ(errors_of(nested("difference() { cube();", "sphere();", "}")), "none");
  EXPECT_EQ(errors_of(nested("linear_extrude() {", "square();", "}")), "none");
  EXPECT_EQ(error_of("cube(size = " + nested("[", "1", "]") + ");"),
            "m.csg:1:13: error: size must be 3 numbers, found 1");
}

}  // namespace
}  // namespace overstrike::openscad
