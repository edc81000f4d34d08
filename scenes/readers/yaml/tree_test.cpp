#include "scenes/readers/yaml/tree.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace overstrike::yaml {
namespace {

std::string repeat(std::string_view s, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += s;
  return result;
}

/// What is wrong with the text, without excerpts; empty if nothing.
std::string complaint(std::string_view text) {
  Reporter reporter(text, "t");
  const Tree tree(text, reporter);
  try {
    reporter.throw_errors();
  } catch (const InputError& e) {
    EXPECT_EQ(tree.root(), nullptr);
    const Diagnostic& d = e.diagnostics().front();
    return fmt::format("{}:{} {}{}", d.place.line, d.place.column, d.message,
                       d.hint.empty() ? "" : fmt::format(" ({})", d.hint));
  }
  return {};
}

TEST(Tree, HoldsValuesAndPlaces) {
  const std::string text = "a: 1\nb: [x, \"y\", ~]\nc:\nd: {e: f}\n";
  Reporter reporter(text, "t");
  const Tree tree(text, reporter);
  ASSERT_NE(tree.root(), nullptr);
  const Node& root = *tree.root();
  ASSERT_EQ(root.kind, NodeKind::map);
  ASSERT_EQ(root.entries(), 4u);
  EXPECT_EQ(root.key(1).text, "b");
  EXPECT_EQ(root.value(1).items.size(), 3u);
  EXPECT_FALSE(root.value(1).items[0]->quoted);
  EXPECT_TRUE(root.value(1).items[1]->quoted);
  EXPECT_EQ(root.value(1).items[1]->mark.line, 2);
  EXPECT_EQ(root.value(1).items[1]->mark.column, 8);
  EXPECT_EQ(root.value(1).items[2]->kind, NodeKind::nothing);
  EXPECT_EQ(root.value(2).kind, NodeKind::nothing);
  EXPECT_EQ(root.value(2).mark.line, 3);  // where it is missing
  EXPECT_EQ(describe(root), "a map");
  EXPECT_EQ(describe(root.value(1)), "a list of 3");
  EXPECT_EQ(describe(root.value(2)), "nothing");
}

TEST(Tree, AliasesShareTheirValue) {
  const std::string text = "[&a [1, 2], *a]";
  Reporter reporter(text, "t");
  const Tree tree(text, reporter);
  ASSERT_NE(tree.root(), nullptr);
  EXPECT_EQ(tree.root()->items[0], tree.root()->items[1]);
  EXPECT_EQ(tree.root()->expanded, 7u);
  EXPECT_EQ(tree.root()->height, 3);
}

TEST(Tree, SaysWhatIsNotYaml) {
  EXPECT_EQ(complaint("a: [1, 2\nb: 3"), "2:2 not YAML: a '[' is not closed by a ']'");
  EXPECT_EQ(complaint("a: b: c"), "1:5 not YAML: a ':' that cannot stand here");
  EXPECT_EQ(complaint("a:\n  - b\n c: 3"), "3:2 not YAML: the indentation fits nothing above");
  EXPECT_EQ(complaint("a:\n\t- b"),
            "2:2 not YAML: illegal block entry (indent with blanks, not tabs)");
  EXPECT_EQ(complaint("*x"), "1:1 not YAML: this alias names no value above it");
  EXPECT_EQ(complaint("a: 1\n---\nb: 2"), "2:1 a second document; a scene is one");
  EXPECT_EQ(complaint("a: &x [1, *x]"), "1:11 this alias stands inside the value that it repeats");
}

TEST(Tree, RefusesDeepNesting) {
  const std::string deep = "nested deeper than 480 levels";
  for (const std::string& text :
       {repeat("[", 100000), repeat("{a: ", 100000), repeat("- ", 100000), repeat("? ", 100000)})
    EXPECT_THAT(complaint(text), testing::EndsWith(deep)) << text.substr(0, 4);
  // so many that yaml-cpp must not see them, with closing brackets that close nothing
  for (const std::string& text : {repeat("[", 3000000), repeat("{\n", 3000000),
                                  repeat("[ #]\n", 1000000), repeat("[\"\\\"]\",", 1000000)})
    EXPECT_THAT(complaint(text), testing::EndsWith(deep)) << text.substr(0, 8);
  EXPECT_EQ(complaint(fmt::format("[{}]", repeat("it's, 'a[', \"[\", # [\n", 150000))), "");
  EXPECT_EQ(complaint(repeat("[", 480) + repeat("]", 480)), "");
  // aliases nest what they name
  std::string chain = "[&a0 [1]";
  for (int i = 1; i < 500; ++i) chain += fmt::format(", &a{} [*a{}]", i, i - 1);
  EXPECT_NE(complaint(chain + "]").find(deep), std::string::npos);
}

TEST(Tree, RefusesAliasBombs) {
  std::string bomb = "a0: &a0 [lol, lol, lol, lol, lol, lol, lol, lol, lol, lol]\n";
  for (int i = 1; i < 12; ++i)
    bomb +=
        fmt::format("a{0}: &a{0} [{1}*a{2}]\n", i, repeat(fmt::format("*a{}, ", i - 1), 9), i - 1);
  EXPECT_NE(complaint(bomb).find("more than 4 million values, counting those that aliases repeat"),
            std::string::npos);
}

TEST(Tree, DescribesLongTextsShort) {
  const std::string text = std::string(39, 'a') + "\u00e9\u00e9";
  Reporter reporter(text, "t");
  const Tree tree(text, reporter);
  EXPECT_EQ(describe(*tree.root()), "'" + std::string(39, 'a') + "...'");
}

}  // namespace
}  // namespace overstrike::yaml
