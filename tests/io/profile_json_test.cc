// The keys of a profile that most profiles leave out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "core/error.h"
#include "core/square_presets.h"
#include "io/case_file.h"
#include "model/target_profile.h"

namespace rasterproof::io {
namespace {

void ExpectReadsBack(const Profile& profile) {
  const std::string text = ProfileToJson(profile);
  EXPECT_EQ(ParseProfile(text, "written"), profile) << text;
}

TEST(ProfileJson, RareKeysReadBack) {
  Profile profile;
  profile.name = "mine";
  ExpectReadsBack(profile);
  profile.fixed = FixedInput{12, 4, true, false};
  ExpectReadsBack(profile);
  profile.fixed = FixedInput{31, 16, false, true};
  profile.max_primitive_extent = MaxPrimitiveExtent{1023.5, 511};
  profile.max_target = {2048, 1};
  profile.guard_band = WindowBox{-1024, -0.1, 1023, 0x1p30};
  profile.degenerate_triangles = DegenerateTriangles::kUnspecified;
  profile.infinite_vertex = InfiniteVertex::kUnspecified;
  profile.shares_edge_samples = true;
  profile.tie_rule = {.exclusive = true};
  ExpectReadsBack(profile);
}

TEST(ProfileJson, ANameNeverSpeaksToTheTerminal) {
  const auto name = [](const std::string& written) {
    return ParseProfile(R"({"name": ")" + written + R"("})", "written").name;
  };
  EXPECT_EQ(name("\\u001b]0;mine\\u0007"), "\\x1b]0;mine\\x07");
  EXPECT_EQ(name("\\u009b31m"), "\\xc2\\x9b31m");
  EXPECT_EQ(name("stra\\u00dfe 1"), "stra\u00dfe 1");
}

TEST(ProfileJson, SampleLocationsAreNamedOrListedAsFractions) {
  const auto parsed = [](const std::string& locations) {
    return ParseProfile(R"({"name": "p", "sample_locations": )" + locations + "}", "p.json")
        .pattern;
  };
  EXPECT_EQ(parsed(R"("standard-4")"), *StandardPattern(4));
  EXPECT_EQ(parsed(R"("standard-16")"), *StandardPattern(16));
  EXPECT_EQ(parsed(R"([["3/8", "1/8"], ["7/8", 0.375], [0.125, "160/256"], ["5/8", "14/16"]])"),
            *StandardPattern(4));
  Profile profile;
  profile.name = "mine";
  profile.pattern = *StandardPattern(8);
  profile.sample_positions = SamplePositions::kFixed;
  ExpectReadsBack(profile);
  profile.sample_positions = SamplePositions::kVary;
  profile.pattern.locations.assign(kMaxSamplesPerPixel, {255 / 256.0, 1 / 256.0});
  ExpectReadsBack(profile);
}

TEST(ProfileJson, PresetsOfSeveralSamplesLeavePositionsOpenWhereTheApiDoes) {
  for (const std::string_view name : {"d3d11-2x", "d3d11-canonical-8x", "vulkan-standard-4x",
                                      "vulkan-16x", "gl-4x", "webgpu-4x"}) {
    const Profile preset = *PresetProfile(name);
    EXPECT_EQ(preset, ParseProfile('"' + std::string(name) + '"', "p.json"));
    EXPECT_EQ(preset.pattern, StandardPattern(preset.pattern.samples()));
    const bool is_open = name == "vulkan-16x" || name == "gl-4x";
    EXPECT_EQ(preset.sample_positions == SamplePositions::kVary, is_open) << name;
    EXPECT_FALSE(preset.translation_invariant) << name;
    ExpectReadsBack(preset);
  }
  for (const std::string_view name : {"d3d11-3x", "d3d11-x", "d3d9-4x", "-4x", "gl-4x-4x"})
    EXPECT_FALSE(PresetProfile(name)) << name;
}

TEST(ProfileJson, PresetsOfSetsStateCentroidsAsTheirApisDo) {
  for (const std::string_view samples : {"", "-2x", "-4x", "-8x", "-16x"}) {
    const auto stated = [&](std::string api) {
      const Profile preset = *PresetProfile(api + std::string(samples));
      ExpectReadsBack(preset);
      return preset.centroid;
    };
    EXPECT_EQ(stated("d3d11"), Centroid::kDirect3D);
    for (const char* const api : {"vulkan", "gl", "webgpu"})
      EXPECT_EQ(stated(api), Centroid::kInside) << api;
    EXPECT_EQ(stated("gl-canonical"), Centroid::kUnstated);
  }
  EXPECT_EQ(PresetProfile("vulkan-standard-4x")->centroid, Centroid::kInside);
  Profile profile;
  profile.name = "mine";
  for (const Centroid centroid : {Centroid::kDirect3D, Centroid::kInside}) {
    profile.centroid = centroid;
    ExpectReadsBack(profile);
  }
  EXPECT_EQ(ParseProfile(R"({"name": "p", "centroid": "unstated"})", "p.json").centroid,
            Centroid::kUnstated);
}

TEST(ProfileJson, CrossingAndTransformReadBack) {
  Profile profile;
  profile.name = "scanline";
  profile.scanline_rounding = {16, SnapRule::kFloor, SnapForm::kExactDifference, 0.5};
  profile.transform = Transform{Precision::kFloat64, Division::kReciprocal,
                                ViewportForm::kAddMultiply, /*flips_y=*/true};
  ExpectReadsBack(profile);
}

TEST(ProfileJson, ADevicesNumbersReadBack) {
  const Profile device = ParseProfile(
      R"({"name": "card", "specification": "vulkan", "subpixel_bits": 6, "coordinate_limit": 4096,
          "guard_band": [-64, -64, 64, 64], "sample_locations": [[0.25, 0.75]]})",
      "device");
  EXPECT_EQ(device.snap.bits, 6);
  EXPECT_EQ(device.freedom.least_bits, std::nullopt);
  EXPECT_TRUE(device.freedom.any_rounding);
  EXPECT_EQ(device.nan_vertex, NanVertex::kUnspecified);
  ExpectReadsBack(device);
  const Profile at_least = ParseProfile(
      R"({"name": "card", "specification": "gl", "least_subpixel_bits": 8})", "device");
  EXPECT_EQ(at_least.freedom.least_bits, 8);
  EXPECT_TRUE(at_least.translation_invariant);
  ExpectReadsBack(at_least);
}

