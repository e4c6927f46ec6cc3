#include "io/value_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "core/quoted.h"
#include "io/json_members.h"
#include "io/scene_json.h"

namespace rasterproof::io {
namespace {

constexpr auto kErrorKeys = std::to_array<std::string_view>({"ulps", "absolute", "conditions"});
constexpr auto kChannelKeys =
    std::to_array<std::string_view>({"name", "interpolation", "at", "values"});

constexpr std::array<std::pair<WeightsIn, std::string_view>, 3> kWeights{
    {{WeightsIn::kUnstated, "unstated"},
     {WeightsIn::kScreen, "screen"},
     {WeightsIn::kPerspective, "perspective"}}};
constexpr std::array<std::pair<ProvokingVertex, std::string_view>, 3> kProvoking{
    {{ProvokingVertex::kUnstated, "unstated"},
     {ProvokingVertex::kFirst, "first"},
     {ProvokingVertex::kLast, "last"}}};
constexpr std::array<std::pair<DerivativesBy, std::string_view>, 4> kDerivatives{
    {{DerivativesBy::kUnstated, "unstated"},
     {DerivativesBy::kAnalytic, "analytic"},
     {DerivativesBy::kFine, "fine"},
     {DerivativesBy::kCoarse, "coarse"}}};
constexpr std::array<std::pair<QuadOrigin, std::string_view>, 3> kQuads{
    {{QuadOrigin::kUnstated, "unstated"}, {QuadOrigin::kEven, "even"}, {QuadOrigin::kOdd, "odd"}}};
constexpr std::array<std::pair<DepthFormat, std::string_view>, 6> kDepths{
    {{DepthFormat::kUnstated, "unstated"},
     {DepthFormat::kFloat32, "float32"},
     {DepthFormat::kFloat64, "float64"},
     {DepthFormat::kUnorm16, "unorm16"},
     {DepthFormat::kUnorm24, "unorm24"},
     {DepthFormat::kUnorm32, "unorm32"}}};
constexpr std::array<std::pair<DepthRounding, std::string_view>, 2> kDepthRoundings{
    {{DepthRounding::kEither, "either"}, {DepthRounding::kNearest, "nearest"}}};

struct PromiseKey {
  std::string_view name;
  bool ValueRule::* member;
};
constexpr std::array kPromises{PromiseKey{"flat", &ValueRule::flat},
                               PromiseKey{"linear", &ValueRule::linear},
                               PromiseKey{"inverse_w", &ValueRule::inverse_w},
                               PromiseKey{"centres", &ValueRule::centres},
                               PromiseKey{"centroids", &ValueRule::centroids},
                               PromiseKey{"flushes", &ValueRule::flushes},
                               PromiseKey{"equal_stay_equal", &ValueRule::equal_stay_equal},
                               PromiseKey{"exact_at_vertices", &ValueRule::exact_at_vertices},
                               PromiseKey{"hull", &ValueRule::stays_in_hull},
                               PromiseKey{"edges_agree", &ValueRule::agrees_along_edges},
                               PromiseKey{"any_order", &ValueRule::same_in_any_order},
                               PromiseKey{"monotone_rows", &ValueRule::monotone_along_rows}};
constexpr auto kValueKeys = std::to_array<std::string_view>(
    {"weights",           "provoking", "derivatives",    "quads",     "error",
     "derivative_error",  "depth",     "depth_rounding", "flat",      "linear",
     "inverse_w",         "centres",   "centroids",      "flushes",   "equal_stay_equal",
     "exact_at_vertices", "hull",      "edges_agree",    "any_order", "monotone_rows"});

double ErrorPart(const JsonValue& value) {
  const double part = CoordinateFromJson(value, Precision::kFloat64);
  if (part >= 0 && std::isfinite(part)) return part;
  throw value.Error("is not an error", "write a finite number, 0 or more");
}

ValueError ErrorFromJson(const JsonValue& value) {
  value.RequireObject(kErrorKeys);
  ValueError error;
  ReadIfThere(value, "ulps", error.ulps, ErrorPart);
  ReadIfThere(value, "absolute", error.absolute, ErrorPart);
  ReadIfThere(value, "conditions", error.conditions, ErrorPart);
  if (error.IsStated()) return error;
  throw value.Error("states an error of nothing",
                    "write ulps, absolute or conditions above 0, or leave it out");
}

void WriteError(JsonWriter& json, std::string_view key, const ValueError& error) {
  if (!error.IsStated()) return;
  json.Key(key).BeginObject(kOneLine);
  if (error.ulps > 0) json.Key("ulps").Exact(error.ulps);
  if (error.absolute > 0) json.Key("absolute").Exact(error.absolute);
  if (error.conditions > 0) json.Key("conditions").Exact(error.conditions);
  json.EndObject();
}

// A word, which a program on a pipe reads up to the next blank.
std::string ChannelName(const JsonValue& value) {
  std::string name(value.RequireString());
  if (!name.empty() && name == ShownName(name) && name.find_first_of(" \t") == std::string::npos)
    return name;
  throw value.Error("is no word", "write one without blanks, such as \"u\" or \"light.red\"");
}

Channel ChannelFromJson(const JsonValue& value, std::size_t vertices, Precision precision) {
  value.RequireObject(kChannelKeys);
  Channel channel;
  channel.name = ChannelName(value.Get("name"));
  ReadIfThere(value, "interpolation", channel.interpolation, [](const JsonValue& v) {
    return FromName(v, Names<Interpolation>(kInterpolationNames));
  });
  ReadIfThere(value, "at", channel.at, [](const JsonValue& v) {
    return FromName(v, Names<EvaluatedAt>(kEvaluatedAtNames));
  });
  const bool has_numbers = channel.interpolation != Interpolation::kInverseW;
  if (!has_numbers) {
    if (const auto values = value.Find("values")) {
      throw values->Error("is of a channel that is computed from w alone", "leave it out");
    }
    return channel;
  }
  const JsonValue values = value.Get("values");
  const JsonValue::Items items = values.RequireArray();
  if (items.size() != vertices) {
    throw values.Error("has " + std::to_string(items.size()) + " numbers for " +
                           std::to_string(vertices) + " vertices",
                       "write one a vertex");
  }
  channel.values.reserve(items.size());
  for (const JsonValue item : items) channel.values.push_back(CoordinateFromJson(item, precision));
  return channel;
}

}  // namespace

ValueRule ValueRuleFromJson(const JsonValue& value) {
  value.RequireObject(kValueKeys);
  ValueRule rule;
  ReadIfThere(value, "weights", rule.weights,
              [](const JsonValue& v) { return FromName(v, Names<WeightsIn>(kWeights)); });
  ReadIfThere(value, "provoking", rule.provoking,
              [](const JsonValue& v) { return FromName(v, Names<ProvokingVertex>(kProvoking)); });
  ReadIfThere(value, "derivatives", rule.derivatives,
              [](const JsonValue& v) { return FromName(v, Names<DerivativesBy>(kDerivatives)); });
  ReadIfThere(value, "quads", rule.quads,
              [](const JsonValue& v) { return FromName(v, Names<QuadOrigin>(kQuads)); });
  ReadIfThere(value, "error", rule.error, ErrorFromJson);
  ReadIfThere(value, "derivative_error", rule.derivative_error, ErrorFromJson);
  ReadIfThere(value, "depth", rule.depth,
              [](const JsonValue& v) { return FromName(v, Names<DepthFormat>(kDepths)); });
  ReadIfThere(value, "depth_rounding", rule.depth_rounding, [](const JsonValue& v) {
    return FromName(v, Names<DepthRounding>(kDepthRoundings));
  });
  for (const auto& [name, member] : kPromises) ReadIfThere(value, name, rule.*member, Boolean);
  return rule;
}

void WriteValueRule(JsonWriter& json, const ValueRule& rule) {
  const ValueRule nothing;
  json.BeginObject(kOneLine);
  if (rule.weights != nothing.weights)
    json.Key("weights").Text(NameOf(rule.weights, Names<WeightsIn>(kWeights)));
  if (rule.provoking != nothing.provoking)
    json.Key("provoking").Text(NameOf(rule.provoking, Names<ProvokingVertex>(kProvoking)));
  if (rule.derivatives != nothing.derivatives)
    json.Key("derivatives").Text(NameOf(rule.derivatives, Names<DerivativesBy>(kDerivatives)));
  if (rule.quads != nothing.quads)
    json.Key("quads").Text(NameOf(rule.quads, Names<QuadOrigin>(kQuads)));
  WriteError(json, "error", rule.error);
  WriteError(json, "derivative_error", rule.derivative_error);
  if (rule.depth != nothing.depth)
    json.Key("depth").Text(NameOf(rule.depth, Names<DepthFormat>(kDepths)));
  if (rule.depth_rounding != nothing.depth_rounding)
    json.Key("depth_rounding")
        .Text(NameOf(rule.depth_rounding, Names<DepthRounding>(kDepthRoundings)));
  for (const auto& [name, member] : kPromises)
    if (rule.*member) json.Key(name).Bool(true);
  json.EndObject();
}

std::vector<Channel> ChannelsFromJson(const JsonValue& list, std::size_t vertices,
                                      Precision precision) {
  std::vector<Channel> channels;
  for (const JsonValue item : list.RequireArray()) {
    if (channels.size() == kMostChannels) {
      throw list.Error("has more than " + std::to_string(kMostChannels) + " channels",
                       "leave out those that nothing asks for");
    }
    Channel channel = ChannelFromJson(item, vertices, precision);
    if (std::ranges::count(channels, channel.name, &Channel::name) != 0) {
      throw item.Get("name").Error("is the name of a channel before it", "give it another name");
    }
    channels.push_back(std::move(channel));
  }
  return channels;
}

void WriteChannels(JsonWriter& json, const std::vector<Channel>& channels) {
  json.BeginArray(kLines);
  for (const Channel& channel : channels) {
    json.BeginObject(kOneLine).Key("name").Text(channel.name);
    json.Key("interpolation")
        .Text(NameOf(channel.interpolation, Names<Interpolation>(kInterpolationNames)));
    if (channel.at != EvaluatedAt::kSample)
      json.Key("at").Text(NameOf(channel.at, Names<EvaluatedAt>(kEvaluatedAtNames)));
    if (channel.interpolation != Interpolation::kInverseW) {
      json.Key("values").BeginArray(kOneLine);
      for (const double x : channel.values) json.Exact(x);
      json.EndArray();
    }
    json.EndObject();
  }
  json.EndArray();
}

}  // namespace rasterproof::io
