#include "fuzz/fuzz_target.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/case.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "core/vertex.h"
#include "fuzz/guidance.h"
#include "fuzz/screens.h"
#include "props/codec/codec.h"
#include "props/domains/bit_source.h"

namespace rasterproof::fuzz {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Spelled out on 12x12 pixels: a square between pixel centres split by its diagonal, and four
// triangles around a pixel centre.
constexpr auto kQuadThroughCentres = std::to_array<std::uint8_t>(
    {0, 11, 11, 1, 9, 0, 9, 0, 9, 0, 29, 0, 29, 0, 29, 0, 29, 0, 9, 0, 1, 0, 0, 0, 3, 0, 0});
constexpr auto kFanOnACentre =
    std::to_array<std::uint8_t>({0, 11, 11, 2, 19, 0, 19, 0, 8, 0, 8, 0, 8, 0, 30, 0, 30, 0, 30,
                                 0, 30, 0,  8, 0,  3, 0,  0, 0, 4, 0, 0, 3, 0, 0,  2, 0,  1});

Bytes RandomBytes(std::uint64_t index) {
  props::PhiloxSource random(1, index);
  Bytes bytes(80);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.Bits(8));
  return bytes;
}

template <std::size_t n>
Bound BoundTo(const std::array<Checked, n>& checked) {
  return Bound(checked, Limits{});
}

TEST(BoundDeathTest, AViolationShowsTheCaseInHexAndTheCommand) {
  const Bound bound = BoundTo(std::array{Checked{"textbook", "SharedEdgeSamplesAreCoveredOnce"}});
  EXPECT_DEATH(bound.PutToTheTest(kQuadThroughCentres),
               "replay INPUT --subject textbook --property Shared");
  EXPECT_DEATH(bound.PutToTheTest(kQuadThroughCentres),
               "12x12 float32 window space\n  0x1p-1 0x1p-1");
}

TEST(BoundDeathTest, ANameThatThereIsNoneOfIsSaid) {
  EXPECT_DEATH(BoundTo(std::array{Checked{"textbok", "CoverageEqualsTheModel"}}), "textbok");
  EXPECT_DEATH(BoundTo(std::array{Checked{"textbook", "CoverageEqualsAModel"}}), "CoverageEqualsA");
}

TEST(Bound, NotesHowWrongEachSubjectIsUnderEachProperty) {
  const Bound bound = BoundTo(std::array{Checked{"f32-direct", "EdgeErrorStaysWithinItsBound"},
                                         Checked{"f32-direct", "ReversedEdgeChangesSign"},
                                         Checked{"f32-kahan", "EdgeErrorStaysWithinItsBound"}});
  for (std::uint64_t k = 0; k < 50; ++k) bound.PutToTheTest(RandomBytes(k));
  EXPECT_GT(LargestErrorOverBound(0), 0.05);
  EXPECT_EQ(LargestErrorOverBound(1), 0);
  EXPECT_GT(LargestErrorOverBound(2), 0.05);
  EXPECT_NE(LargestErrorOverBound(0), LargestErrorOverBound(2));
}

TEST(Bound, PutsEachPropertyOfEachSubjectToTheTestInItsTurn) {
  constexpr std::string_view kError = "EdgeErrorStaysWithinItsBound";
  const Bound bound = BoundTo(std::array{
      Checked{"f32-direct", kError}, Checked{"f32-direct", "ReversedEdgeChangesSign"},
      Checked{"f32-kahan", kError}, Checked{"f32-affine", kError}, Checked{"f64-direct", kError}});
  EXPECT_EQ(LargestErrorOverBound(3) + LargestErrorOverBound(4), 0);
  for (std::uint64_t k = 0; k < 300; ++k) bound.PutOneToTheTest(RandomBytes(k));
  EXPECT_GT(LargestErrorOverBound(3), 0);
  EXPECT_GT(LargestErrorOverBound(4), 0);
}

TEST(Bound, PassesOverWhatIsLargerThanItsLimits) {
  const std::array checked{Checked{"f32-direct", "DrawStaysInsideItsTarget"}};
  EXPECT_EQ(Bound(checked, Limits{144, 4}).PutToTheTest(kFanOnACentre), kLookedAt);
  EXPECT_EQ(Bound(checked, Limits{143, 4}).PutToTheTest(kFanOnACentre), kPassedOver);
  EXPECT_EQ(Bound(checked, Limits{144, 3}).PutToTheTest(kFanOnACentre), kPassedOver);
}

