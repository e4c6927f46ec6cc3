#include "bench/kernels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/kernel_scenes.h"
#include "bench/thread_seconds.h"
#include "core/coverage.h"
#include "core/fragments.h"
#include "core/kernel_bench_result.h"
#include "core/scene.h"
#include "reference/kernels/kernel.h"
#include "reference/method.h"
#include "reference/rasterize.h"

namespace rasterproof::bench {
namespace {

namespace kernels = reference::kernels;

Times TimesOf(std::vector<double> seconds) {
  std::ranges::sort(seconds);
  const auto at = [&](double share) {
    return seconds[static_cast<std::size_t>(share * static_cast<double>(seconds.size() - 1))];
  };
  return {.median = at(0.5), .least = seconds.front(), .spread = at(0.75) - at(0.25)};
}

// The scene whose last triangle is everywhere the nearest one: triangle i lies at z = -i.
Scene LastIsNearest(const Scene& scene) {
  Scene flat;
  flat.name = scene.name;
  flat.width = scene.width;
  flat.height = scene.height;
  for (const Triangle& triangle : scene.triangles) {
    const auto first = static_cast<std::int32_t>(flat.vertices.size());
    for (Vertex v : Corners(scene, triangle)) {
      v.z = -static_cast<double>(flat.triangles.size());
      flat.vertices.push_back(v);
    }
    flat.triangles.push_back({first, first + 1, first + 2});
  }
  return flat;
}

// Not by the kernel that is measured.
const reference::Method& ByRows() {
  static const reference::Method method = [] {
    reference::Method rows = *reference::FindMethod("spans-exact");
    rows.whole = nullptr;
    return rows;
  }();
  return method;
}

std::uint64_t Apart(std::uint64_t a, std::uint64_t b) { return a > b ? a - b : b - a; }

// The exact answers for one scene: counts, and the last triangle of each pixel when asked for.
class ExactSurface {
 public:
  explicit ExactSurface(const KernelInput& input)
      : scene_(SceneFrom(input)), counts_(input.width, input.height) {
    reference::Rasterize(scene_, ByRows(), {}, counts_);
  }

  const Scene& scene() const { return scene_; }

  std::uint64_t Covered() const {
    std::uint64_t covered = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) covered += counts_.Count(i);
    return covered;
  }

  std::uint64_t Wrong(const CoverageCounts& drawn, CoverageKind kind) const {
    std::uint64_t wrong = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      if (kind == CoverageKind::kFacingCounts) {
        wrong += Apart(drawn.front[i], counts_.front[i]) + Apart(drawn.back[i], counts_.back[i]);
      } else if (kind == CoverageKind::kCounts) {
        wrong += Apart(drawn.front[i], counts_.Count(i));
      } else {
        wrong += (drawn.front[i] > 0) != (counts_.Count(i) > 0) ? 1 : 0;
      }
    }
    return wrong;
  }

  std::uint64_t Wrong(const kernels::Surface& surface) {
    if (surface.sink() == kernels::Sink::kId && last_.empty()) {
      last_ = reference::RasterizeFragments(LastIsNearest(scene_), ByRows(), {}, {}).triangle;
    }
    std::uint64_t wrong = 0;
    for (int y = 0; y < surface.height(); ++y) {
      for (int x = 0; x < surface.width(); ++x) {
        wrong += WrongAt(surface.sink(), counts_.Index(x, y), surface.At(x, y));
      }
    }
    return wrong;
  }

 private:
  std::uint64_t WrongAt(kernels::Sink sink, std::size_t index, std::uint64_t found) const {
    const std::uint64_t count = counts_.Count(index);
    switch (sink) {
      case kernels::Sink::kCount8:
        return Apart(found, std::min<std::uint64_t>(count, 255));
      case kernels::Sink::kFacing:
        return Apart(found & 0xffffffff, counts_.front[index]) +
               Apart(found >> 32, counts_.back[index]);
      case kernels::Sink::kMask:
        return Apart(found, count > 0 ? 1 : 0);
      case kernels::Sink::kId:
        return static_cast<std::uint32_t>(last_[index]) != found ? 1 : 0;
      case kernels::Sink::kDepth: {
        const bool is_drawn = found != kInfinityBits;
        return is_drawn != (count > 0) ? 1 : 0;
      }
    }
    return 0;
  }

  static constexpr std::uint64_t kInfinityBits = 0x7f800000;

  Scene scene_;
  CoverageCounts counts_;
  std::vector<std::int32_t> last_;  // -1 is Surface::kNoTriangle
};

// A kernel that is measured.
struct Measured {
  kernels::Sink sink;
  kernels::KernelMethod method;
  kernels::Target target;
  std::vector<double> seconds;
};

