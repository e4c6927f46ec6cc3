#include "io/case_file.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "gtest/gtest.h"
#include "io/output.h"
#include "io/scene_file.h"
#include "tests/temporary_folder.h"

namespace rasterproof::io {
namespace {

Scene OneTriangle() {
  Scene scene;
  scene.name = "one";
  scene.width = 8;
  scene.height = 4;
  scene.vertices = {{0.25, 0, 0, 1}, {4, 0x1p-149, 0, 1}, {0, -0.0, 0, 1}};
  scene.triangles = {{0, 1, 2}};
  return scene;
}

void ExpectReadsBack(const CaseFile& file) {
  const std::string text = CaseToJson(file);
  const CaseFile back = ParseCase(text, "written");
  EXPECT_EQ(back.value, file.value) << text;
  EXPECT_EQ(back.subject, file.subject);
  EXPECT_EQ(back.property, file.property);
  ASSERT_EQ(back.drawn == nullptr, file.drawn == nullptr);
  if (file.drawn != nullptr) {
    EXPECT_EQ(*back.drawn, *file.drawn);
  }
}

TEST(CaseFileTest, CasesReadBack) {
  CaseFile file{{OneTriangle(), Profile{}, DrawOptions{}, "needles:17@1"}, "f32", "Property"};
  ExpectReadsBack(file);
  for (const std::string_view name : kPresetProfiles) {
    file.value.profile = *PresetProfile(name);
    ExpectReadsBack(file);
    EXPECT_NE(CaseToJson(file).find("\"profile\": \"" + std::string(name) + "\""),
              std::string::npos);
  }
  file.value.scene.channels = {{.name = "u", .values = {0.25, -0.0, 0x1p-149}},
                               {"w", Interpolation::kInverseW, EvaluatedAt::kCentroid, {}}};
  ExpectReadsBack(file);
  file.value.options = {Cull::kBack, PixelRect{-1, 0, 5, 2147483647}, 16, 4};
  ExpectReadsBack(file);
  Scene wider = OneTriangle();
  wider.width = 9;
  file.drawn = std::make_shared<const DrawnScene>(wider, DrawOptions{.scissor = {{0, 0, 8, 4}}});
  ExpectReadsBack(file);
}

TEST(CaseFileTest, DrawingsReadBack) {
  CaseFile file{{OneTriangle(), Profile{}, DrawOptions{}, ""}, "exact", ""};
  const Scene& scene = file.value.scene;
  const auto rows = static_cast<std::uint32_t>(scene.height);
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t k = 0; k < 2 * rows; ++k) numbers.push_back(k == 1 ? UINT32_MAX : k);
  for (const DrawingShows shows :
       {DrawingShows::kCounts, DrawingShows::kMask, DrawingShows::kIds}) {
    for (const bool has_fronts : {false, true}) {
      file.drawing = {shows, "last", numbers, {}};
      if (has_fronts) file.drawing->fronts.assign(2 * rows, 1);
      EXPECT_EQ(ParseCase(CaseToJson(file), "written").drawing, file.drawing);
    }
  }
  file.drawing = CaseDrawing{};  // of rows without a number, which no target has
  EXPECT_EQ(ParseCase(CaseToJson(file), "written").drawing, file.drawing);
}

TEST(CaseFileTest, EveryPartOfAProfileReadsBack) {
  CaseFile file;
  file.value.scene = OneTriangle();
  file.value.scene.precision = Precision::kFloat64;
  Profile& profile = file.value.profile;
  profile.name = "mine";
  profile.snap = {4, SnapRule::kFloor, SnapForm::kFloat32Difference, 0x1p-8};
  profile.freedom = {0.6, true};
  profile.pattern.locations = {{0, 0}, {0x1.fep-1, 0x1p-8}, {0.375, 0.875}};
  profile.y_axis = YAxis::kUp;
  profile.tie_rule = {-1, +1, true, false};
  profile.contract = Contract::kWatertight;
  profile.coordinate_limit = 0x1.23456789abcdep-1000;
  ExpectReadsBack(file);
  profile.snap.bits = Snap::kNone;
  profile.tie_rule = TieRule{.inclusive = true};
  for (const Contract contract :
       {Contract::kClosed, Contract::kAtLeastModel, Contract::kAtMostModel, Contract::kNone}) {
    profile.contract = contract;
    ExpectReadsBack(file);
  }
  profile.freedom = {0, true};
  profile.snap = {8, SnapRule::kHalfUp, SnapForm::kExactDifference, 0};
  ExpectReadsBack(file);
}

TEST(CaseFileTest, WhatAProfileDoesNotUseIsNotWritten) {
  Profile profile;
  profile.name = "mine";
  for (const char* key : {"snap_form", "snap_origin", "snap_tolerance", "tie_ownership"}) {
    EXPECT_EQ(ProfileToJson(profile).find(key), std::string::npos) << key;
  }
}

TEST(CaseFileTest, ABareSceneIsACaseOfRealGeometry) {
  const CaseFile file = ParseCase(SceneToJson(OneTriangle()), "scene.json");
  EXPECT_EQ(file.value.scene, OneTriangle());
  EXPECT_EQ(file.value.profile, Profile{});
  EXPECT_EQ(file.value.options, DrawOptions{});
}

TEST(CaseFileTest, AbsentKeysOfAProfileAreThoseOfReal) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("profile.json");
  WriteFile(path, R"({"name": "mine", "subpixel_bits": 4})");
  Profile expected;
  expected.name = "mine";
  expected.snap.bits = 4;
  EXPECT_EQ(ReadProfile(path), expected);
  WriteFile(path, "\"gl-canonical\"");
  EXPECT_EQ(ReadProfile(path), *PresetProfile("gl-canonical"));
  EXPECT_EQ(ReadProfile("vulkan-canonical"), *PresetProfile("vulkan-canonical"));
}

