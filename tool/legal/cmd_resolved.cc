// rasterproof legal --resolved: a picture that shows how many of a pixel's samples are covered.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/sample_text.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/counts_file.h"
#include "io/json_writer.h"
#include "io/output.h"
#include "legal/decided.h"
#include "report/grounds.h"
#include "tool/exit_status.h"
#include "tool/legal/cmd_legal.h"
#include "tool/legal/legality.h"

namespace rasterproof::tool {
namespace {

// Of a pixel's samples, how many legal models cover: each sample by itself.
struct PixelRange {
  std::uint32_t least = 0;
  std::uint32_t most = 0;
};

std::vector<PixelRange> RangesOf(const legal::Decided& decided) {
  const auto samples = static_cast<std::size_t>(decided.samples);
  std::vector<PixelRange> ranges(decided.counts.size() / samples);
  for (std::size_t s = 0; s < decided.counts.size(); ++s) {
    PixelRange& range = ranges[s / samples];
    if (decided.Least(s) > 0) ++range.least;
    if (decided.Most(s) > 0) ++range.most;
  }
  return ranges;
}

struct Found {
  std::uint64_t open = 0;            // pixels of which legal models cover differently many samples
  std::vector<std::size_t> wrong{};  // pixels outside their range
  legal::Legality Verdict() const {
    if (!wrong.empty()) return legal::Legality::kNotLegal;
    return open == 0 ? legal::Legality::kLegal : legal::Legality::kNotJudged;
  }
};

constexpr std::string_view kCompared =
    "covered samples of each pixel by itself: they need not share one model, and double coverage "
    "is not seen";

std::string TextOf(const Found& found, const std::vector<PixelRange>& ranges,
                   const std::vector<std::uint32_t>& seen, const legal::Decided& decided,
                   const Profile& profile) {
  std::string text = fmt::format("{}: profile {}; ", LegalityName(found.Verdict()), profile.name);
  if (!found.wrong.empty()) {
    text += fmt::format("{} of {} pixels cover another number of samples than every legal model\n",
                        found.wrong.size(), ranges.size());
  } else if (found.open != 0) {
    text += fmt::format(
        "no pixel contradicts; legal models differ on {} of {} pixels, and whether one model "
        "explains them together can't be seen: give counts by sample\n",
        found.open, ranges.size());
  } else {
    text += fmt::format("all {} pixels are as in every legal model\n", ranges.size());
  }
  text += fmt::format("compared: {}\n", kCompared);
  constexpr std::size_t kMostTold = 8;
  for (std::size_t k = 0; k < std::min(found.wrong.size(), kMostTold); ++k) {
    const std::size_t pixel = found.wrong[k];
    text += fmt::format("{}: {} of {} samples are covered, in legal models {} of {}\n",
                        PixelText(pixel, decided.width), seen[pixel], decided.samples,
                        RangeText(ranges[pixel].least, ranges[pixel].most), decided.samples);
  }
  return text;
}

std::string JsonOf(const Found& found, const std::vector<PixelRange>& ranges,
                   const std::vector<std::uint32_t>& seen, const legal::Decided& decided,
                   const Profile& profile) {
  io::JsonWriter json;
  json.BeginObject();
  json.Key("rasterproof_resolved").Integer(1);
  json.Key("verdict").Text(LegalityName(found.Verdict()));
  json.Key("compared").Text(kCompared);
  json.Key("profile").Value(io::ProfileToJson(profile));
  json.Key("width").Integer(decided.width);
  json.Key("height").Integer(decided.height);
  json.Key("samples_per_pixel").Integer(decided.samples);
  json.Key("open").Integer(found.open);
  json.Key("least").BeginArray();
  for (const PixelRange& range : ranges) json.Integer(range.least);
  json.EndArray();
  json.Key("most").BeginArray();
  for (const PixelRange& range : ranges) json.Integer(range.most);
  json.EndArray();
  const auto width = static_cast<std::size_t>(decided.width);
  json.Key("wrong").BeginArray();
  for (const std::size_t pixel : found.wrong) {
    json.BeginObject();
    json.Key("column").Integer(pixel % width);
    json.Key("row").Integer(pixel / width);
    json.Key("covered").Integer(seen[pixel]);
    json.EndObject();
  }
  json.EndArray();
  json.EndObject();
  return json.Finish();
}

}  // namespace

int JudgeResolved(const LegalOptions& options) {
  if (options.image.empty()) {
    throw InputError("--resolved", "no picture is given", "give its file after the scene");
  }
  const JudgedScene judged = LoadJudgedScene(options, nullptr);
  const auto& [scene, profile, saved] = judged;
  const legal::Decided decided = legal::DecidedSamples(scene, {profile, scene});
  const std::vector<std::uint32_t> seen =
      io::ReadCovered(options.image, scene.width, scene.height, decided.samples);
  const std::vector<PixelRange> ranges = RangesOf(decided);
  Found found;
  for (std::size_t pixel = 0; pixel < ranges.size(); ++pixel) {
    if (ranges[pixel].least != ranges[pixel].most) ++found.open;
    if (seen[pixel] < ranges[pixel].least || seen[pixel] > ranges[pixel].most)
      found.wrong.push_back(pixel);
  }
  if (!options.json.empty())
    io::WriteOutput(options.json, JsonOf(found, ranges, seen, decided, profile));
  if (options.json != "-") {
    io::WriteStandardOutput(TextOf(found, ranges, seen, decided, profile) +
                            report::AssumptionLines(profile) + AssumedErrorLine(options));
  }
  return StatusOf(found.Verdict());
}

}  // namespace rasterproof::tool