TEST(ProfileJson, ADeviceMayNotLeaveItsSpecification) {
  const auto refusal = [](const std::string& keys) -> std::string {
    try {
      ParseProfile(R"({"name": "card", "specification": )" + keys + "}", "device");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  using testing::HasSubstr;
  EXPECT_EQ(refusal(R"("vulkan", "subpixel_bits": 4)"), "");
  EXPECT_THAT(refusal(R"("vulkan", "subpixel_bits": 3)"), HasSubstr("\"subpixel_bits\""));
  EXPECT_THAT(refusal(R"("vulkan", "least_subpixel_bits": 3)"), HasSubstr("\"subpixel_bits\""));
  EXPECT_THAT(refusal(R"("vulkan", "subpixel_bits": null)"), HasSubstr("\"subpixel_bits\""));
  EXPECT_THAT(refusal(R"("d3d11", "subpixel_bits": 12)"), HasSubstr("\"subpixel_bits\""));
  EXPECT_THAT(refusal(R"("vulkan", "rounding": "stated")"), HasSubstr("\"rounding\""));
  EXPECT_THAT(refusal(R"("d3d11", "tie_ownership": "open")"), HasSubstr("\"tie_ownership\""));
  EXPECT_THAT(refusal(R"("vulkan", "nan_vertex": "nothing")"), HasSubstr("\"nan_vertex\""));
  EXPECT_THAT(refusal(R"("d3d11", "contract": "none")"), HasSubstr("\"contract\""));
  EXPECT_THAT(refusal(R"("gl-canonical")"), HasSubstr("legal set"));
  EXPECT_THAT(refusal(R"("mine")"), HasSubstr("legal set"));
}

TEST(ProfileJson, AMapReadsBack) {
  Profile profile;
  profile.name = "map";
  profile.transform =
      Transform{.precision = Precision::kFloat64, .map = MapGrid{872512, 6114970, 1.0 / 3, -0.1}};
  ExpectReadsBack(profile);
}

TEST(ProfileJson, TargetsReadBackWithWhatTheyOverride) {
  Profile profile;
  profile.name = "mine";
  profile.snap = {8, SnapRule::kFloor, SnapForm::kExactDifference, 0.5};
  profile.by_target_size = {
      {.max_width = 2048, .max_height = 1024, .snap = {6}, .tie_rule = {-1, +1, true}},
      {.snap = {}, .pattern = {{{0.25, 0.75}}}}};
  ExpectReadsBack(profile);
}

TEST(ProfileJson, ATargetHasOfTheProfileWhatItLeavesOut) {
  const Profile profile = ParseProfile(
      R"({"name": "p", "tie_rule": "bottom-left", "subpixel_bits": 4, "snap_rule": "floor",
          "by_target_size": [{"max_width": 2048, "max_height": 2048, "subpixel_bits": 8}]})",
      "p.json");
  ASSERT_EQ(profile.by_target_size.size(), 1U);
  EXPECT_EQ(profile.by_target_size[0].snap, (Snap{8, SnapRule::kFloor}));
  EXPECT_EQ(profile.by_target_size[0].tie_rule, profile.tie_rule);
  EXPECT_EQ(TargetProfile(profile, 2049, 1).snap.bits, 4);
}

