#include "bench/fingerprint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/bench.h"
#include "bench/exact_triangles.h"
#include "core/profile.h"
#include "reference/method.h"
#include "tests/share.h"

namespace rasterproof::bench {
namespace {

Fingerprint Of(std::string_view method, const FingerprintStep& step) {
  FingerprintPlaces places(step);
  return places.Of(*MakeMethodContender(*reference::FindMethod(method)));
}

std::size_t CountOf(const std::vector<SampleOwner>& owners, SampleOwner owner) {
  return static_cast<std::size_t>(std::ranges::count(owners, owner));
}

// Draws by the oracle under one model, is held to another, and errs to order.
class Painter final : public Contender {
 public:
  explicit Painter(Profile draws, Profile held_to) : draws_(std::move(draws)) {
    method_.name = "painter";
    model_ = std::move(held_to);
  }
  std::optional<std::string> WhyNot(const FamilyInput& family) const override {
    if (family.scene.clip_space) return "clip space";
    return std::nullopt;
  }
  void Load(const FamilyInput& family) override { exact_.emplace(family.scene, draws_); }
  DrawTime Draw() override { return {}; }
  bool MoveDrawn(CoverageCounts& /*to*/) override { return false; }
  void DrawAlone(std::size_t triangle, const PixelRect& area,
                 std::vector<std::uint8_t>& box) override {
    exact_->Cover(triangle, area, box);
    if (triangle == wrong_triangle) {
      for (std::uint8_t& covered : box) covered = covered != 0 ? 0 : 1;
    }
  }
  std::uint64_t LeftBehind() override { return 0; }

  std::optional<std::size_t> wrong_triangle;

 private:
  Profile draws_;
  std::optional<ExactTriangles> exact_;
};

Profile SnappedTo(int bits) {
  Profile profile;
  profile.snap.bits = bits;
  return profile;
}

TEST(Fingerprint, IsEmptyOfErrorsForWhatIsExact) {
  for (const FingerprintStep& step : kFingerprintSteps) {
    const Fingerprint print = Of("spans-exact", step);
    EXPECT_EQ(print.drawn.size(), 65'536U);
    EXPECT_EQ(print.Wrong(), 0U) << step.name;
  }
}

// With A right of the diagonal the sample lies left of the edge, where the inside is. On the
// diagonal it lies on the edge, which is the inside's right one, and the outside's left one.
TEST(Fingerprint, IsSplitByTheDiagonalInEveryExactPicture) {
  for (const FingerprintStep& step : kFingerprintSteps) {
    const Fingerprint print = Of("spans-exact", step);
    for (std::size_t j = 0; j < 256; ++j) {
      for (std::size_t i = 0; i < 256; ++i) {
        ASSERT_EQ(print.exact[256 * j + i], i > j ? SampleOwner::kInside : SampleOwner::kOutside)
            << step.name << ' ' << i << ' ' << j;
      }
    }
  }
}

TEST(Fingerprint, ShowsWhatFloat32GetsWrong) {
  const Fingerprint print = Of("f32-direct", kFingerprintSteps[0]);
  EXPECT_EQ(print.Wrong(), 9047U);
  EXPECT_EQ(CountOf(print.drawn, SampleOwner::kBoth), 2965U);
  EXPECT_EQ(CountOf(print.drawn, SampleOwner::kNeither), 3486U);
}

TEST(Fingerprint, ShowsOneWrongPlaceAsOne) {
  for (const std::size_t triangle : {std::size_t{0}, std::size_t{1}, std::size_t{131'071}}) {
    Painter painter({}, {});
    painter.wrong_triangle = triangle;
    FingerprintPlaces places(kFingerprintSteps[2]);
    const Fingerprint print = places.Of(painter);
    EXPECT_EQ(print.Wrong(), 1U);
    EXPECT_NE(print.drawn[triangle / 2], print.exact[triangle / 2]);
  }
}

TEST(Fingerprint, HoldsWhatSnapsToItsOwnModel) {
  FingerprintPlaces places(kFingerprintSteps[1]);
  Painter legal(SnappedTo(8), SnappedTo(8));
  EXPECT_EQ(places.Of(legal).Wrong(), 0U);
  Painter illegal(SnappedTo(8), {});
  EXPECT_GT(places.Of(illegal).Wrong(), 0U);
  Painter beside(SnappedTo(8), SnappedTo(9));
  EXPECT_GT(places.Of(beside).Wrong(), 0U);
}

TEST(Fingerprint, LooksAtTheSameSampleWhereYGrowsUp) {
  Profile up;
  up.y_axis = YAxis::kUp;
  Painter painter(up, up);
  FingerprintPlaces places(kFingerprintSteps[3]);
  const Fingerprint print = places.Of(painter);
  EXPECT_EQ(print.Wrong(), 0U);
  EXPECT_EQ(CountOf(print.exact, SampleOwner::kNeither), 0U);
  EXPECT_EQ(CountOf(print.exact, SampleOwner::kBoth), 0U);
  EXPECT_GT(CountOf(print.exact, SampleOwner::kInside), 30'000U);
}

TEST(Fingerprint, IsMadeOfEveryMethodAndKernelAndEmptyOfErrorsWhereZeroIsProved) {
  FingerprintPlaces places(kFingerprintSteps[2]);
  constexpr std::size_t kEvery = kOneCaseIn;
  std::size_t number = 0;
  std::size_t proved = 0;
  for (const auto& contender : OwnContenders(ContenderChoice::kQuick)) {
    if (number++ % kEvery != 0) continue;
    ASSERT_EQ(places.WhyNot(*contender), std::nullopt) << contender->method().name;
    if (!contender->method().is_proved) continue;
    ++proved;
    EXPECT_EQ(places.Of(*contender).Wrong(), 0U) << contender->method().name;
  }
  EXPECT_GT(proved, 0U);
}

// A whole run draws fingerprints before families, whose targets are of other sizes.
TEST(Fingerprint, LeavesAKernelAbleToDrawTheNextFamily) {
  Scene scene;
  scene.width = scene.height = 48;
  scene.precision = Precision::kFloat32;
  scene.vertices = {{1, 1}, {1, 40}, {40, 40}};
  scene.triangles = {{0, 1, 2}};
  const FamilyInput next = FamilyOf(scene, "");
  FingerprintPlaces places(kFingerprintSteps[2]);
  for (const auto& contender : OwnContenders(ContenderChoice::kQuick)) {
    if (contender->WhyNot(next) || contender->method().name != "kernel-exact") continue;
    places.Of(*contender);
    contender->Load(next);
    std::vector<std::uint8_t> box(std::size_t{48} * 48);
    contender->DrawAlone(0, {0, 0, 48, 48}, box);
    EXPECT_EQ(box[std::size_t{30} * 48 + 10], 1);
    return;
  }
  FAIL() << "no kernel-exact here";
}

}  // namespace
}  // namespace rasterproof::bench
