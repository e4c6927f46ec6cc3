#include "bench/fingerprint.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/exact_triangles.h"
#include "core/clock.h"
#include "core/draw_options.h"
#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"

namespace rasterproof::bench {
namespace {

constexpr int kTarget = 32;  // its width and height
// Of what is slow alone every 32nd place along either axis is drawn, then every 16th, 8th and 4th,
// while the next is likely to take no longer than this.
constexpr int kCoarsest = 32;
constexpr int kFinestOfSlow = 4;
constexpr double kMostSeconds = 2;
constexpr int kSamplePixel = 12;
constexpr double kDepth = 0.5;

// The pixel of the sample: rows are counted from the top, whichever way y grows.
Pixel SampleOf(const Profile& model) {
  return {kSamplePixel, model.y_axis == YAxis::kUp ? kTarget - 1 - kSamplePixel : kSamplePixel};
}

// Triangles 2 n and 2 n + 1 are those of place n.
Scene ScenePlaced(double step) {
  constexpr int kHalf = FingerprintPlaces::kSide / 2;
  Scene scene;
  scene.name = "fingerprint";
  scene.width = scene.height = kTarget;
  scene.vertices = {{24.5, 24.5, kDepth}, {2.5, 30.5, kDepth}, {30.5, 2.5, kDepth}};
  for (int j = -kHalf; j < kHalf; ++j) {
    for (int i = -kHalf; i < kHalf; ++i) {
      const auto a = static_cast<std::int32_t>(scene.vertices.size());
      scene.vertices.push_back({0.5 + i * step, 0.5 + j * step, kDepth});
      scene.triangles.push_back({a, 0, 1});
      scene.triangles.push_back({0, a, 2});
    }
  }
  return scene;
}

FamilyInput FamilyPlaced(double step, bool is_clip_space) {
  Scene scene = ScenePlaced(step);
  scene.clip_space = is_clip_space;
  return FamilyOf(std::move(scene), "One end of a shared edge in 256 x 256 places");
}

SampleOwner OwnerOf(bool first, bool second) {
  if (first) return second ? SampleOwner::kBoth : SampleOwner::kInside;
  return second ? SampleOwner::kOutside : SampleOwner::kNeither;
}

}  // namespace

std::uint64_t Fingerprint::Wrong() const {
  std::uint64_t wrong = 0;
  for (std::size_t n = 0; n < drawn.size(); ++n) wrong += drawn[n] != exact[n] ? 1 : 0;
  return wrong;
}

FingerprintPlaces::FingerprintPlaces(const FingerprintStep& step)
    : window_(FamilyPlaced(step.pixels, false)), clip_(FamilyPlaced(step.pixels, true)) {}

std::optional<std::string> FingerprintPlaces::WhyNot(const Contender& contender) const {
  if (const auto why = exact::WhyNotDecided({window_.scene, contender.model()})) return why->what();
  const auto why = contender.WhyNot(window_);
  return why && contender.WhyNot(clip_) ? why : std::nullopt;
}

Fingerprint FingerprintPlaces::Of(Contender& contender) {
  contender.Load(contender.WhyNot(window_) ? clip_ : window_);
  if (!contender.IsSlowAlone()) return Every(1, contender);
  for (int stride = kCoarsest;; stride /= 2) {
    const double begun = WallSeconds();
    Fingerprint print = Every(stride, contender);
    const double of_next = 4 * (WallSeconds() - begun);
    if (stride == kFinestOfSlow || of_next > kMostSeconds) return print;
  }
}

Fingerprint FingerprintPlaces::Every(int stride, Contender& contender) {
  Fingerprint print{.side = kSide / stride, .drawn = {}, .exact = {}};
  const std::vector<SampleOwner>& exact = ExactBy(contender.model());
  std::vector<std::size_t> triangles;
  for (int j = 0; j < kSide; j += stride) {
    for (int i = 0; i < kSide; i += stride) {
      const auto n = static_cast<std::size_t>(j) * kSide + static_cast<std::size_t>(i);
      print.exact.push_back(exact[n]);
      triangles.push_back(2 * n);
      triangles.push_back(2 * n + 1);
    }
  }
  const std::vector<std::uint8_t> covered =
      contender.CoverAlone(triangles, {0, 0, kTarget, kTarget}, SampleOf(contender.model()));
  for (std::size_t n = 0; n < covered.size(); n += 2) {
    print.drawn.push_back(OwnerOf(covered[n] != 0, covered[n + 1] != 0));
  }
  return print;
}

const std::vector<SampleOwner>& FingerprintPlaces::ExactBy(const Profile& model) {
  for (const auto& [known, owners] : exact_) {
    if (SameModel(known, model)) return owners;
  }
  const ExactTriangles triangles(window_.scene, model);
  const Pixel at = SampleOf(model);
  std::vector<SampleOwner> owners;
  for (std::size_t t = 0; t < window_.scene.triangles.size(); t += 2) {
    owners.push_back(OwnerOf(triangles.Covers(t, at.x, at.y), triangles.Covers(t + 1, at.x, at.y)));
  }
  return exact_.emplace_back(model, std::move(owners)).second;
}

}  // namespace rasterproof::bench