TEST(ProfileJson, KeysThatAreLeftOutSayWhatTheyAlwaysDid) {
  const Profile profile = ParseProfile(R"({"name": "p", "fixed": null, "max_primitive_extent": null,
                                          "guard_band": null, "by_target_size": []})",
                                       "p.json");
  EXPECT_FALSE(profile.fixed || profile.max_primitive_extent || profile.guard_band);
  EXPECT_EQ(profile.degenerate_triangles, DegenerateTriangles::kNothing);
  EXPECT_EQ(profile.infinite_vertex, InfiniteVertex::kNothing);
  EXPECT_FALSE(profile.shares_edge_samples);
  const Profile fixed =
      ParseProfile(R"({"name": "p", "fixed": {"integer_bits": 9, "fraction_bits": 0}})", "p.json");
  EXPECT_EQ(fixed.fixed, (FixedInput{9, 0, true, false}));
}

std::string WhyRefused(const std::string& json) {
  try {
    ParseProfile(json, "p.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "it is read";
}

TEST(ProfileJson, SquaresAreReadBackAsTheyAreWritten) {
  for (const SquarePresetInfo& preset : kSquarePresets) {
    Profile profile = *PresetProfile(preset.name);
    EXPECT_EQ(ParseProfile(ProfileToJson(profile), "written"), profile);
    profile.name = "own";
    EXPECT_EQ(ParseProfile(ProfileToJson(profile), "written"), profile) << preset.name;
  }
  const Profile own = ParseProfile(
      R"({"name": "own", "contract": "squares", "coverage": {"may":
          {"relation": "intersects", "growth": "edges", "half_width": "0x1p-9"}}})",
      "p.json");
  EXPECT_FALSE(own.squares->must);
  EXPECT_EQ(own.squares->may->growth, SquareGrowth::kEdges);
  EXPECT_EQ(own.squares->may->half_width, 0x1p-9);
  EXPECT_EQ(own.squares->flat, FlatSquares::kNothing);
}

TEST(ProfileJson, SquaresThatCannotBeDecidedAreRefused) {
  const std::string head = R"({"name": "p", "contract": "squares", "coverage": )";
  EXPECT_EQ(WhyRefused(R"({"name": "p", "contract": "squares"})"),
            "p.json: has the key coverage or the contract squares, but not both; write both: "
            "\"contract\": \"squares\" is about what coverage states");
  EXPECT_EQ(WhyRefused(head + "{}}"),
            "p.json: coverage: states neither a must nor a may region; give it a must or a may "
            "region, or leave coverage out");
  EXPECT_EQ(WhyRefused(head + R"({"may": {"relation": "intersects", "half_width": 1.5}}})"),
            "p.json: coverage.may.half_width: is not a half width; write a multiple of 2^-20 "
            "pixel, at least -7/16 and at most 1");
  EXPECT_EQ(WhyRefused(head + R"({"may": {"relation": "intersects", "shape": "half-open"}}})"),
            "p.json: coverage.may: lets a closed square meet a half-open shape, which the oracle "
            "can't decide; write a half-open square, or an open or closed shape");
}

