#include "props/domains/width_inputs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/case.h"
#include "core/error.h"
#include "exact/edge_widths.h"

namespace rasterproof::props {
namespace {

constexpr std::uint64_t kValues = 49;
constexpr int kMostPixels = 1024;
constexpr std::array<std::string_view, 2> kOfWidths{"CoverageEqualsTheModel",
                                                    "OneLegalModelExplainsTheMesh"};

exact::EdgeUnit UnitOf(const SubjectInfo& info) {
  exact::EdgeUnit unit;
  unit.input = *info.profile.fixed;
  const double side = std::clamp(std::floor(unit.input.Largest()), 1.0, double{kMostPixels});
  unit.width = static_cast<int>(side);
  unit.height = unit.width;
  unit.pattern = info.profile.pattern;
  return unit;
}

Case InputThatNeedsTheLastBit(std::uint64_t index, const SubjectInfo& info) {
  const exact::EdgeUnit unit = UnitOf(info);
  Case c;
  c.scene = WitnessScene(unit, exact::EdgeWidths(unit)[static_cast<std::size_t>(index)]);
  c.scene.precision = info.input;
  c.profile = info.profile;
  return c;
}

std::string WhyNoWidths(const SubjectInfo& info) {
  if (!info.profile.fixed) return "its input is not fixed point";
  if (!info.takes_window) return "it takes no window-space scenes";
  const auto why = exact::WhyNoEdgeWidths(UnitOf(info));
  return why ? why->what() : "";
}

}  // namespace

const World& WidthInputs() {
  static constexpr World kWorld{
      "edge-widths",
      "the inputs at which each value of an edge function needs its last bit",
      kValues,
      0,
      std::int64_t{kMostPixels} * kMostPixels,
      kOfWidths,
      InputThatNeedsTheLastBit,
      WhyNoWidths};
  return kWorld;
}

bool IsPutToWidthInputs(std::string_view property, const SubjectInfo& info) {
  return std::ranges::find(kOfWidths, property) != kOfWidths.end() &&
         WhyNotGiven(WidthInputs(), info).empty();
}

std::string WidthInputsText(const SubjectInfo& info) {
  const exact::EdgeUnit unit = UnitOf(info);
  const std::vector<exact::EdgeWidth> widths = exact::EdgeWidths(unit);
  const auto e = std::ranges::find(widths, "direct-e-box", &exact::EdgeWidth::id);
  const std::string side = std::to_string(unit.width);
  return "E takes " + std::to_string(e->bits) + " bits on a target of " + side + " x " + side +
         "; the " + std::to_string(kValues) +
         " inputs that need the last bit of each value were drawn";
}

}  // namespace rasterproof::props
