// The keys of a profile that most profiles leave out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "core/error.h"
#include "io/case_file.h"
#include "model/target_model.h"

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
  profile.guard_band = WindowBox{-1024, -0.1, 1023, 0x1p30};
  profile.degenerate_triangles = DegenerateTriangles::kUnspecified;
  profile.infinite_vertex = InfiniteVertex::kUnspecified;
  profile.shares_edge_samples = true;
  profile.tie_rule = {.exclusive = true};
  ExpectReadsBack(profile);
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
  EXPECT_THAT(refusal(R"("d3d11", "contract": "none")"), HasSubstr("\"contract\""));
  EXPECT_THAT(refusal(R"("gl-canonical")"), HasSubstr("legal set"));
  EXPECT_THAT(refusal(R"("mine")"), HasSubstr("legal set"));
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
  EXPECT_EQ(ForTarget(profile, 2049, 1).snap.bits, 4);
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
    EXPECT_STREQ(error.what(),
                 "p.json: name: \"vulkan-canonical\" is the name of a preset, and this is not what "
                 "the preset "
                 "says; give it another name, or write \"vulkan-canonical\" alone for the preset");
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
               "max_primitive_extent: is not the size of a triangle"},
           Bad{R"("max_primitive_extent": ["nan", 1])", "max_primitive_extent[0]: is not finite"},
           Bad{R"("guard_band": [0, 0, 1])", "guard_band: has 3 numbers"},
           Bad{R"("guard_band": [0, 0, 0, 1])", "guard_band: is empty; write x0 < x1 and y0 < y1"},
           Bad{R"("guard_band": [0, 0, "inf", 1])", "guard_band[2]: is not finite"},
           Bad{R"("scanline_rounding": {"rule": "floor"})", "bits"},
           Bad{R"("scanline_rounding": {"bits": 17})", "scanline_rounding.bits"},
           Bad{R"("transform": {"division": "rcp"})",
               "transform.division: \"rcp\" is no division; write quotient or reciprocal"},
           Bad{R"("transform": {"viewport": "half"})", "write none, multiply-add, fused"},
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

}  // namespace
}  // namespace rasterproof::io