TEST(ProfileJson, TheOldWordsForBoundsAreToldTheNewOnes) {
  const std::string old = std::string("conservative") + "-over";
  const std::string why = WhyRefused(R"({"name": "p", "contract": ")" + old + "\"}");
  EXPECT_NE(why.find(old + "\" is unknown, which is at-least-model now"), std::string::npos) << why;
}

TEST(ProfileJson, APresetsNameIsForWhatThePresetSays) {
  for (const std::string_view name : kPresetProfiles) {
    const Profile preset = *PresetProfile(name);
    Profile other = preset;
    other.snap.bits = 4;
    EXPECT_EQ(ProfileName(preset), name);
    EXPECT_NE(ProfileName(other), name);
    // What is written is read back, and never under the preset's name.
    Profile renamed = other;
    renamed.name = ProfileName(other);
    EXPECT_EQ(ParseProfile(ProfileToJson(other), "written"), renamed);
  }
  const std::string vulkan =
      R"({"name": "vulkan-canonical", "subpixel_bits": 8, "coordinate_limit": 32768,
                                 "infinite_vertex": "unspecified"})";
  EXPECT_EQ(ParseProfile(vulkan, "p.json"), *PresetProfile("vulkan-canonical"));
  try {
    ParseProfile(R"({"name": "vulkan-canonical", "subpixel_bits": 4})", "p.json");
    ADD_FAILURE() << "a profile of 4 bits is taken for the preset of 8";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "p.json: name: \"vulkan-canonical\" names a preset, but this differs from the preset; give "
        "it another name, or write \"vulkan-canonical\" alone for the preset");
  }
}

