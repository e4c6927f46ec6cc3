#include "io/value_json.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/profile.h"
#include "core/scene.h"
#include "gtest/gtest.h"
#include "io/case_file.h"
#include "io/profile_json.h"
#include "io/scene_file.h"

namespace rasterproof::io {
namespace {

std::string ProfileOf(const std::string& values) {
  return R"({"name": "mine", "values": )" + values + "}";
}

// A scene file of three vertices.
std::string SceneOf(const std::string& channels, const std::string& precision = "float32") {
  return R"({"rasterproof_scene": 1, "name": "s", "width": 4, "height": 4, "precision": ")" +
         precision + R"(", "vertices": [[0, 0], [4, 0], [0, 4]], "triangles": [[0, 1, 2]], )" +
         R"("channels": )" + channels + "}";
}

void ExpectRefused(const auto& read, const std::string& text, std::string_view said) {
  try {
    read(text);
    ADD_FAILURE() << "taken: " << text;
  } catch (const InputError& error) {
    EXPECT_NE(std::string_view(error.what()).find(said), std::string_view::npos)
        << "of " << text << "\n"
        << error.what();
  }
}

void ExpectReadsBack(const ValueRule& rule) {
  Profile profile;
  profile.values = rule;
  const std::string text = ProfileToJson(profile);
  EXPECT_EQ(ParseProfile(text, "written").values, rule) << text;
}

TEST(ValueJson, EveryMemberOfARuleReadsBack) {
  ExpectReadsBack({});
  for (const WeightsIn weights : {WeightsIn::kScreen, WeightsIn::kPerspective})
    ExpectReadsBack({.weights = weights});
  for (const ProvokingVertex vertex : {ProvokingVertex::kFirst, ProvokingVertex::kLast})
    ExpectReadsBack({.provoking = vertex});
  for (const DerivativesBy by :
       {DerivativesBy::kAnalytic, DerivativesBy::kFine, DerivativesBy::kCoarse})
    ExpectReadsBack({.derivatives = by});
  for (const QuadOrigin quads : {QuadOrigin::kEven, QuadOrigin::kOdd})
    ExpectReadsBack({.quads = quads});
  for (const DepthFormat depth :
       {DepthFormat::kFloat32, DepthFormat::kFloat64, DepthFormat::kUnorm16, DepthFormat::kUnorm24,
        DepthFormat::kUnorm32}) {
    ExpectReadsBack({.depth = depth, .depth_rounding = DepthRounding::kNearest});
  }
  for (bool ValueRule::* const promise :
       {&ValueRule::flat, &ValueRule::linear, &ValueRule::inverse_w, &ValueRule::centres,
        &ValueRule::centroids, &ValueRule::flushes, &ValueRule::equal_stay_equal,
        &ValueRule::exact_at_vertices, &ValueRule::stays_in_hull, &ValueRule::agrees_along_edges,
        &ValueRule::same_in_any_order, &ValueRule::monotone_along_rows}) {
    ValueRule rule;
    rule.*promise = true;
    ExpectReadsBack(rule);
  }
  for (double ValueError::* const part :
       {&ValueError::ulps, &ValueError::absolute, &ValueError::conditions}) {
    ValueError error;
    error.*part = 0.1;
    ExpectReadsBack({.error = error});
    ExpectReadsBack({.derivative_error = error});
  }
  ExpectReadsBack({.error = {1.5, 1e-300, 1e300}, .derivative_error = {0, 2, 0}});
}

TEST(ValueJson, BadRulesAreRefusedWithTheRemedy) {
  const auto read = [](const std::string& text) { ParseProfile(text, "profile"); };
  const std::pair<const char*, const char*> bad[] = {
      {R"({"weights": "affine"})", "known here are unstated, screen, perspective"},
      {R"({"provoking": "second"})", "known here are unstated, first, last"},
      {R"({"derivatives": "forward"})", "known here are unstated, analytic, fine, coarse"},
      {R"({"depth": "unorm8"})", "unorm16, unorm24, unorm32"},
      {R"({"depth_rounding": "up"})", "known here are either, nearest"},
      {R"({"hull": 1})", "write true or false"},
      {R"({"error": {}})", "states an error of nothing"},
      {R"({"error": {"ulps": 0}})", "write ulps, absolute or conditions above 0"},
      {R"({"error": {"ulps": -1}})", "write a finite number, 0 or more"},
      {R"({"derivative_error": {"absolute": "inf"}})", "write a finite number, 0 or more"},
      {R"({"error": {"conditions": "nan"}})", "write a finite number, 0 or more"},
      {R"({"error": {"texels": 1}})", "texels"},
      {R"({"errors": {"ulps": 1}})", "errors"},
  };
  for (const auto& [values, said] : bad) ExpectRefused(read, ProfileOf(values), said);
}