std::vector<Measured> AllOf(const KernelBenchOptions& options, kernels::Sink sink) {
  std::vector<Measured> all;
  for (const kernels::KernelMethod method : options.methods) {
    if (!kernels::Draws(method, sink)) continue;
    for (const kernels::Target target : options.targets) all.push_back({sink, method, target, {}});
  }
  return all;
}

double SecondsOf(const Rival& rival, const Scene& scene, CoverageCounts& counts) {
  counts = CoverageCounts(scene.width, scene.height);
  const double start = ThreadSeconds();
  rival.draw(scene, counts);
  return ThreadSeconds() - start;
}

KernelBenchRow BenchRival(const Rival& rival, const ExactSurface& exact, int repetitions) {
  Scene empty = exact.scene();
  empty.triangles.clear();
  CoverageCounts counts;
  std::vector<double> seconds;
  std::vector<double> empty_seconds;
  std::uint64_t wrong = 0;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    empty_seconds.push_back(SecondsOf(rival, empty, counts));
    seconds.push_back(SecondsOf(rival, exact.scene(), counts));
    if (repetition == 0) wrong = exact.Wrong(counts, rival.coverage);
  }
  const double without = TimesOf(std::move(empty_seconds)).least;
  for (double& second : seconds) second = std::max(0.0, second - without);
  return {.scene = exact.scene().name,
          .sink = std::string(NameOf(kernels::Sink::kFacing)),
          .method = rival.name,
          .target = "-",
          .times = TimesOf(std::move(seconds)),
          .wrong = wrong};
}

}  // namespace

Rival RowsRival() {
  return {.name = "rows",
          .coverage = CoverageKind::kFacingCounts,
          .draw = [](const Scene& scene, CoverageCounts& counts) {
            reference::Rasterize(scene, ByRows(), {}, counts);
          }};
}

void BenchKernelScene(const KernelInput& input, const KernelBenchOptions& options,
                      KernelBenchResult& result) {
  ExactSurface exact(input);
  result.scenes.push_back({input.name, input.summary, input.triangles(), exact.Covered()});
  for (const kernels::Sink sink : options.sinks) {
    if (options.progress) options.progress(input.name + " " + std::string(NameOf(sink)));
    std::vector<Measured> all = AllOf(options, sink);
    std::vector<std::optional<std::uint64_t>> wrong(kernels::kKernelMethods.size());
    kernels::Surface surface(sink, input.width, input.height);
    for (int repetition = 0; repetition < options.repetitions; ++repetition) {
      for (Measured& measured : all) {
        surface.Clear();
        const double start = ThreadSeconds();
        kernels::Draw(measured.method, measured.target, input.View(), surface);
        measured.seconds.push_back(ThreadSeconds() - start);
        // The same bits by every target: tests/reference/kernels_test.cc.
        auto& found = wrong[static_cast<std::size_t>(measured.method)];
        if (!found) found = exact.Wrong(surface);
      }
    }
    for (Measured& measured : all) {
      result.rows.push_back({.scene = input.name,
                             .sink = std::string(NameOf(sink)),
                             .method = std::string(NameOf(measured.method)),
                             .target = std::string(NameOf(measured.target)),
                             .times = TimesOf(std::move(measured.seconds)),
                             .wrong = *wrong[static_cast<std::size_t>(measured.method)]});
    }
    if (sink != kernels::Sink::kFacing) continue;
    for (const Rival& rival : options.rivals) {
      if (options.progress) options.progress(input.name + " " + rival.name);
      result.rows.push_back(BenchRival(rival, exact, options.repetitions));
      result.rows.back().scene = input.name;
    }
  }
}

void BenchKernelLimits(const KernelBenchOptions& options, KernelBenchResult& result) {
  constexpr int kPasses = 20;
  for (const kernels::Sink sink : options.sinks) {
    if (options.progress) options.progress("store limit " + std::string(NameOf(sink)));
    kernels::Surface surface(sink, result.width, result.height);
    std::vector<std::vector<double>> seconds(options.targets.size());
    for (int repetition = 0; repetition < options.repetitions; ++repetition) {
      for (std::size_t i = 0; i < options.targets.size(); ++i) {
        const double start = ThreadSeconds();
        for (int pass = 0; pass < kPasses; ++pass) kernels::Fill(options.targets[i], surface);
        seconds[i].push_back((ThreadSeconds() - start) / kPasses);
      }
    }
    for (std::size_t i = 0; i < options.targets.size(); ++i) {
      result.limits.push_back({std::string(NameOf(sink)), std::string(NameOf(options.targets[i])),
                               TimesOf(std::move(seconds[i]))});
    }
  }
}

}  // namespace rasterproof::bench
