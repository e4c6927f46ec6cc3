#include "tool/failure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/call_end.h"
#include "core/drawing.h"
#include "core/error.h"
#include "core/profile.h"
#include "exact/rational.h"
#include "fmt/format.h"
#include "io/scene_file.h"
#include "props/placed_case.h"
#include "props/run/failure_view.h"
#include "report/explanation_numbers.h"
#include "tool/session.h"

namespace rasterproof::tool {

using props::EdgeAt;
using props::HasPlace;

namespace {

constexpr int kViewSide = 16;              // pixels shown around the failing place
constexpr std::size_t kMostPrinted = 512;  // vertices or triangles of a scene in one line

// A number whose decimals are few and exact; "" of any other.
std::string ShortDecimal(double value) {
  constexpr int kMostDecimals = 10;
  constexpr double kMost = 1e9;
  if (!(std::abs(value) < kMost)) return "";
  for (int decimals = 0; decimals <= kMostDecimals; ++decimals) {
    const double scaled = std::ldexp(value, decimals);
    if (std::trunc(scaled) == scaled) return fmt::format("{:.{}f}", value, decimals);
  }
  return "";
}

// "(0x1.cp+1, -0x1p+4) = (3.5, -16) = (896, -4096)/256": hexadecimal, decimal where that is short
// and exact, and steps of the grid if the profile has one and the vertex lies on it.
std::string VertexText(const Vertex& v, const Case& c) {
  if (c.scene.clip_space) return fmt::format("({:a}, {:a}, {:a}, {:a})", v.x, v.y, v.z, v.w);
  std::string text = fmt::format("({:a}, {:a})", v.x, v.y);
  const std::string x = ShortDecimal(v.x);
  const std::string y = ShortDecimal(v.y);
  if (x.empty() || y.empty()) return text;
  text += fmt::format(" = ({}, {})", x, y);
  const Snap& snap = c.profile.snap;
  if (snap.IsNone() || snap.bits == 0 || snap.form != SnapForm::kCoordinate) return text;
  const double steps_x = std::ldexp(v.x, snap.bits);
  const double steps_y = std::ldexp(v.y, snap.bits);
  if (std::trunc(steps_x) != steps_x || std::trunc(steps_y) != steps_y) return text;
  return text + fmt::format(" = ({:.0f}, {:.0f})/{}", steps_x, steps_y, 1 << snap.bits);
}

// Edge i is opposite vertex i: "v1-v2" is edge 0.
std::string EdgeName(int edge) { return fmt::format("v{}-v{}", (edge + 1) % 3, (edge + 2) % 3); }

// How a case is drawn, as far as that is not the plain way: "; drawn with cull back, tile 8".
std::string OptionsText(const DrawOptions& options) {
  std::string text;
  const auto add = [&](const std::string& option) {
    text += (text.empty() ? "; drawn with " : ", ") + option;
  };
  if (options.cull != Cull::kNone) {
    add(options.cull == Cull::kFront ? "cull front" : "cull back");
  }
  if (options.scissor) {
    const PixelRect& r = *options.scissor;
    add(fmt::format("scissor [{}, {}, {}, {}]", r.x0, r.y0, r.x1, r.y1));
  }
  if (options.tile != 0) add(fmt::format("tile {}", options.tile));
  if (options.threads > 1) add(fmt::format("threads {}", options.threads));
  return text;
}

// Where snapping moves a triangle's corners to; empty where it moves none.
std::string SnappedLine(const Scene& given, const Scene& snapped, int triangle) {
  const Triangle& corners = given.triangles[static_cast<std::size_t>(triangle)];
  const std::array<Vertex, 3> from = Corners(given, corners);
  const std::array<Vertex, 3> to = Corners(snapped, corners);
  if (given.clip_space || from == to || !std::ranges::all_of(from, IsFinite)) return "";
  std::string line = fmt::format("triangle {} snaps to", triangle);
  for (const Vertex& v : to) line += fmt::format(" ({}, {})", v.x, v.y);
  return line;
}

std::string EdgeLine(const Scene& scene, int triangle, int edge, Point2 p) {
  const std::array<Vertex, 3> v =
      Corners(scene, scene.triangles[static_cast<std::size_t>(triangle)]);
  const Vertex& a = v[static_cast<std::size_t>((edge + 1) % 3)];
  const Vertex& b = v[static_cast<std::size_t>((edge + 2) % 3)];
  if (!IsFinite(a) || !IsFinite(b)) {
    return fmt::format("triangle {}, edge {}: not finite, covers nothing", triangle,
                       EdgeName(edge));
  }
  const exact::Rational value = EdgeAt(scene, a, b, p);
  std::string text = value.ToString();
  constexpr std::size_t kLongest = 60;  // beyond that the digits say nothing to a reader
  if (text.size() > kLongest) text = fmt::format("{:a} (rounded)", value.ToDouble());
  if (text.find('/') != std::string::npos) {
    const double rounded = value.ToDouble();
    const std::string decimal = ShortDecimal(rounded);
    if (!decimal.empty() && exact::Rational(rounded) == value) text += " = " + decimal;
  }
  return fmt::format("triangle {}, edge {}: E = {}", triangle, EdgeName(edge), text);
}

}  // namespace

bool HoldsWhatWasSeen(const Verdict& verdict, const Case& c) {
  return props::HoldsDrawing(verdict, props::BlankTarget(props::PlacedCase(AsDrawn(c, verdict))));
}

void See(Subject& subject, const Case& given, Verdict& verdict) {
  const props::PlacedCase c(AsDrawn(given, verdict));
  const CoverageCounts none = props::BlankTarget(c);
  if (props::HoldsDrawing(verdict, none)) return;
  std::string failure;  // the verdict reports it; the picture then shows that nothing was drawn
  auto seen = std::make_shared<Drawing>();
  seen->counts = DrawUnlessItFails(subject, c.scene, c.options, failure).value_or(none);
  verdict.seen = std::move(seen);
}

void SeeIfItCan(Subject& subject, const Case& c, Verdict& verdict) {
  if (!HasPlace(verdict)) return;
  try {
    See(subject, c, verdict);
  } catch (const InputError&) {
    return;  // it takes no such scene any more
  } catch (const SubjectStop&) {
    return;  // or takes too long over it now
  }
}

report::Explanation Explain(const SubjectInfo& subject, const Case& given, const Verdict& verdict,
                            const std::string& replay) {
  const props::PlacedCase c(AsDrawn(given, verdict));
  report::Explanation explanation;
  const props::FailureView view = props::ViewOf(subject, c, verdict, kViewSide);
  explanation.scene = view.scene;
  explanation.pattern = c.profile.pattern;
  explanation.y_axis = c.profile.y_axis;
  explanation.expected = view.expected;
  explanation.observed = view.observed;
  explanation.focus_x = view.focus_x;
  explanation.focus_y = view.focus_y;
  explanation.view = view.view;
  explanation.triangles = view.triangles;
  if (view.sample) {
    for (const int triangle : explanation.triangles) {
      const std::string snapped = SnappedLine(c.scene, explanation.scene, triangle);
      if (!snapped.empty()) explanation.edge_values.push_back(snapped);
      for (int edge = 0; edge < 3; ++edge) {
        explanation.edge_values.push_back(
            EdgeLine(explanation.scene, triangle, edge, *view.sample));
      }
    }
  }
  if (verdict.numbers && !verdict.numbers->list.empty()) {
    explanation.numbers = verdict.numbers;
    const std::vector<std::string> lines = report::NumberLines(*verdict.numbers);
    explanation.edge_values.insert(explanation.edge_values.begin(), lines.begin(), lines.end());
  }
  explanation.headline = verdict.message;
  explanation.replay = replay;
  return explanation;
}

std::string FailureLine(const SubjectInfo& subject, const std::string& property, const Case& given,
                        const Verdict& verdict) {
  const Case c = AsDrawn(given, verdict);
  std::string line = property.empty() ? "coverage" : property;
  line += ": ";
  if (verdict.witness) {
    const Witness w = *WithCountsAsGiven(verdict, subject).witness;
    if (w.triangle >= 0 && static_cast<std::size_t>(w.triangle) < c.scene.triangles.size()) {
      line += fmt::format("triangle {}", w.triangle);
      const auto corners =
          Corners(c.scene, c.scene.triangles[static_cast<std::size_t>(w.triangle)]);
      for (const Vertex& v : corners) line += " " + VertexText(v, c);
      line += " ";
    }
    if (w.edge >= 0) line += fmt::format("edge {} ", EdgeName(w.edge));
    if (w.x >= 0) line += fmt::format("pixel ({}, {}) ", w.x, w.y);
    if (!w.observed.empty() || !w.expected.empty()) {
      line += fmt::format("=> observed {}, expected {}; ", TextOfValue(w.observed),
                          TextOfValue(w.expected));
    }
  }
  return line + verdict.message;
}

std::string SceneLine(const Case& c) {
  const Scene& scene = c.scene;
  const std::string options = OptionsText(c.options);
  if (scene.triangles.size() > kMostPrinted || scene.vertices.size() > kMostPrinted) {
    return fmt::format("scene: {} triangles of {} vertices in {}x{}, too many to print{}",
                       scene.triangles.size(), scene.vertices.size(), scene.width, scene.height,
                       options);
  }
  return "scene: " + InOneLine(io::SceneToJson(scene)) + options;
}

std::string DrawnLine(const Case& c, const Verdict& verdict) {
  if (verdict.drawn == nullptr) return "";
  return "drawn by the property, " + SceneLine(AsDrawn(c, verdict)) + "\n";
}

namespace {

// A scene that the oracle does not decide has no picture.
std::string PictureText(const SubjectInfo& subject, const Case& c, const Verdict& verdict,
                        const std::string& replay) {
  std::string no_picture = replay.empty() ? "" : "replay: " + replay + "\n";
  if (!HasPlace(verdict)) return no_picture;
  try {
    if (!HoldsWhatWasSeen(verdict, c)) return no_picture;
    return report::ExplanationToText(Explain(subject, c, verdict, replay), /*colour=*/false);
  } catch (const InputError&) {
    return no_picture;
  }
}

}  // namespace

std::string FailureText(const SubjectInfo& subject, const std::string& property, const Case& c,
                        const Verdict& verdict, const std::string& replay) {
  std::string text = FailureLine(subject, property, c, verdict) + "\n" + SceneLine(c) + "\n";
  text += DrawnLine(c, verdict);
  text += PictureText(subject, c, verdict, replay);
  if (!text.ends_with('\n')) text += '\n';
  return text;
}

}  // namespace rasterproof::tool