TEST(Bound, DecodesOnceForSubjectsOfOneLattice) {
  const auto groups_of = [](const Bound& bound) {
    int groups = 0;
    bound.ForEachCase(RandomBytes(0), [&](const Group&, const Case&) { ++groups; });
    return groups;
  };
  constexpr std::string_view kBound = "EdgeErrorStaysWithinItsBound";
  EXPECT_EQ(
      groups_of(BoundTo(std::array{Checked{"f32-direct", kBound}, Checked{"f32-kahan", kBound}})),
      1);
  EXPECT_EQ(
      groups_of(BoundTo(std::array{Checked{"f32-direct", kBound}, Checked{"i64-snap8", kBound}})),
      2);
}

// Runs random inputs until the screen aborts.
void LookForAFault(int (*screen)(const Bound&, std::span<const std::uint8_t>), const Checked& row) {
  const Bound bound = BoundTo(std::array{row});
  for (std::uint64_t k = 0; k < 3000; ++k) screen(bound, RandomBytes(k));
}

TEST(ScreensDeathTest, FindWhatIsPlanted) {
  const std::string_view signs = "EdgeSignIsRightOutsideItsBand";
  EXPECT_DEATH(LookForAFault(ScreenEdgeSigns, {"mutant:edge-absolute", signs}),
               "is violated by mutant:edge-absolute");
  EXPECT_DEATH(LookForAFault(ScreenCoverage, {"mutant:ties-inclusive", "CoverageEqualsTheModel"}),
               "is violated by mutant:ties-inclusive");
  EXPECT_DEATH(LookForAFault(ScreenWinding,
                             {"mutant:ties-inclusive", "SignedCoverageEqualsTheWindingNumber"}),
               "is violated by mutant:ties-inclusive");
}

// Estimates decide what is far from its bound: nothing that is planted may be.
TEST(BoundDeathTest, OneChosenPropertyFindsWhatIsPlanted) {
  const auto one = [](const Bound& bound, std::span<const std::uint8_t> bytes) {
    return bound.PutOneToTheTest(bytes);
  };
  for (const Checked& row : std::to_array<Checked>(
           {{"mutant:barycentrics-reciprocal", "BarycentricsStayWithinTheirBound"},
            {"mutant:barycentrics-one-minus", "BarycentricsSumToOne"},
            {"mutant:perspective-affine", "PerspectiveInterpolationStaysWithinItsBound"},
            {"mutant:depth-16-bits", "InterpolationStaysWithinItsBound"},
            {"mutant:distance-in-l2", "DerivativeDistanceMeasuresInTheL1Norm"},
            {"mutant:distance-of-next-edge", "HeightDistanceIsTheDistanceInPixels"},
            {"mutant:distance-of-barycentric-exchanged",
             "BarycentricDistanceIsTheSmallestCoordinate"},
            {"mutant:stepping-last-lost", "SteppingStaysWithinItsBound"}})) {
    EXPECT_DEATH(LookForAFault(one, row), "is violated by " + std::string(row.subject));
  }
}

// What libFuzzer reads: the linker names a section's ends.
extern "C" {
extern std::uint8_t __start___libfuzzer_extra_counters;
extern std::uint8_t __stop___libfuzzer_extra_counters;
}

std::vector<std::size_t> TakenPlaces() {
  std::vector<std::size_t> places;
  for (std::uint8_t* p = &__start___libfuzzer_extra_counters;
       p != &__stop___libfuzzer_extra_counters; ++p) {
    if (*p != 0)
      places.push_back(static_cast<std::size_t>(p - &__start___libfuzzer_extra_counters));
    *p = 0;
  }
  return places;
}

TEST(NoteNearZero, CountsTheOrdersThatAreLostAndNoneOfASumThatUnderflowed) {
  TakenPlaces();
  const auto place = [](double value, double sum) {
    NoteNearZero(0, value, sum);
    return TakenPlaces();
  };
  const std::vector<std::size_t> none = place(1, 1);
  ASSERT_EQ(none.size(), 1U);
  EXPECT_EQ(place(0x1p-9, 1), std::vector{none[0] + 9});
  EXPECT_EQ(place(0x1p-1074, 0x1p1023), std::vector{none[0] + 127});
  EXPECT_EQ(place(1, 0x1p-9), none);
  EXPECT_EQ(place(0x1p-1000, 0), none);
  EXPECT_EQ(place(0x1p1000, 0), none);
}

}  // namespace
}  // namespace rasterproof::fuzz