TEST(ValueJson, EveryMemberOfAChannelReadsBack) {
  Scene scene = ParseScene(SceneOf("[]"), "s");
  EXPECT_TRUE(scene.channels.empty());
  EXPECT_EQ(SceneToJson(scene).find("channels"), std::string::npos);
  scene.precision = Precision::kFloat64;
  int number = 0;
  for (const auto& [interpolation, name] : kInterpolationNames) {
    for (const auto& [at, place] : kEvaluatedAtNames) {
      Channel& channel = scene.channels.emplace_back();
      channel = {"c" + std::to_string(++number), interpolation, at, {}};
      if (interpolation != Interpolation::kInverseW) channel.values = {0.1, -0x1p-1074, 1e300};
    }
  }
  const std::string text = SceneToJson(scene);
  EXPECT_EQ(ParseScene(text, "written"), scene) << text;
  scene.channels = {{.name = "odd", .values = {std::nan(""), -0.0, -INFINITY}}};
  const std::vector<double> read = ParseScene(SceneToJson(scene), "s").channels[0].values;
  EXPECT_TRUE(std::isnan(read[0]) && std::signbit(read[1]) && read[2] == -INFINITY);
  EXPECT_EQ(ParseScene(SceneOf(R"([{"name": "u", "values": [1, 2, 3]}])"), "s").channels[0],
            (Channel{.name = "u", .values = {1, 2, 3}}))
      << "perspective, at samples";
}

std::string ManyChannels(std::size_t count) {
  std::string text;
  for (std::size_t n = 0; n < count; ++n)
    text += (n == 0 ? R"([{"name": "c)" : R"(, {"name": "c)") + std::to_string(n) +
            R"(", "values": [0, 1, 2]})";
  return text + "]";
}

TEST(ValueJson, BadChannelsAreRefusedWithTheRemedy) {
  const auto read = [](const std::string& text) { ParseScene(text, "scene"); };
  const std::pair<const char*, const char*> bad[] = {
      {R"({"name": "u"})", "array"},
      {R"([{"values": [1, 2, 3]}])", "name"},
      {R"([{"name": "", "values": [1, 2, 3]}])", "write one without blanks"},
      {R"([{"name": "a b", "values": [1, 2, 3]}])", "write one without blanks"},
      {R"([{"name": "a\tb", "values": [1, 2, 3]}])", "write one without blanks"},
      {R"([{"name": "u"}])", "values"},
      {R"([{"name": "u", "values": [1, 2]}])", "has 2 numbers for 3 vertices; write one a vertex"},
      {R"([{"name": "u", "values": [1, 2, 3, 4]}])", "has 4 numbers for 3 vertices"},
      {R"([{"name": "u", "values": [1, 2, "x"]}])", "x"},
      {R"([{"name": "u", "values": [1, 2, "0x1.0000001p+0"]}])", "float32"},
      {R"([{"name": "u", "interpolation": "smooth", "values": [1, 2, 3]}])",
       "flat, linear, perspective, inverse-w"},
      {R"([{"name": "u", "at": "corner", "values": [1, 2, 3]}])", "sample, centre, centroid"},
      {R"([{"name": "q", "interpolation": "inverse-w", "values": [1, 1, 1]}])",
       "computed from w alone; leave it out"},
      {R"([{"name": "u", "values": [1, 2, 3]}, {"name": "u", "values": [1, 2, 3]}])",
       "is the name of a channel before it; give it another name"},
      {R"([{"name": "u", "values": [1, 2, 3], "unit": "m"}])", "unit"},
  };
  for (const auto& [channels, said] : bad) ExpectRefused(read, SceneOf(channels), said);
  EXPECT_EQ(ParseScene(SceneOf(ManyChannels(64)), "s").channels.size(), 64U);
  ExpectRefused(read, SceneOf(ManyChannels(65)), "has more than 64 channels");
}

}  // namespace
}  // namespace rasterproof::io
