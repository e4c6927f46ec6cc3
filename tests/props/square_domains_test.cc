// Two deciders of squares on triangles of every domain: spans, and each square asked by itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "core/square_presets.h"
#include "core/vertex.h"
#include "exact/edge.h"
#include "exact/square.h"
#include "model/snap_scene.h"
#include "props/domains/case_name.h"
#include "props/domains/domain.h"
#include "props/run/property_domains.h"
#include "tests/exact/one_square.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

using exact::Columns;

// Every square of the rows is asked up to so wide a target; beyond, those at the ends of spans and
// of the row, and one in kStride.
constexpr int kWholeRow = 24;
constexpr int kStride = 61;

// How many triangles: RASTERPROOF_SQUARES, or a few.
std::uint64_t HowMany() {
  const char* more = std::getenv("RASTERPROOF_SQUARES");
  return more == nullptr ? Cases<std::uint64_t>(3000) : std::strtoull(more, nullptr, 10);
}

// The columns of each row, from spans.
std::vector<Columns> RowsOf(const std::array<Point2, 3>& v, const SquareRegion& region,
                            const exact::SquareFrame& frame) {
  std::vector<Columns> rows(static_cast<std::size_t>(frame.clip.y1));
  exact::ForEachSquareSpan(v, region, frame, [&](int row, Columns columns) {
    rows[static_cast<std::size_t>(row)] = columns;
  });
  return rows;
}

bool IsAsked(int i, int width, const Columns& columns) {
  const auto near = [i](int at) { return i >= at - 2 && i <= at + 1; };
  return width <= kWholeRow || i % kStride == 0 || i == width - 1 || near(columns.first) ||
         near(columns.last);
}

// Of a higher target: rows beside the vertices, and others at a stride.
bool IsAskedRow(int row, int height, const std::array<Point2, 3>& v, double lift, bool is_empty) {
  if (height <= kWholeRow || row % (is_empty ? kStride : kStride / 4) == 0) return true;
  return std::ranges::any_of(v, [&](const Point2& p) {
    const double y = p.y + lift;
    return y >= row - 3 && y <= row + 4;
  });
}

struct Asked {
  std::uint64_t triangles = 0;
  std::uint64_t squares = 0;
  std::uint64_t covered = 0;
};

// Returns where the two differ, or nothing.
std::string Compare(const std::array<Point2, 3>& v, const SquareRegion& region,
                    const exact::SquareFrame& frame, Asked& asked) {
  const std::vector<Columns> rows = RowsOf(v, region, frame);
  ++asked.triangles;
  for (int row = 0; row < frame.clip.y1; ++row) {
    const Columns& columns = rows[static_cast<std::size_t>(row)];
    const bool is_empty = columns.first >= columns.last;
    if (!IsAskedRow(row, frame.clip.y1, v, frame.lift, is_empty)) continue;
    for (int i = 0; i < frame.clip.x1; ++i) {
      if (!IsAsked(i, frame.clip.x1, columns)) continue;
      const bool spans = i >= columns.first && i < columns.last;
      const bool truth =
          exact::IsSquareCovered(v, region, frame, i, row, exact::Decider::kIntegers);
      ++asked.squares;
      asked.covered += truth;
      if (spans != truth) {
        return "column " + std::to_string(i) + ", row " + std::to_string(row) +
               (spans ? ": spans alone cover it" : ": the square's own decider alone covers it");
      }
    }
  }
  return {};
}

std::string CompareCase(const Case& c, Asked& asked, std::uint64_t most) {
  const Scene placed = SnapScene(c.scene, {c.profile, c.scene});
  exact::SquareFrame frame{{0, 0, c.scene.width, c.scene.height}, c.profile.y_axis == YAxis::kUp};
  if (frame.y_up) frame.lift = c.scene.height;
  for (const auto& region : {c.profile.squares->must, c.profile.squares->may}) {
    if (!region) continue;
    const Scene& scene = region->geometry == SquareGeometry::kGiven ? c.scene : placed;
    for (const Triangle& t : scene.triangles) {
      if (asked.triangles >= most) return {};
      const std::array<Vertex, 3> corners = Corners(scene, t);
      if (!std::ranges::all_of(corners, IsFinite)) continue;
      std::array<Point2, 3> v;
      for (std::size_t k = 0; k < 3; ++k) v[k] = frame.ToScreen({corners[k].x, corners[k].y});
      std::string difference = Compare(v, *region, frame, asked);
      if (!difference.empty()) return difference;
    }
  }
  return {};
}

SubjectInfo InfoOf(std::size_t preset, bool is_double) {
  SubjectInfo info;
  info.profile = *PresetProfile(kSquarePresets[preset].name);
  info.input = is_double ? Precision::kFloat64 : Precision::kFloat32;
  return info;
}

// Of window space, and about something that a profile of squares states.
bool IsDrawn(const Domain& domain) {
  return Suits(domain, InfoOf(0, false)) || Suits(domain, InfoOf(0, true));
}

TEST(SquareDomains, SpansEqualTheSquareBySquareDecider) {
  constexpr std::uint64_t kSeed = 12;
  const auto domains = static_cast<std::size_t>(std::ranges::count_if(Domains(), IsDrawn));
  const std::uint64_t share = HowMany() / domains + 1;
  Asked all;
  for (const Domain& domain : Domains()) {
    if (!IsDrawn(domain)) continue;
    Asked asked;
    const std::uint64_t most_cases = 4 * share;
    for (std::uint64_t k = 0; k < most_cases && asked.triangles < share; ++k) {
      const SubjectInfo info = InfoOf(k % kSquarePresets.size(), k % 2 == 1);
      if (!Suits(domain, info)) continue;
      const Case c = DrawCase(info, CaseName{std::string(domain.name), k, kSeed});
      ASSERT_EQ(CompareCase(c, asked, share), "")
          << domain.name << ":" << k << "@" << kSeed << " of " << info.profile.name;
    }
    all.triangles += asked.triangles;
    all.squares += asked.squares;
    all.covered += asked.covered;
  }
  EXPECT_GE(all.triangles, HowMany() * 9 / 10);
  EXPECT_GT(all.covered, all.triangles / 8);
  RecordProperty("triangles", std::to_string(all.triangles));
  RecordProperty("squares", std::to_string(all.squares));
  std::printf("%llu triangles, %llu squares, %llu covered\n",
              static_cast<unsigned long long>(all.triangles),
              static_cast<unsigned long long>(all.squares),
              static_cast<unsigned long long>(all.covered));
}

}  // namespace
}  // namespace rasterproof::props