TEST(CaseFileTest, AnUnknownProfileNameIsToldThePresets) {
  try {
    ReadProfile("d3d12");
    FAIL();
  } catch (const InputError& error) {
    const std::string told = error.what();
    EXPECT_TRUE(told.starts_with(
        "profile \"d3d12\": is neither a preset nor a file; did you mean d3d11? the presets are\n"
        "  real, d3d11-canonical, vulkan-canonical, gl-canonical, d3d11, vulkan, gl,\n"))
        << told;
    EXPECT_TRUE(told.ends_with(", voxel")) << told;
  }
}

TEST(CaseFileTest, BadCasesAreRefusedWithPlaceAndReason) {
  const auto message = [](const std::string& parts) -> std::string {
    std::string scene = SceneToJson(OneTriangle());
    try {
      ParseCase(R"({"rasterproof_case": 2, "scene": )" + scene + parts + "}", "case.json");
    } catch (const InputError& error) {
      return error.what();
    }
    return "(accepted)";
  };
  const auto profile = [&](const std::string& parts) {
    return message(R"(, "profile": {"name": "p", )" + parts + "}");
  };
  struct Bad {
    std::string message;
    std::string expected;
  };
  const std::vector<Bad> all{
      {message(""), "(accepted)"},
      {message(R"(, "seed": 1)"), "case.json: unknown key \"seed\""},
      {message(R"(, "profile": "d3d12")"), "case.json: profile: the profile \"d3d12\" is unknown"},
      {message(R"(, "profile": 7)"), "profile: is a number, not an object"},
      {message(R"(, "profile": {})"), "profile: the key \"name\" is missing"},
      {message(R"(, "subject": 7)"), "subject: is a number, not a string"},
      {message(R"(, "options": [])"), "options: is an array, not an object"},
      {message(R"(, "options": {"cull": "both"})"),
       "options.cull: \"both\" is unknown; known here are none, front, back"},
      {message(R"(, "options": {"scissor": [0, 0, 1]})"), "options.scissor: has 3 sides"},
      {message(R"(, "options": {"scissor": [0, 0, 1, 4294967296]})"), "options.scissor[3]"},
      {message(R"(, "options": {"tile": -1})"), "options.tile: the number -1 is out of range"},
      {message(R"(, "options": {"threads": 1.5})"), "options.threads: the number 1.5 is not"},
      {profile(R"("colour": 1)"), "profile: unknown key \"colour\""},
      {profile(R"("no_clip": null)"), "unknown key \"no_clip\", which is guard_band now"},
      {profile(R"("subpixel_bits": 17)"), "profile.subpixel_bits: the number 17 is out of range"},
      {profile(R"("subpixel_bits": -1)"), "out of range"},
      {profile(R"("snap_rule": "up")"), "profile.snap_rule: \"up\" is unknown; known here are"},
      {profile(R"("snap_form": "edge")"), "profile.snap_form: \"edge\" is unknown; known here are"},
      {profile(R"("snap_origin": 1)"), "profile.snap_origin: is not a snap origin"},
      {profile(R"("snap_tolerance": -0.5)"), "is not a snap tolerance"},
      {profile(R"("snap_tolerance": 1.5)"), "a number of grid steps from 0 to 1"},
      {profile(R"("tie_ownership": "mine")"), "tie_ownership"},
      {profile(R"("tie_rule": "left")"), "profile.tie_rule: \"left\" is not a tie rule"},
      {profile(R"("y_axis": "left")"), "profile.y_axis: \"left\" is unknown"},
      {profile(R"("contract": "good")"), "profile.contract: \"good\" is unknown"},
      {profile(R"("sample_locations": [])"), "has 0 sample locations; write from 1 to 64"},
      {profile(R"("sample_locations": [[0.5]])"), "sample_locations[0]: has 1 coordinates"},
      {profile(R"("sample_locations": [[0.5, 1]])"),
       "profile.sample_locations[0][1]: is not a sample location"},
      {profile(R"("sample_locations": [[0.1, 0]])"), "multiple of 1/256"},
      {profile(R"("sample_locations": [["nan", 0]])"), "is not a sample location"},
      {profile(R"("coordinate_limit": 0)"), "profile.coordinate_limit: is not a limit"},
      {profile(R"("coordinate_limit": "inf")"), "is not a limit"},
  };
  for (const Bad& bad : all) {
    EXPECT_NE(bad.message.find(bad.expected), std::string::npos)
        << bad.message << "\n  expected: " << bad.expected;
  }
}

TEST(CaseFileTest, ErrorsInsideTheSceneNameTheirPlaceInTheCase) {
  try {
    ParseCase(R"({"rasterproof_case": 2, "scene": {"rasterproof_scene": 1, "width": 1,
                  "height": 1, "vertices": [[0, 0], [0, 1e400]], "triangles": []}})",
              "case.json");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string_view(error.what()).starts_with("case.json: scene.vertices[1][1]: "))
        << error.what();
  }
}

}  // namespace
}  // namespace rasterproof::io
