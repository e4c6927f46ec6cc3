#include "props/domains/worlds.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "core/profile.h"
#include "core/scene.h"
#include "core/vertex.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/width_inputs.h"

namespace rasterproof::props {
namespace {

constexpr std::array<std::string_view, 5> kOfTriangles{
    "CoverageEqualsTheModel", "ClipSpaceCoverageEqualsTheModel", "OneLegalModelExplainsTheMesh",
    "SquaresThatMustBeAreCovered", "SquaresOutsideTheMayRegionStayFree"};
constexpr std::array<std::string_view, 4> kOfPairs{
    "CoverageEqualsTheModel", "ClipSpaceCoverageEqualsTheModel", "SharedEdgeSamplesAreCoveredOnce",
    "OneLegalModelExplainsTheMesh"};
constexpr std::array<std::string_view, 2> kOfFans{"SignedCoverageEqualsTheWindingNumber",
                                                  "EmbeddedMeshSamplesAreCoveredOnce"};
constexpr std::array<std::string_view, 2> kOfSizes{"CoverageEqualsTheModel",
                                                   "EmbeddedMeshSamplesAreCoveredOnce"};
constexpr int kRing = 6;

// All ones: no chance is taken, and nothing is drawn of what a recipe leaves to chance.
class NoChance final : public BitSource {
 public:
  std::uint64_t Bits(int count) override {
    return std::numeric_limits<std::uint64_t>::max() >> (64 - count);
  }
};

enum class Shape : std::uint8_t { kTriangle, kPair, kFan };

constexpr int VerticesOf(Shape shape) {
  switch (shape) {
    case Shape::kTriangle:
      return 3;
    case Shape::kPair:
      return 4;
    case Shape::kFan:
      break;
  }
  return kRing + 1;
}

constexpr std::uint64_t CasesOf(Shape shape, int side) {
  std::uint64_t cases = 1;
  for (int k = 0; k < VerticesOf(shape); ++k) cases *= static_cast<std::uint64_t>(side * side);
  return cases;
}

// Half pixels.
Point2 HalvesAt(std::uint64_t column, std::uint64_t row) {
  return {static_cast<double>(column) / 2, static_cast<double>(row) / 2};
}

void AddTriangles(Shape shape, CaseBuilder& builder) {
  switch (shape) {
    case Shape::kTriangle:
      builder.AddTriangle(0, 1, 2);
      break;
    case Shape::kPair:
      builder.AddTriangle(0, 1, 2);
      builder.AddTriangle(1, 0, 3);
      break;
    case Shape::kFan:
      for (int k = 0; k < kRing; ++k) builder.AddTriangle(0, 1 + k, 1 + (k + 1) % kRing);
      break;
  }
}

template <Shape shape, int side>
Case OnPoints(std::uint64_t index, const SubjectInfo& info) {
  constexpr int kPixels = side / 2;  // they hold all points
  NoChance bits;
  CaseBuilder builder(bits, info, kPixels, kPixels);
  for (int k = 0; k < VerticesOf(shape); ++k) {
    const std::uint64_t digit = index % (side * side);
    index /= side * side;
    builder.Add(HalvesAt(digit % side, digit / side));
  }
  AddTriangles(shape, builder);
  return builder.Done(Finish::kAsIs);
}

// Each vertex its own index, each square of half a pixel two triangles.
Case Sheet(int side, const SubjectInfo& info) {
  NoChance bits;
  CaseBuilder builder(bits, info, side / 2, side / 2);
  const auto points = static_cast<std::uint64_t>(side);
  for (std::uint64_t k = 0; k < points * points; ++k) builder.Add(HalvesAt(k % points, k / points));
  for (int row = 0; row + 1 < side; ++row) {
    for (int column = 0; column + 1 < side; ++column) {
      const int at = row * side + column;
      builder.AddTriangle(at, at + side, at + 1);
      builder.AddTriangle(at + 1, at + side, at + side + 1);
    }
  }
  return builder.Done(Finish::kAsIs);
}

// More than 2^16 triangles of fewer vertices; then more vertices, too.
constexpr std::array kSheets{200, 260};

Case LongLists(std::uint64_t index, const SubjectInfo& info) {
  return Sheet(kSheets[static_cast<std::size_t>(index)], info);
}

// A triangle in each corner, and one from end to end whose long edges pass through samples.
Case InCorners(int width, int height, const SubjectInfo& info) {
  NoChance bits;
  CaseBuilder builder(bits, info, width, height);
  const double right = width;
  const double bottom = height;
  builder.AddTriangle({{{0, 0}, {0.5, 1}, {1, 0.5}}});
  builder.AddTriangle({{{right, 0}, {right - 1, 0.5}, {right - 0.5, 1}}});
  builder.AddTriangle({{{0, bottom}, {1, bottom - 0.5}, {0.5, bottom - 1}}});
  builder.AddTriangle({{{right, bottom}, {right - 0.5, bottom - 1}, {right - 1, bottom - 0.5}}});
  builder.AddTriangle({{{0.5, 0.5}, {right - 0.5, bottom - 0.5}, {right, bottom - 0.5}}});
  return builder.Done(Finish::kAsIs);
}

constexpr int kLongSide = 16400;  // more than 2^14, the largest target of current APIs
constexpr int kShortSide = 3;

Case LongTargets(std::uint64_t index, const SubjectInfo& info) {
  return index == 0 ? InCorners(kLongSide, kShortSide, info)
                    : InCorners(kShortSide, kLongSide, info);
}

// As wide as the largest target of current APIs; the counts of both facings take 2^29 bytes.
constexpr int kLargeWidth = 1 << 14;
constexpr int kLargeHeight = 1 << 12;

Case LargeTarget(std::uint64_t /*index*/, const SubjectInfo& info) {
  return InCorners(kLargeWidth, kLargeHeight, info);
}

template <Shape shape, int side>
constexpr World WorldOf(std::string_view name, std::string_view summary) {
  constexpr std::int64_t kPixels = (side / 2) * (side / 2);
  World world{name, summary, CasesOf(shape, side), side - 1, kPixels, {}, OnPoints<shape, side>};
  if (shape == Shape::kTriangle) world.properties = kOfTriangles;
  if (shape == Shape::kPair) world.properties = kOfPairs;
  if (shape == Shape::kFan) world.properties = kOfFans;
  return world;
}

constexpr std::array kWorlds{
    World{"large-target", "16384 x 4096 samples: 2^29 bytes of counts", 1, 2 * kLargeWidth,
          std::int64_t{kLargeWidth} * kLargeHeight, kOfSizes, LargeTarget},
    World{"long-targets", "16400 columns, and 16400 rows", 2, 2 * kLongSide,
          std::int64_t{kLongSide} * kShortSide, kOfSizes, LongTargets},
    World{"long-lists", "more than 2^16 triangles, and more than 2^16 vertices", kSheets.size(),
          kSheets.back() - 1, std::int64_t{kSheets.back()} * kSheets.back() / 4, kOfSizes,
          LongLists},
    WorldOf<Shape::kPair, 3>("pairs-3x3", "all pairs of triangles on an edge, on 3 x 3 points"),
    WorldOf<Shape::kPair, 4>("pairs-4x4", "all pairs of triangles on an edge, on 4 x 4 points"),
    WorldOf<Shape::kTriangle, 7>("triangles-7x7", "all triangles on 7 x 7 points"),
    WorldOf<Shape::kFan, 3>("fans-3x3", "all fans of six triangles on 3 x 3 points"),
    WorldOf<Shape::kPair, 7>("pairs-7x7", "all pairs of triangles on an edge, on 7 x 7 points"),
    WorldOf<Shape::kFan, 4>("fans-4x4", "all fans of six triangles on 4 x 4 points"),
};
static_assert(std::ranges::is_sorted(kWorlds, {}, &World::cases));

}  // namespace

std::span<const World> Worlds() { return kWorlds; }

const World* FindWorld(std::string_view name) {
  if (name == WidthInputs().name) return &WidthInputs();
  const auto found = std::ranges::find(kWorlds, name, &World::name);
  return found == kWorlds.end() ? nullptr : &*found;
}

std::string WhyNotGiven(const World& world, const SubjectInfo& info) {
  if (info.profile.transform) return "its transform takes no vertex exactly to the world's points";
  const Profile& profile = info.profile;
  if (world.pixels * profile.pattern.samples() > kMaxTargetSamples) {
    return "with its samples per pixel the target is too large";
  }
  if (world.why_not != nullptr) return world.why_not(info);
  const int pixels = (world.reach + 1) / 2;
  NoChance bits;
  const CaseBuilder builder(bits, info, pixels, 1);
  constexpr int kLooked = 16;  // coordinates at both ends: what takes these takes those between
  for (int k = 0; k <= world.reach; ++k) {
    if (k > kLooked && k < world.reach - kLooked) continue;
    if (builder.lattice().RoundWithinLimit(k * 0.5) == k * 0.5) continue;
    return k <= kLooked ? "its input does not take coordinates of half a pixel"
                        : "its input does not take coordinates up to " + std::to_string(pixels) +
                              ", half a pixel apart";
  }
  return "";
}

Case CaseOfWorld(const World& world, std::uint64_t index, const SubjectInfo& info) {
  Case c = world.draw(index, info);
  c.scene.name = world.name;
  return c;
}

}  // namespace rasterproof::props
