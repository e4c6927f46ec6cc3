// How long square coverage takes, as a ratio to point coverage of the same triangles in this run.
//
// usage: square_ratio
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <string_view>

#include "core/clock.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/square_presets.h"
#include "exact/coverage.h"
#include "exact/square_coverage.h"

namespace rasterproof {
namespace {

constexpr int kSide = 1024;
constexpr int kTimes = 7;

// Triangles about `across` pixels wide: enough that the target's own memory is a small part.
Scene Triangles(int across) {
  std::mt19937_64 bits(103);
  const auto unit = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
  Scene scene;
  scene.width = scene.height = kSide;
  const int count = std::clamp(kSide * kSide / across, 1000, 100000);
  for (int t = 0; t < count; ++t) {
    const double x = unit() * kSide;
    const double y = unit() * kSide;
    const auto first = static_cast<std::int32_t>(scene.vertices.size());
    for (int k = 0; k < 3; ++k) {
      const auto near = [&](double c) {
        return double{static_cast<float>(c + (unit() - 0.5) * across)};
      };
      scene.vertices.push_back({near(x), near(y)});
    }
    scene.triangles.push_back({first, first + 1, first + 2});
  }
  return scene;
}

// The median of pairs that ran one after the other, less what a target without triangles takes.
double Ratio(const Scene& scene, const Profile& squares, const Profile& points, bool must) {
  Scene empty = scene;
  empty.triangles.clear();
  std::array<double, kTimes> ratios{};
  for (double& ratio : ratios) {
    const double of_target = Timed([&] { exact::Coverage(empty, points); }).wall_seconds;
    const double of_points = Timed([&] { exact::Coverage(scene, points); }).wall_seconds;
    const auto cover_squares = [&] {
      if (must) {
        exact::MustCover({scene, squares});
      } else {
        exact::MayCover({scene, squares});
      }
    };
    const double of_squares = Timed(cover_squares).wall_seconds;
    ratio = (of_squares - of_target) / (of_points - of_target);
  }
  std::ranges::sort(ratios);
  return ratios[kTimes / 2];
}

int Main() {
  for (const int across : {8, 64, 1024}) {
    const Scene scene = Triangles(across);
    std::printf("%zu triangles of %d pixels, %d x %d\n", scene.triangles.size(), across, kSide,
                kSide);
    for (const SquarePresetInfo& preset : kSquarePresets) {
      const Profile squares = *PresetProfile(preset.name);
      Profile points = squares;
      points.squares.reset();
      points.contract = Contract::kSampleExact;
      points.freedom = {};
      for (const bool must : {true, false}) {
        if (!(must ? squares.squares->must : squares.squares->may)) continue;
        std::printf("  %-21s %-4s %.2f\n", std::string(preset.name).c_str(), must ? "must" : "may",
                    Ratio(scene, squares, points, must));
      }
    }
  }
  return 0;
}

}  // namespace
}  // namespace rasterproof

int main() { return rasterproof::Main(); }