std::string Message(const std::string& member) {
  try {
    ParseProfile(R"({"name": "p", )" + member + "}", "p.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted: " + member;
}

TEST(ProfileJson, BadValuesNameTheirPlaceTheReasonAndTheRemedy) {
  struct Bad {
    std::string member;
    std::string_view expected;
  };
  for (const Bad& bad : {
           Bad{R"("fixed": 12.4)", "p.json: fixed: "},
           Bad{R"("fixed": {"integer_bits": 12})", "fraction_bits"},
           Bad{R"("fixed": {"integer_bits": 0, "fraction_bits": 4})",
               "fixed.integer_bits: the number 0 is out of range"},
           Bad{R"("fixed": {"integer_bits": 32, "fraction_bits": 4})", "out of range"},
           Bad{R"("fixed": {"integer_bits": 12, "fraction_bits": 17})", "out of range"},
           Bad{R"("fixed": {"integer_bits": 12, "fraction_bits": 4, "wrap": 1})",
               "fixed.wrap: is neither true nor false; write true or false"},
           Bad{R"("fixed": {"integer_bits": 12, "fraction_bits": 4, "bits": 1})",
               "unknown key \"bits\""},
           Bad{R"("max_primitive_extent": [1024])",
               "max_primitive_extent: has 1 numbers; write [width, height]"},
           Bad{R"("max_primitive_extent": [1024, 0])",
               "max_primitive_extent: is not a triangle size"},
           Bad{R"("max_primitive_extent": ["nan", 1])", "max_primitive_extent[0]: is not finite"},
           Bad{R"("rounding": "unspecified", "front_face": "unstated", "culls": "back")",
               "p.json: culls one side and leaves front_face unstated"},
           Bad{R"("max_target": [64])", "max_target: has 1 numbers; write [width, height]"},
           Bad{R"("max_target": [64, 0])", "max_target[1]"},
           Bad{R"("max_target": [65537, 1])", "max_target[0]"},
           Bad{R"("guard_band": [0, 0, 1])", "guard_band: has 3 numbers"},
           Bad{R"("guard_band": [0, 0, 0, 1])", "guard_band: is empty; write x0 < x1 and y0 < y1"},
           Bad{R"("guard_band": [0, 0, "inf", 1])", "guard_band[2]: is not finite"},
           Bad{R"("scanline_rounding": {"rule": "floor"})", "bits"},
           Bad{R"("sample_locations": "standard-3")",
               "sample_locations: \"standard-3\" is not a standard pattern; write standard-1, -2"},
           Bad{R"("sample_locations": [["1/3", 0]])", "is not a sample location"},
           Bad{R"("sample_locations": [["8/8", 0]])", "is not a sample location"},
           Bad{R"("sample_locations": [["1/0", 0]])", "sample_locations[0][0]"},
           Bad{R"("sample_positions": "random")", "sample_positions: \"random\" is unknown"},
           Bad{R"("centroid": "centre")", "centroid: \"centre\" is unknown; known here are"},
           Bad{R"("scanline_rounding": {"bits": 17})", "scanline_rounding.bits"},
           Bad{R"("transform": {"map": [0, 0, 1, 0]})",
               "transform.map: has a step of zero; write dx and dy in the map's units, dy < 0 for "
               "y up"},
           Bad{R"("transform": {"map": [0, 0, 1, 1], "flips_y": true})",
               "transform: has a map and a viewport; leave viewport and flips_y out: a map's dy "
               "flips y"},
           Bad{R"("transform": {"division": "rcp"})",
               "transform.division: \"rcp\" is unknown; known here are"},
           Bad{R"("transform": {"viewport": "half"})", "none, multiply-add, fused, add-multiply"},
           Bad{R"("transform": {"matrix": 1})", "unknown key \"matrix\""},
           Bad{R"("degenerate_triangles": "line")",
               "degenerate_triangles: \"line\" is unknown; known here are"},
           Bad{R"("infinite_vertex": "clamped")", "infinite_vertex: \"clamped\" is unknown; known"},
           Bad{R"("edge_samples": true)", "edge_samples: "},
           Bad{R"("tie_rule": "none")", "inclusive or exclusive"},
           Bad{R"("by_target_size": {})", "by_target_size: "},
           Bad{R"("by_target_size": [{"max_width": 0}])",
               "by_target_size[0].max_width: the number 0 is out of"},
           Bad{R"("by_target_size": [{"name": "q"}])", "by_target_size[0]: unknown key \"name\""},
           Bad{R"("by_target_size": [{"sample_locations": [[0, 0], [0, 0.5]]}])",
               "by_target_size[0].sample_locations: has 2 sample locations, the profile 1"},
           Bad{R"("by_target_size": [{"max_width": 64}, {"max_width": 32, "max_height": 32}])",
               "by_target_size[1]: never applies"},
       }) {
    const std::string message = Message(bad.member);
    EXPECT_NE(message.find(bad.expected), std::string::npos)
        << message << "\n  expected: " << bad.expected;
  }
}

TEST(ProfileJson, NamesTheGuardBandOrGivesItsRectangle) {
  const auto band = [](const std::string& text) {
    return ParseProfile(R"({"name": "mine", "guard_band": )" + text + "}", "p.json").guard_band;
  };
  EXPECT_EQ(band("null"), std::nullopt);
  EXPECT_EQ(band(R"("none")"), std::nullopt);
  EXPECT_EQ(band(R"("unknown")"), GuardBand(SomewhereAroundTarget{}));
  EXPECT_EQ(band(R"("viewport")"), GuardBand(AroundTarget{0}));
  EXPECT_EQ(band(R"("viewport+64")"), GuardBand(AroundTarget{64}));
  for (const char* text : {R"("viewport+")", R"("viewport-1")", R"("viewport+1.5")", R"("all")"}) {
    EXPECT_THROW(band(text), InputError) << text;
  }
  Profile profile = *PresetProfile("gl");
  for (const GuardBand& stated : {GuardBand(SomewhereAroundTarget{}), GuardBand(AroundTarget{0}),
                                  GuardBand(AroundTarget{64}), GuardBand(WindowBox{0, 0, 9, 9})}) {
    profile.guard_band = stated;
    profile.name = "mine";
    EXPECT_EQ(ParseProfile(ProfileToJson(profile), "p.json").guard_band, stated);
  }
}

}  // namespace
}  // namespace rasterproof::io
