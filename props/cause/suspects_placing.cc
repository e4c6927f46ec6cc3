// Suspects that put vertices or samples elsewhere.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/snap.h"
#include "props/cause/suspect.h"

namespace rasterproof::props {
namespace {

std::string PixelsText(double x) {
  const auto parts = static_cast<int>(std::lround(x * 256));
  return parts % 256 == 0 ? std::to_string(parts / 256) : std::to_string(parts) + "/256";
}

SuspectStages Snapping(Snap snap) {
  return {.model = [snap](Profile& p, const Scene&) { p.snap = snap; }};
}

struct RuleWords {
  SnapRule rule;
  std::string_view cause;
  std::string_view words;
};
constexpr auto kRuleWords = std::to_array<RuleWords>({
    {SnapRule::kTruncate, "truncation", "truncates coordinates toward zero"},
    {SnapRule::kFloor, "truncation", "rounds coordinates down"},
    {SnapRule::kHalfUp, "rounding", "rounds coordinates half way between two grid points up"},
    {SnapRule::kNearestAway, "rounding",
     "rounds coordinates half way between two grid points away from zero"},
    {SnapRule::kNearestEven, "rounding",
     "rounds coordinates half way between two grid points to the even one"},
});

void AddRules(const Snap& stated, std::vector<Suspect>& list) {
  for (const RuleWords& row : kRuleWords) {
    if (row.rule == stated.rule) continue;
    Snap other = stated;
    other.rule = row.rule;
    list.push_back({std::string(row.cause), std::string(row.words), Snapping(other)});
    for (const bool y : {false, true}) {
      SuspectStages one{.snap = [stated, other, y](double x, bool along_y) {
        return SnapCoordinate(x, along_y == y ? other : stated);
      }};
      list.push_back({std::string(row.cause),
                      std::string(row.words) + (y ? ", y alone" : ", x alone"), std::move(one)});
    }
    SuspectStages negative{.snap = [stated, other](double x, bool) {
      return SnapCoordinate(x, x < 0 ? other : stated);
    }};
    list.push_back({std::string(row.cause), std::string(row.words) + ", negative ones alone",
                    std::move(negative)});
  }
  const double scale = std::ldexp(1.0, stated.bits);
  list.push_back(
      {"rounding", "adds one half in float32 and rounds down", {.snap = [scale](double x, bool) {
         const float sum = static_cast<float>(x * scale) + 0.5F;
         return std::floor(double{sum}) / scale;
       }}});
  list.push_back(
      {"rounding", "adds one half in float32 and truncates", {.snap = [scale](double x, bool) {
         const float sum = static_cast<float>(x * scale) + 0.5F;
         return std::trunc(double{sum}) / scale;
       }}});
  list.push_back({"rounding",
                  "rounds after one half was taken off in float32",
                  {.snap = [stated](double x, bool) {
                    return SnapCoordinate(static_cast<float>(x) - 0.5F, stated) + 0.5;
                  }}});
  list.push_back({"rounding",
                  "rounds by the sum with 1.5 2^23 in float32, too small far out",
                  {.snap = [scale](double x, bool) {
                    constexpr float kMagic = 12582912.0F;
                    const float forced = static_cast<float>(x * scale) + kMagic;
                    return double{forced - kMagic} / scale;
                  }}});
  list.push_back(
      {"rounding", "rounds negative coordinates half down", {.snap = [stated](double x, bool) {
         Snap up = stated;
         up.rule = SnapRule::kHalfUp;
         return x < 0 ? -SnapCoordinate(-x, up) : SnapCoordinate(x, stated);
       }}});
  list.push_back({"rounding",
                  "rounds the size of a negative coordinate down",
                  {.snap = [stated](double x, bool) {
                    Snap down = stated;
                    down.rule = SnapRule::kFloor;
                    return x < 0 ? -SnapCoordinate(-x, down) : SnapCoordinate(x, stated);
                  }}});
}

// Rules that no profile states.
void AddOtherRules(const Snap& stated, std::vector<Suspect>& list) {
  const double scale = std::ldexp(1.0, stated.bits);
  const auto add = [&](const std::string& cause, const std::string& what, auto snap) {
    list.push_back({cause, what, {.snap = [snap](double x, bool) { return snap(x); }}});
  };
  add("truncation", "rounds coordinates up",
      [scale](double x) { return std::ceil(x * scale) / scale; });
  add("truncation", "truncates coordinates between -1 and 0 toward zero", [stated](double x) {
    Snap cut = stated;
    cut.rule = SnapRule::kTruncate;
    return SnapCoordinate(x, x > -1 && x < 0 ? cut : stated);
  });
  add("rounding", "rounds coordinates half way between two grid points down", [stated](double x) {
    Snap up = stated;
    up.rule = SnapRule::kHalfUp;
    return -SnapCoordinate(-x, up);
  });
}

// The nearest number of float16; what is beyond them is infinite.
double InFloat16(double x) {
  constexpr int kSignificand = 11, kLeastExponent = -24;
  constexpr double kEnd = 65520;  // half way from the largest to the next
  if (!(std::fabs(x) < kEnd)) return std::isnan(x) ? x : std::copysign(HUGE_VAL, x);
  int exponent = 0;
  std::frexp(x, &exponent);
  const int last = std::max(exponent - kSignificand, kLeastExponent);
  return std::ldexp(std::nearbyint(std::ldexp(x, -last)), last);
}

void AddBits(const Snap& stated, std::vector<Suspect>& list) {
  for (int bits = 0; bits <= kMaxSubpixelBits; ++bits) {
    if (bits == stated.bits) continue;
    for (const RuleWords& row : kRuleWords) {
      list.push_back(
          {"subpixel-bits",
           "keeps " + std::to_string(bits) + " subpixel bits and " + std::string(row.words),
           Snapping({bits, row.rule})});
    }
  }
  if (stated.IsNone()) return;
  list.push_back({"subpixel-bits", "snaps no coordinate", Snapping({})});
  for (int k = 8; k <= 14; ++k) {
    const double far = std::ldexp(1.0, k);
    for (int fewer = 1; fewer <= 4 && fewer <= stated.bits; ++fewer) {
      Snap coarse = stated;
      coarse.bits -= fewer;
      list.push_back({"subpixel-bits",
                      "keeps only " + std::to_string(coarse.bits) + " subpixel bits from " +
                          std::to_string(1 << k) + " pixels on",
                      {.snap = [stated, coarse, far](double x, bool) {
                        return SnapCoordinate(x, std::fabs(x) < far ? stated : coarse);
                      }}});
    }
  }
}

void AddOffsets(std::vector<Suspect>& list) {
  std::vector<Point2> offsets;
  for (const int n : {128, 1, 2, 3, 4, 5, 6, 7, 8, 16, 32, 64}) {
    const double d = n / 256.0;
    for (const double x : {-d, 0.0, d}) {
      for (const double y : {-d, 0.0, d}) {
        if (x != 0 || y != 0) offsets.push_back({x, y});
      }
    }
  }
  offsets.insert(offsets.end(), {{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, 1}});
  for (const Point2 off : offsets) {
    const std::string where = "takes samples that lie (" + PixelsText(off.x) + ", " +
                              PixelsText(off.y) + ") pixels from the stated ones";
    list.push_back({"sample-location", where, {.sample = [off](const SuspectSample& s) {
                      return Point2{s.at.x + off.x, s.at.y + off.y};
                    }}});
  }
}

// Where the samples lie in their pixel, changed as a whole.
void AddPatterns(const Profile& profile, std::vector<Suspect>& list) {
  const SamplePattern& pattern = profile.pattern;
  const double up = profile.y_axis == YAxis::kUp ? -1 : 1;
  const auto moved_to = [up](const SamplePattern& stated, std::vector<Point2> places) {
    return SuspectStages{
        .sample = [stated, up, places = std::move(places)](const SuspectSample& s) {
          const auto n = static_cast<std::size_t>(s.s);
          const Point2 from = stated.locations[n];
          return Point2{s.at.x + places[n].x - from.x, s.at.y + up * (places[n].y - from.y)};
        }};
  };
  const auto add = [&](const std::string& what, const std::vector<Point2>& places) {
    if (places != pattern.locations)
      list.push_back({"sample-order", what, moved_to(pattern, places)});
  };
  const auto n = pattern.locations.size();
  if (n == 1) return;
  std::vector<Point2> x = pattern.locations, y = x, both = x, axes = x;
  for (std::size_t k = 0; k < n; ++k) {
    x[k].x = 1 - x[k].x;
    y[k].y = 1 - y[k].y;
    both[k] = {x[k].x, y[k].y};
    std::swap(axes[k].x, axes[k].y);
  }
  add("mirrors the sample locations in x", x);
  add("mirrors the sample locations in y", y);
  add("turns the sample locations by a half turn", both);
  add("exchanges the axes of the sample locations", axes);
  add("takes the pixel's centre for all samples", std::vector<Point2>(n, {0.5, 0.5}));
  for (std::size_t i = 0; i < n; ++i) {
    add("takes sample " + std::to_string(i) + " for all",
        std::vector<Point2>(n, pattern.locations[i]));
    std::vector<Point2> centre = pattern.locations;
    centre[i] = {0.5, 0.5};
    add("takes the pixel's centre for sample " + std::to_string(i), centre);
    for (std::size_t j = i + 1; j < n && n <= 8; ++j) {
      std::vector<Point2> swapped = pattern.locations;
      std::swap(swapped[i], swapped[j]);
      add("exchanges samples " + std::to_string(i) + " and " + std::to_string(j), swapped);
    }
  }
}

std::int64_t CutToBits(double x, double scale, int bits, bool is_signed) {
  const int unused = 64 - bits;
  const auto raw = static_cast<std::uint64_t>(static_cast<std::int64_t>(x * scale)) << unused;
  return is_signed ? static_cast<std::int64_t>(raw) >> unused
                   : static_cast<std::int64_t>(raw >> unused);
}

void AddRange(const Profile& profile, std::vector<Suspect>& list) {
  if (profile.snap.IsNone()) return;
  const double scale = std::ldexp(1.0, profile.snap.bits);
  for (const int bits : {16, 24, 15, 20, 12, 32}) {
    for (const bool is_signed : {true, false}) {
      list.push_back({"overflow",
                      std::string("wraps coordinates to ") + (is_signed ? "signed" : "unsigned") +
                          " integers of " + std::to_string(bits) + " bits",
                      {.place = [=](Point2& p, const Scene&) {
                        constexpr double kMost = 0x1p60;
                        if (std::max(std::fabs(p.x), std::fabs(p.y)) * scale > kMost) return;
                        p = {static_cast<double>(CutToBits(p.x, scale, bits, is_signed)) / scale,
                             static_cast<double>(CutToBits(p.y, scale, bits, is_signed)) / scale};
                      }}});
    }
  }
  for (int k = 10; k <= 15; ++k) {
    const double end = std::ldexp(1.0, k);
    for (const double step : {0.0, 1 / scale, 1.0 / 16, 1.0}) {
      list.push_back({"range",
                      "clamps coordinates to " + std::to_string(1 << k) + " pixels",
                      {.place = [end, step](Point2& p, const Scene&) {
                        p = {std::clamp(p.x, -end, end - step), std::clamp(p.y, -end, end - step)};
                      }}});
    }
  }
  const bool y_up = profile.y_axis == YAxis::kUp;
  for (const double early : {0.0, 1.0}) {
    list.push_back({"range",
                    early == 0 ? "clamps vertices to the target"
                               : "clamps vertices to the target less its last row and column",
                    {.place = [early, y_up](Point2& p, const Scene& scene) {
                      const double y = std::clamp(y_up ? -p.y : p.y, 0.0, scene.height - early);
                      p = {std::clamp(p.x, 0.0, scene.width - early), y_up ? -y : y};
                    }}});
  }
  for (const double pixels : {0.0, 1.0}) {
    list.push_back({"range",
                    "clamps negative coordinates to " + PixelsText(-pixels),
                    {.place = [pixels](Point2& p, const Scene&) {
                      p = {std::max(p.x, -pixels), std::max(p.y, -pixels)};
                    }}});
  }
}

}  // namespace

void AddPlacing(const Profile& profile, std::vector<Suspect>& list) {
  if (!profile.snap.IsNone()) AddRules(profile.snap, list);
  AddBits(profile.snap, list);
  if (!profile.snap.IsNone()) AddOtherRules(profile.snap, list);
  list.push_back({"subpixel-bits",
                  "rounds the coordinates that it is given to float16",
                  {.vertices = [](std::array<Vertex, 3>& corners) {
                    for (Vertex& v : corners) v = {InFloat16(v.x), InFloat16(v.y), v.z, v.w};
                  }}});
  AddOffsets(list);
  AddPatterns(profile, list);
  AddRange(profile, list);
}

}  // namespace rasterproof::props
