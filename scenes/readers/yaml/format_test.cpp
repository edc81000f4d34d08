// The scene format is said four times: in the reader's key tables, in the schema, on the page that
// documents it and in the scenes that come along. They must agree.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "scenes/readers/read.h"
#include "scenes/readers/yaml/keys.h"
#include "scenes/readers/yaml/tree.h"

namespace overstrike::yaml {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

const fs::path kRoot = OVERSTRIKE_SOURCE_DIR;

std::string content(const fs::path& path) {
  std::ifstream file(path);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

const Node* entry(const Node& map, std::string_view key) {
  for (std::size_t i = 0; map.kind == NodeKind::map && i < map.entries(); ++i)
    if (map.key(i).text == key) return &map.value(i);
  return nullptr;
}

/// The properties of a definition that is an object or may be one.
const Node* properties(const Node& definition) {
  if (const Node* own = entry(definition, "properties")) return own;
  if (const Node* forms = entry(definition, "anyOf"))
    for (const Node* form : forms->items)
      if (const Node* found = properties(*form)) return found;
  return nullptr;
}

Names names(const Node* map) {
  Names result;
  for (std::size_t i = 0; map && i < map->entries(); ++i) result.insert(map->key(i).text);
  return result;
}

TEST(SceneFormat, SchemaAndReaderKnowTheSameKeys) {
  const std::string text = content(kRoot / "scenes/scene.schema.json");
  Reporter reporter(text, "schema");
  const Tree schema(text, reporter);  // JSON is YAML
  reporter.throw_errors();
  const Node* definitions = entry(*schema.root(), "definitions");
  ASSERT_NE(definitions, nullptr);
  Names known;
  for (const MapKind* kind : all_maps()) {
    known.insert(std::string(kind->name));
    const Node* definition = kind == &kSceneMap ? schema.root() : entry(*definitions, kind->name);
    ASSERT_NE(definition, nullptr) << kind->name;
    EXPECT_EQ(names(properties(*definition)), Names(kind->keys.begin(), kind->keys.end()))
        << kind->name;
  }
  for (std::size_t i = 0; i < definitions->entries(); ++i) {
    if (!properties(definitions->value(i))) continue;
    EXPECT_TRUE(known.count(definitions->key(i).text)) << definitions->key(i).text;
  }
}

TEST(SceneFormat, ThePageShowsEveryKey) {
  const std::string page = content(kRoot / "docs/scene-format.md");
  for (const MapKind* kind : all_maps())
    for (const std::string_view key : kind->keys)
      EXPECT_THAT(page, testing::HasSubstr(std::string(key) + ':')) << kind->name;
}

TEST(SceneFormat, EveryExampleOnThePageIsRead) {
  const std::string page = content(kRoot / "docs/scene-format.md");
  const std::string open = "```yaml\n", close = "```\n";
  int examples = 0;
  for (std::size_t at = page.find(open); at != std::string::npos; at = page.find(open, at)) {
    at += open.size();
    const std::string text = page.substr(at, page.find(close, at) - at);
    EXPECT_NO_THROW(read_scene_text(text, "yaml", "example", kRoot / "docs")) << text;
    ++examples;
  }
  EXPECT_GE(examples, 10);
}

TEST(SceneFormat, EverySceneThatComesAlongIsRead) {
  int scenes = 0;
  for (const auto& file : fs::directory_iterator(kRoot / "scenes")) {
    if (file.path().extension() != ".yaml") continue;
    EXPECT_NO_THROW({
      const ReadResult result = overstrike::read_scene(file.path());
      EXPECT_FALSE(result.scene.bodies.empty()) << file.path();
    }) << file.path();
    ++scenes;
  }
  EXPECT_GE(scenes, 10);
}

TEST(SceneFormat, TheTenLineSceneHasTenLines) {
  const std::string text = content(kRoot / "scenes/ten-lines.yaml");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
}

}  // namespace
}  // namespace overstrike::yaml
