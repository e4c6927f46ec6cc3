#include "io/scene_set.h"

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.h"
#include "gtest/gtest.h"
#include "io/output.h"
#include "tests/temporary_folder.h"

namespace rasterproof::io {
namespace {

std::vector<SceneEntry> ReadText(const std::string& text) {
  const TemporaryFolder folder;
  WriteFile(folder.Path("set.json"), text);
  std::vector<SceneEntry> entries = ReadSceneSet(folder.Path("set.json"));
  for (SceneEntry& entry : entries) {
    const std::filesystem::path path(entry.path);
    if (path.parent_path() == folder.path()) entry.path = "beside/" + path.filename().string();
  }
  return entries;
}

TEST(SceneSetTest, PathsAreRelativeToTheFile) {
  const std::vector<SceneEntry> entries = ReadText(R"({"rasterproof_scene_set": 1, "scenes": [
      {"name": "a", "path": "a.json"},
      {"name": "b", "path": "/b.obj", "kind": "real", "camera": "front", "project": "clip",
       "width": 64, "height": 32}]})");
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].path, "beside/a.json");
  EXPECT_FALSE(entries[0].real);
  EXPECT_EQ(entries[1].path, "/b.obj");
  EXPECT_TRUE(entries[1].real);
  EXPECT_EQ(entries[1].camera, "front");
  EXPECT_EQ(entries[1].project, "clip");
  EXPECT_EQ(entries[1].width, 64);
  EXPECT_EQ(entries[1].height, 32);
}

TEST(SceneSetTest, BadSetsAreRefusedWithPlaceAndReason) {
  const auto expect = [](const std::string& scenes, const std::string& part) {
    try {
      ReadText(R"({"rasterproof_scene_set": 1, "scenes": )" + scenes + "}");
      FAIL() << scenes;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  expect("[]", "scenes: names no scene");
  expect("[", "line 1, column");
  expect("7", "scenes: is a number, not an array");
  expect(R"([{"name": "a"}])", "scenes[0]: the key \"path\" is missing");
  expect(R"([{"name": "a", "path": "b", "path": "c"}])", "says the key \"path\" twice");
  expect(R"([{"name": "a", "path": "b", "size": 1}])", "scenes[0]: unknown key \"size\"");
  expect(R"([{"name": "a", "path": "b", "kind": "new"}])", "scenes[0].kind: \"new\" is unknown");
  expect(R"([{"name": "a", "path": "b", "width": 0}])", "scenes[0].width: the number 0");
}

}  // namespace
}  // namespace rasterproof::io
