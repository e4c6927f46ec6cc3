#include "props/run/not_asked.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/scene.h"
#include "props/property.h"
#include "props/run/description.h"

namespace rasterproof::props {
namespace {

struct Output {
  Shows shows;
  std::string_view words;
  bool is_drawn = true;  ///< else asked by its points, which belong to no scene
};

constexpr std::array<Output, 11> kOutputs{{{Shows::kCoverage, "coverage"},
                                           {Shows::kFacings, "facings"},
                                           {Shows::kPrimitiveIds, "primitive ids"},
                                           {Shows::kFragments, "barycentrics"},
                                           {Shows::kDepths, "depths"},
                                           {Shows::kCentroids, "centroids"},
                                           {Shows::kValues, "values"},
                                           {Shows::kDerivatives, "derivatives"},
                                           {Shows::kEdgeValues, "edge values", false},
                                           {Shows::kSteps, "steps of edge values", false},
                                           {Shows::kBarycentrics, "barycentrics by form", false}}};

bool IsOutput(Shows shows) { return std::ranges::count(kOutputs, shows, &Output::shows) != 0; }

// Properties that ask for an option, or for nothing more, judge coverage.
bool Judges(const Gate& gate, Shows output) {
  if (output == Shows::kCoverage) {
    return !IsOutput(gate.shows) || gate.shows == Shows::kCoverage ||
           gate.shows == Shows::kFacings || gate.shows == Shows::kPrimitiveIds;
  }
  if (output == Shows::kFacings && (gate.needs_facings || gate.shows == Shows::kCulling)) {
    return true;
  }
  return gate.shows == output;
}

bool IsOf(const Gate& gate, Space space) {
  return space == Space::kEither || gate.space == Space::kEither || gate.space == space;
}

// Space::kEither: of an output that is asked for outside of scenes.
bool WasAsked(const PropertyResult& result, Space space) {
  if (space == Space::kEither) return result.cases_exercised != 0;
  return (space == Space::kClip ? result.draws.clip : result.draws.window) != 0;
}

// Why no property was asked about the output in this space; nothing if one was.
std::optional<std::string> WhyNotAsked(Shows output, Space space,
                                       std::span<const PropertyResult> results) {
  bool is_judged = false;
  for (const Property& property : Catalog()) {
    is_judged = is_judged || (Judges(property.gate, output) && IsOf(property.gate, space));
  }
  bool applies = false;
  for (const PropertyResult& result : results) {
    const Property* property = FindProperty(result.property);
    if (property == nullptr || !Judges(property->gate, output)) continue;
    if (WasAsked(result, space)) return std::nullopt;
    applies = applies || (IsOf(property->gate, space) && result.outcome != Outcome::kNotApplicable);
  }
  if (!is_judged) return "no property judges them";
  return applies ? "no case exercised them" : "no property about them applies";
}

std::string_view WordsOf(Space space) {
  if (space == Space::kWindow) return " in window space";
  return space == Space::kClip ? " in clip space" : "";
}

std::uint64_t LargestTaken(const Profile& profile) {
  const auto& most = profile.max_target;
  const auto samples = std::uint64_t{1} * static_cast<std::uint64_t>(most.width) *
                       static_cast<std::uint64_t>(most.height) *
                       static_cast<std::uint64_t>(profile.pattern.samples());
  return std::min(samples, static_cast<std::uint64_t>(kMaxTargetSamples));
}

}  // namespace

std::vector<Shows> OutputsOf(const Subject& given) {
  const Description subject =
      AsJudged({given.Info(), given.Edges(), given.Barycentrics(), /*has_twin=*/false});
  std::vector<Shows> outputs;
  for (const Output& output : kOutputs) {
    if (IsShownBy(output.shows, subject)) outputs.push_back(output.shows);
  }
  return outputs;
}

std::vector<NotAskedOf> NotAsked(const SubjectInfo& info, std::span<const Shows> outputs,
                                 std::span<const PropertyResult> results) {
  std::vector<NotAskedOf> list;
  for (const Space space : {Space::kWindow, Space::kClip, Space::kEither}) {
    if (space == Space::kWindow && !info.takes_window) continue;
    if (space == Space::kClip && !info.takes_clip) continue;
    std::vector<NotAskedOf> here;  // outputs of one reason in one entry
    for (const auto& [shows, words, is_drawn] : kOutputs) {
      if (is_drawn == (space == Space::kEither)) continue;
      if (std::ranges::count(outputs, shows) == 0) continue;
      const std::optional<std::string> why = WhyNotAsked(shows, space, results);
      if (!why) continue;
      const auto same = std::ranges::find(here, *why, &NotAskedOf::why);
      if (same == here.end()) {
        here.push_back({std::string(words), *why});
      } else {
        same->what += ", " + std::string(words);
      }
    }
    for (NotAskedOf& entry : here) {
      entry.what += WordsOf(space);
      list.push_back(std::move(entry));
    }
  }
  std::uint64_t largest = 0;
  for (const PropertyResult& result : results) {
    largest = std::max(largest, result.draws.largest_target);
  }
  if (largest != 0 && largest < LargestTaken(info.profile)) {
    list.push_back({"targets above " + std::to_string(largest) + " samples", ""});
  }
  return list;
}

}  // namespace rasterproof::props
