// The kernel `exact` into masks beside MaskedOcclusionCulling, by turns, on the families of bench.
//
// usage: culler_cost: scripts/compare_culler builds and runs it
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string_view>
#include <vector>

// It names size_t and includes nothing.
#include <MaskedOcclusionCulling.h>

#include "bench/family.h"
#include "core/clock.h"
#include "library/kernels/kernel.h"

namespace rasterproof::bench {
namespace {

namespace kernels = library::kernels;

constexpr int kTimes = 15;
constexpr std::array<std::string_view, 9> kFamilies{"px5",  "px100", "px1m", "needles", "fan",
                                                    "mesh", "ties",  "far",  "torus"};

struct Destroy {
  void operator()(MaskedOcclusionCulling* culler) const { MaskedOcclusionCulling::Destroy(culler); }
};

// A scene as that library takes it: clip space, y up, w = 1.
class Culler {
 public:
  Culler(const kernels::KernelScene& scene, MaskedOcclusionCulling::Implementation set)
      : culler_(MaskedOcclusionCulling::Create(set)),
        indices_(scene.indices.begin(), scene.indices.end()),
        width_((scene.width + 7) / 8 * 8),
        height_((scene.height + 3) / 4 * 4) {
    culler_->SetResolution(static_cast<unsigned>(width_), static_cast<unsigned>(height_));
    const float half_width = static_cast<float>(width_) / 2;
    const float half_height = static_cast<float>(height_) / 2;
    bool is_inside = true;
    for (const kernels::KernelVertex& v : scene.vertices) {
      const float x = (v.x - half_width) / half_width;
      const float y = (half_height - v.y) / half_height;
      is_inside = is_inside && std::fabs(x) <= 1 && std::fabs(y) <= 1;
      vertices_.insert(vertices_.end(), {x, y, 0, 1});
    }
    planes_ = is_inside ? MaskedOcclusionCulling::CLIP_PLANE_NONE
                        : MaskedOcclusionCulling::CLIP_PLANE_SIDES;
  }
  MaskedOcclusionCulling::Implementation set() const { return culler_->GetImplementation(); }

  void Clear() { culler_->ClearBuffer(); }
  void Draw() {
    culler_->RenderTriangles(vertices_.data(), indices_.data(),
                             static_cast<int>(indices_.size() / 3), nullptr,
                             MaskedOcclusionCulling::BACKFACE_NONE, planes_);
  }
  std::vector<bool> Covered(int width, int height) {
    std::vector<float> depths(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    culler_->ComputePixelDepthBuffer(depths.data(), false);
    std::vector<bool> covered;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        covered.push_back(depths[static_cast<std::size_t>(y * width_ + x)] > 0.5F);
      }
    }
    return covered;
  }

 private:
  std::unique_ptr<MaskedOcclusionCulling, Destroy> culler_;
  std::vector<unsigned> indices_;
  std::vector<float> vertices_;
  int width_;
  int height_;
  MaskedOcclusionCulling::ClipPlanes planes_ = MaskedOcclusionCulling::CLIP_PLANE_NONE;
};

struct Turns {
  double theirs = 1e9;  // least seconds
  double ours = 1e9;
  std::array<double, kTimes> ratios{};  // ours to theirs, in pairs
};

Turns TakeTurns(Culler& culler, const kernels::KernelScene& scene, kernels::Target target,
                kernels::Surface& surface) {
  Turns turns;
  for (double& ratio : turns.ratios) {
    culler.Clear();
    const double theirs = Timed([&] { culler.Draw(); }).wall_seconds;
    surface.Clear();
    const double ours = Timed([&] { kernels::Draw(target, scene, surface); }).wall_seconds;
    turns.theirs = std::min(turns.theirs, theirs);
    turns.ours = std::min(turns.ours, ours);
    ratio = ours / theirs;
  }
  std::ranges::sort(turns.ratios);
  return turns;
}

void Compare(const FamilyInput& family, kernels::Target target,
             MaskedOcclusionCulling::Implementation set) {
  const kernels::KernelScene scene = family.KernelScene();
  Culler culler(scene, set);
  if (culler.set() != set) {
    std::printf("%-8s this machine has no such instructions\n", family.name.c_str());
    return;
  }
  kernels::Surface surface(kernels::Sink::kMask, scene.width, scene.height);
  const Turns turns = TakeTurns(culler, scene, target, surface);
  const std::vector<bool> theirs = culler.Covered(scene.width, scene.height);
  std::size_t differ = 0, covered = 0;
  for (int y = 0; y < scene.height; ++y) {
    for (int x = 0; x < scene.width; ++x) {
      const bool ours = surface.At(x, y) != 0;
      covered += ours ? 1 : 0;
      differ += ours != theirs[static_cast<std::size_t>(y * scene.width + x)] ? 1 : 0;
    }
  }
  const double each = 1e9 / static_cast<double>(scene.indices.size() / 3);
  std::printf("%-8s %-7s %9.1f %9.1f   %.2f (%.2f to %.2f)   %zu of %zu\n", family.name.c_str(),
              kernels::NameOf(target).data(), turns.theirs * each, turns.ours * each,
              turns.ratios[kTimes / 2], turns.ratios[1], turns.ratios[kTimes - 2], differ, covered);
}

void CompareAll() {
  std::printf(
      "ns a triangle, least of %d; ratios of pairs, median and all but the ends; pixels\n"
      "family   set        culler     exact   exact / culler        differ, of covered\n",
      kTimes);
  for (const FamilyKind& kind : FamilyKinds()) {
    if (std::ranges::find(kFamilies, kind.name) == kFamilies.end()) continue;
    const FamilyInput family = MakeFamily(kind, FamilySize::kFull, 1);
    Compare(family, kernels::Target::kAvx2, MaskedOcclusionCulling::AVX2);
    for (const kernels::Target target : kernels::SupportedTargets()) {
      if (target != kernels::Target::kAvx512) continue;
      Compare(family, target, MaskedOcclusionCulling::AVX512);
    }
  }
}

}  // namespace
}  // namespace rasterproof::bench

int main() { rasterproof::bench::CompareAll(); }
