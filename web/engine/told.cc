#include "web/engine/told.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/coverage.h"
#include "core/profile.h"
#include "core/tie_rule.h"
#include "exact/coverage.h"
#include "exact/rational.h"
#include "props/infer/stated_keys.h"
#include "props/placed_case.h"
#include "props/run/facings.h"
#include "props/run/failure_view.h"

namespace rasterproof::web {
namespace {

using io::JsonWriter;

constexpr int kSide = 32;  // pixels of a picture

void WriteCounts(JsonWriter& json, std::string_view key, const CoverageCounts& counts,
                 const PixelRect& view) {
  json.Key(key).BeginArrayLine();
  for (int j = view.y0; j < view.y1; ++j) {
    for (int i = view.x0; i < view.x1; ++i) {
      for (int s = 0; s < counts.samples; ++s) json.Integer(counts.Count(counts.Index(i, j, s)));
    }
  }
  json.EndArray();
}

void WriteEdges(JsonWriter& json, const props::FailureView& view) {
  json.Key("edges").BeginArray();
  for (const int triangle : view.triangles) {
    if (!view.sample) break;
    const std::array<Vertex, 3> v =
        Corners(view.scene, view.scene.triangles[static_cast<std::size_t>(triangle)]);
    json.BeginObjectLine().Key("triangle").Integer(triangle).Key("values").BeginArrayLine();
    if (std::ranges::all_of(v, [](const Vertex& corner) { return IsFinite(corner); })) {
      for (std::size_t k = 0; k < v.size(); ++k)
        json.Text(
            props::EdgeAt(view.scene, v[(k + 1) % 3], v[(k + 2) % 3], *view.sample).ToString());
    }
    json.EndArray().EndObject();
  }
  json.EndArray();
}

// Each text once.
std::vector<std::string> Distinct(const std::vector<Profile>& models,
                                  std::string (*text)(const Profile&)) {
  std::vector<std::string> texts;
  for (const Profile& model : models) {
    std::string one = text(model);
    if (std::ranges::find(texts, one) == texts.end()) texts.push_back(std::move(one));
  }
  return texts;
}

std::string Joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : " or ") + text;
  return all;
}

}  // namespace

bool PulledSight::GoOn(props::KnownAnswers& answers) {
  if (is_done_) return true;
  if (!check_.has_result()) return false;
  const std::optional<Counterexample>& found = check_.result().counterexample;
  if (found && props::HasPlace(found->verdict)) {
    const props::PlacedCase c(props::AsDrawn(found->value, found->verdict));
    auto seen = std::make_shared<Drawing>();
    seen->counts = props::BlankTarget(c);
    if (!props::HoldsDrawing(found->verdict, seen->counts)) {
      const std::uint64_t before = answers.missed();
      const CallEnd end = props::DrawByFacing(answers, c.scene, c.options, seen->counts);
      if (answers.missed() != before) return false;
      if (end.stop == Stop::kNone) seen_ = std::move(seen);
    }
  }
  is_done_ = true;
  return true;
}

void WritePicture(JsonWriter& json, const SubjectInfo& info, const Counterexample& failure) {
  const Verdict& verdict = failure.verdict;
  if (!props::HasPlace(verdict)) return;
  const props::PlacedCase c(props::AsDrawn(failure.value, verdict));
  if (!props::HoldsDrawing(verdict, props::BlankTarget(c)) || exact::WhyNotDecided(c)) return;
  const props::FailureView view = props::ViewOf(info, c, verdict, kSide);
  const PixelRect& shown = view.view;
  json.Key("picture").BeginObject().Key("x").Integer(shown.x0).Key("y").Integer(shown.y0);
  json.Key("width").Integer(shown.x1 - shown.x0).Key("height").Integer(shown.y1 - shown.y0);
  json.Key("samples").Integer(view.expected.samples);
  WriteCounts(json, "expected", view.expected, shown);
  WriteCounts(json, "actual", view.observed, shown);
  WriteEdges(json, view);
  json.EndObject();
}

void WriteModel(JsonWriter& json, const props::Inference& inference) {
  const std::vector<Profile>& models = inference.remaining;
  json.Key("model_text").Text(props::InferredText(inference)).Key("model");
  if (models.empty()) {
    json.Null();
    return;
  }
  json.BeginObject().Key("subpixelBits").BeginArrayLine();
  const auto bits = [](const Profile& p) {
    return p.snap.IsNone() ? std::string("\"none\"") : std::to_string(p.snap.bits);
  };
  for (const std::string& one : Distinct(models, bits)) json.Value(one);
  json.EndArray().Key("snap").BeginArrayLine();
  const auto snap = [](const Profile& p) { return props::SnapText(p.snap); };
  for (const std::string& one : Distinct(models, snap)) json.Text(one);
  json.EndArray();
  const auto ties = [](const Profile& p) { return std::string(TieRuleName(p.tie_rule)); };
  json.Key("ties").Text(Joined(Distinct(models, ties)));
  const auto samples = [](const Profile& p) { return props::PatternText(p.pattern); };
  json.Key("samples").Text(Joined(Distinct(models, samples)));
  json.EndObject();
}

}  // namespace rasterproof::web
