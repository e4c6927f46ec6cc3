#include "props/infer/stated_keys.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <iterator>
#include <string>

#include "core/profile_keys.h"
#include "core/tie_rule.h"
#include "props/infer/model_space.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

using Text = std::function<std::string(const Profile&)>;

// Every value among the profiles, each once.
std::string Values(const std::vector<Profile>& profiles, const Text& text) {
  std::vector<std::string> values;
  for (const Profile& profile : profiles) {
    std::string value = text(profile);
    if (std::ranges::find(values, value) == values.end()) values.push_back(std::move(value));
  }
  std::string all;
  for (const std::string& value : values) all += (all.empty() ? "" : " or ") + value;
  return all;
}

std::string BitsText(const Profile& profile) {
  return profile.snap.IsNone() ? "none" : std::to_string(profile.snap.bits);
}

std::string AxisText(const Profile& profile) {
  return profile.y_axis == YAxis::kUp ? "up" : "down";
}

std::string CullsText(const Profile& profile) {
  if (profile.culls == Cull::kNone) return "nothing";
  return profile.culls == Cull::kFront ? "front faces" : "back faces";
}

// How many steps a snap moves a coordinate at most; the float32 difference adds a trifle.
double MostSteps(const Snap& snap) {
  const bool nearest = snap.rule != SnapRule::kFloor && snap.rule != SnapRule::kTruncate;
  const double beside = snap.form == SnapForm::kFloat32Difference ? 0x1p-8 : 0;
  return (nearest ? 0.5 : 1.0) + beside;
}

// Whether the freedom of the stated profile has the number of bits among its legal ones.
bool AllowsBits(const Profile& stated, const Snap& snap) {
  if (stated.snap.bits == snap.bits) return true;
  return stated.freedom.least_bits && !snap.IsNone() && snap.bits >= *stated.freedom.least_bits;
}

// Whether it has the snap among them.
bool AllowsSnap(const Profile& stated, const Snap& snap) {
  const Freedom& freedom = stated.freedom;
  const double most_steps = freedom.any_rounding ? 1 : freedom.snap_tolerance;
  if (most_steps == 0 || !AllowsBits(stated, snap)) return false;
  return snap.IsNone() || MostSteps(snap) <= most_steps;
}

}  // namespace

std::string SnapText(const Snap& snap) {
  if (snap.IsNone()) return "none";
  std::string text = std::string(SnapRuleName(snap.rule));
  if (snap.form == SnapForm::kCoordinate) return text + " of x";
  const std::string difference = "x - " + HexText(snap.origin);
  return text + (snap.form == SnapForm::kFloat32Difference ? " of float32(" + difference + ")"
                                                           : " of " + difference);
}

std::string PatternText(const SamplePattern& pattern) {
  std::string text;
  for (const Point2& l : pattern.locations) {
    text += (text.empty() ? "[" : " [") + std::to_string(static_cast<int>(l.x * 256)) + "/256, " +
            std::to_string(static_cast<int>(l.y * 256)) + "/256]";
  }
  return text;
}

std::string ModelText(const Profile& profile) {
  const std::string grid = profile.snap.IsNone() ? "no grid"
                                                 : std::to_string(profile.snap.bits) +
                                                       " subpixel bits, " + SnapText(profile.snap);
  return grid + "; " + TieRuleName(profile.tie_rule) + "; samples " + PatternText(profile.pattern) +
         "; y " + AxisText(profile) +
         (profile.culls == Cull::kNone ? "" : "; always culls " + CullsText(profile));
}

std::string InferredText(const Inference& inference) {
  if (inference.Fits()) {
    return ModelText(inference.remaining.front()) +
           (inference.remaining.size() == 1 ? "" : ", or others that draw the same");
  }
  if (!inference.nearest) return "no model was found";
  const NearestModel& nearest = *inference.nearest;
  std::string share = "no sample of random draws, only in an aimed one";
  if (nearest.wrong_samples != 0) {
    std::array<char, 32> percent{};
    std::snprintf(
        percent.data(), percent.size(), "%.2g",
        100.0 * static_cast<double>(nearest.wrong_samples) / static_cast<double>(nearest.samples));
    share = std::string(percent.data()) + " % of samples";
  }
  return ModelText(nearest.profile) + "; differs in " + share + ": no model fits";
}

std::vector<StatementVerdict> VerifyStatements(const Profile& given, FacingReport facing,
                                               const std::vector<Profile>& remaining) {
  Profile stated = given;
  if (MovesNothing(given.snap, given)) stated.snap = {};
  const bool judged = stated.contract == Contract::kSampleExact;
  const Freedom& freedom = stated.freedom;
  std::vector<StatementVerdict> verdicts;
  // The stated values must belong to one model: what agrees narrows down what is asked next.
  std::vector<Profile> open = remaining;
  const auto verify = [&](const char* what, const Text& text,
                          const std::function<bool(const Profile&)>& legal) {
    std::vector<Profile> agreeing;
    std::ranges::copy_if(open, std::back_inserter(agreeing), [&](const Profile& model) {
      return text(model) == text(stated) || legal(model);
    });
    verdicts.push_back({what, text(stated), Values(open, text), !judged || !agreeing.empty()});
    if (!agreeing.empty()) open = std::move(agreeing);
  };
  const auto never = [](const Profile&) { return false; };
  verify("y axis", AxisText, never);
  const auto culls = [](const Profile& p) { return p.culls != Cull::kNone; };
  if (culls(stated) || std::ranges::any_of(open, culls)) verify("always culls", CullsText, never);
  verify(
      "sample locations", [](const Profile& p) { return PatternText(p.pattern); },
      [&](const Profile&) { return stated.sample_positions != SamplePositions::kStated; });
  verify("subpixel bits", BitsText,
         [&](const Profile& model) { return AllowsBits(stated, model.snap); });
  verify(
      "snap", [](const Profile& p) { return SnapText(p.snap); },
      [&](const Profile& model) { return AllowsSnap(stated, model.snap); });
  verify(
      "tie rule", [](const Profile& p) { return TieRuleName(p.tie_rule); },
      [&](const Profile& model) {
        return freedom.ties != TieOwnership::kStated && model.tie_rule.IsConsistent();
      });
  if (facing != FacingReport::kNotTold) {
    const bool as_on_screen = facing == FacingReport::kAsOnScreen;
    verdicts.push_back({"front facing", "counter-clockwise on screen",
                        as_on_screen ? "counter-clockwise on screen" : "clockwise on screen",
                        !judged || as_on_screen});
  }
  return verdicts;
}

}  // namespace rasterproof::props
