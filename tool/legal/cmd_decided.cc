// rasterproof legal --decided: how often legal models of a profile cover each sample.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/sample_text.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/image.h"
#include "io/json_writer.h"
#include "io/netpbm.h"
#include "io/output.h"
#include "legal/decided.h"
#include "legal/joint.h"
#include "report/case_code.h"
#include "report/palette.h"
#include "report/picture.h"
#include "tool/exit_status.h"
#include "tool/legal/cmd_legal.h"
#include "tool/legal/legal_hints.h"
#include "tool/progress.h"
#include "tool/scene_source.h"

namespace rasterproof::tool {
namespace {

constexpr int kLeastForLabels = 8;

// A count that all legal models have, and "?" where they differ.
std::string Letters(const legal::Decided& decided) {
  std::string text;
  const auto row_length =
      static_cast<std::size_t>(decided.width) * static_cast<std::size_t>(decided.samples);
  for (std::size_t s = 0; s < decided.counts.size(); ++s) {
    text += decided.IsDecided(s) ? std::to_string(decided.Least(s)) : "?";
    text += (s + 1) % row_length == 0 ? '\n' : ' ';
  }
  return text;
}

// A list of each triangle's samples as runs, which ends where it would grow beyond reading.
void AddTriangles(const legal::Decided& decided, io::JsonWriter& json) {
  constexpr std::size_t kMostRuns = 1'000'000;
  std::size_t runs = 0;
  const auto add_runs = [&](const char* key, const std::vector<std::size_t>& samples) {
    json.Key(key).BeginArray();
    for (std::size_t k = 0; k < samples.size();) {
      std::size_t end = k + 1;
      while (end < samples.size() && samples[end] == samples[end - 1] + 1) ++end;
      json.BeginArray().Integer(samples[k]).Integer(end - k).EndArray();
      ++runs;
      k = end;
    }
    json.EndArray();
  };
  json.Key("triangles").BeginArray();
  std::size_t told = 0;
  for (; told < decided.triangles.size() && runs < kMostRuns; ++told) {
    const legal::TriangleDecided& triangle = decided.triangles[told];
    json.BeginObject();
    add_runs("must", triangle.must);
    add_runs("may", triangle.may);
    if (triangle.is_anything) json.Key("anything").Bool(true);
    json.EndObject();
  }
  json.EndArray();
  json.Key("triangles_left_out").Integer(decided.triangles.size() - told);
}

std::string ToJson(const legal::Decided& decided, const Profile& profile) {
  io::JsonWriter json;
  const auto samples = static_cast<std::size_t>(decided.samples);
  const auto width = static_cast<std::size_t>(decided.width);
  const auto place = [&](std::size_t s) {
    json.Key("column").Integer(s / samples % width);
    json.Key("row").Integer(s / samples / width);
    json.Key("sample").Integer(s % samples);
  };
  json.BeginObject();
  json.Key("rasterproof_decided").Integer(1);
  json.Key("profile").Value(io::ProfileToJson(profile));
  json.Key("width").Integer(decided.width);
  json.Key("height").Integer(decided.height);
  json.Key("samples_per_pixel").Integer(decided.samples);
  json.Key("open").Integer(decided.NumberOpen());
  json.Key("bounded").Integer(decided.bounded);
  json.Key("least").BeginArray();
  for (std::size_t s = 0; s < decided.counts.size(); ++s) json.Integer(decided.Least(s));
  json.EndArray();
  json.Key("most").BeginArray();
  for (std::size_t s = 0; s < decided.counts.size(); ++s) json.Integer(decided.Most(s));
  json.EndArray();
  json.Key("may").BeginArray();
  for (const legal::OpenDecision& open : decided.open) {
    json.BeginObject();
    json.Key("triangle").Integer(open.triangle);
    place(open.sample);
    if (open.edge >= 0) {
      json.Key("edge").Integer(open.edge);
      json.Key("distance_pixels").Rounded(open.distance);
      if (decided.step > 0) json.Key("distance_steps").Rounded(open.distance / decided.step);
    }
    json.EndObject();
  }
  json.EndArray();
  AddTriangles(decided, json);
  json.EndObject();
  return json.Finish();
}

// Light: covered never; dark: always; loud: legal models differ.
io::Image Paint(const legal::Decided& decided) {
  CoverageCounts least(decided.width, decided.height, decided.samples);
  CoverageCounts most = least;
  for (std::size_t s = 0; s < decided.counts.size(); ++s) {
    least.front[s] = static_cast<std::uint32_t>(decided.Least(s));
    most.front[s] = static_cast<std::uint32_t>(decided.Most(s));
  }
  return report::PaintDifference(most, least);
}

// For a program that compares pictures: black where nothing may be covered, white where something
// must be, grey 128 where it is open whether anything is. A sample is a pixel.
io::Image MaskOf(const legal::Decided& decided) {
  io::Image mask(decided.width * decided.samples, decided.height);
  for (std::size_t s = 0; s < decided.counts.size(); ++s) {
    constexpr std::uint8_t kOpen = 128;
    const bool may_be_free = decided.Least(s) == 0;
    const bool may_be_covered = decided.Most(s) > 0;
    const std::uint8_t level = !may_be_covered ? 0 : may_be_free ? kOpen : 255;
    mask.pixels[s] = {level, level, level};
  }
  return mask;
}

// The mask as an array of a test's language, by the ending of its file; nothing for a picture.
std::optional<std::string> MaskAsCode(const std::string& path, const io::Image& mask) {
  using report::CodeLanguage;
  constexpr auto kEndings =
      std::to_array<std::pair<std::string_view, CodeLanguage>>({{".h", CodeLanguage::kCpp},
                                                                {".hpp", CodeLanguage::kCpp},
                                                                {".ts", CodeLanguage::kTypescript},
                                                                {".py", CodeLanguage::kPython}});
  const auto found = std::ranges::find_if(
      kEndings, [&](const auto& known) { return path.ends_with(known.first); });
  if (found == kEndings.end()) return std::nullopt;
  const auto columns = static_cast<std::size_t>(mask.width);
  std::vector<report::CodeRow> rows(static_cast<std::size_t>(mask.height));
  for (std::size_t s = 0; s < mask.pixels.size(); ++s)
    rows[s / columns].push_back(std::to_string(mask.pixels[s][0]));
  const CodeLanguage language = found->second;
  return fmt::format(
      "{}255: every legal picture covers it; 0: none does; 128: legal pictures "
      "differ\n{}{}",
      report::CommentOf(language), language == CodeLanguage::kTypescript ? "export " : "",
      report::ArrayAsCode(language, "mask", "unsigned char", columns, rows));
}

// The picture that the options ask for.
io::Image Picture(const legal::Decided& decided, const Scene& scene, const Profile& profile,
                  const LegalOptions& options) {
  PixelRect view{0, 0, decided.width, decided.height};
  if (!options.view.empty()) {
    const std::vector<int>& v = options.view;
    const bool fits = v[0] >= 0 && v[1] >= 0 && v[2] > 0 && v[3] > 0 && v[2] <= view.x1 - v[0] &&
                      v[3] <= view.y1 - v[1];
    if (!fits) {
      throw InputError("--view", "it leaves the target",
                       fmt::format("choose columns below {} and rows below {}", view.x1, view.y1));
    }
    view = {v[0], v[1], v[0] + v[2], v[1] + v[3]};
  }
  constexpr int kLongestSide = 8192;
  if (std::max(view.x1 - view.x0, view.y1 - view.y0) > kLongestSide / options.scale) {
    throw InputError("--scale", fmt::format("the picture is longer than {} pixels", kLongestSide),
                     "give a smaller --scale or --view");
  }
  io::Image pixels = report::Enlarged(Paint(decided), scene, view, options.scale, profile.y_axis);
  if (options.scale < kLeastForLabels) return pixels;
  constexpr std::array kLegend{
      report::LegendEntry{report::kUncovered, "covered by no legal model"},
      report::LegendEntry{report::kCovered, "covered by all (darker: more often)"},
      report::LegendEntry{report::kBlue, "legal models differ"}};
  return report::Labelled(pixels, view, options.scale, kLegend);
}

}  // namespace

int TellDecided(const LegalOptions& options) {
  const Profile profile = WithAssumptions(io::ReadProfile(options.profile), options);
  const Scene scene = LoadScene(options.scene);
  if (const auto why = legal::WhyNotJoint(scene, {profile, scene})) {
    throw InputError("--profile " + options.profile, *why, RemedyOf(*why));
  }
  const legal::Decided decided = legal::DecidedSamples(scene, {profile, scene});
  if (!options.json.empty()) io::WriteOutput(options.json, ToJson(decided, profile));
  if (!options.png.empty())
    io::WriteFile(options.png,
                  io::EncodeFor(options.png, Picture(decided, scene, profile, options)));
  if (!options.mask.empty()) {
    const io::Image mask = MaskOf(decided);
    const std::optional<std::string> code = MaskAsCode(options.mask, mask);
    io::WriteFile(options.mask, code ? *code : io::EncodeFor(options.mask, mask));
  }
  if (options.json != "-") io::WriteStandardOutput(Letters(decided));
  const std::uint64_t open = decided.NumberOpen();
  Tell(fmt::format(
      "{} of {} samples have one count in every legal model of profile {}; {} have "
      "several{}\n",
      decided.counts.size() - open, decided.counts.size(), profile.name, open,
      decided.bounded == 0 ? "" : fmt::format(", of {} only bounds are known", decided.bounded)));
  Tell(AssumedErrorLine(options));
  constexpr int kMostTold = 3;
  int told = 0;
  for (const legal::OpenDecision& why : decided.open) {
    // Of a triangle alone a sample may be open that all of them together decide.
    if (decided.IsDecided(why.sample)) continue;
    if (told++ == kMostTold) break;
    Tell(fmt::format("{}: {} triangles; open for triangle {}{}\n",
                     SampleText(why.sample, decided.width, decided.samples),
                     RangeText(decided.Least(why.sample), decided.Most(why.sample)), why.triangle,
                     why.edge < 0       ? ", of which nothing is stated"
                     : decided.step > 0 ? fmt::format(", {:.3g} steps of the grid from its edge {}",
                                                      why.distance / decided.step, why.edge)
                                        : fmt::format(", {:.3g} pixels from its edge {}",
                                                      why.distance, why.edge)));
  }
  return kExitHolds;
}

}  // namespace rasterproof::tool
