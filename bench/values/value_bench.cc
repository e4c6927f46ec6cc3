#include "bench/values/value_bench.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/paired.h"
#include "bench/values/value_errors.h"
#include "bench/values/value_families.h"
#include "bench/values/value_kernels.h"
#include "core/clock.h"
#include "core/error.h"
#include "library/draw.h"
#include "library/kernels/kernel.h"
#include "library/kernels/kernel_table.h"
#include "library/nearest_value.h"
#include "library/rasterize.h"
#include "reference/value_methods.h"

namespace rasterproof::bench {

std::vector<const ValueKernels*> SupportedValueKernels() {
  std::vector<const ValueKernels*> supported;
#if defined(__x86_64__)
  if (IsSupported(InstructionSet::kAvx512)) supported.push_back(&kAvx512ValueKernels);
  if (IsSupported(InstructionSet::kAvx2)) supported.push_back(&kAvx2ValueKernels);
#endif
  return supported;
}

float NearestValueOf(const ValueTriangle& triangle, int column, int row) {
  library::ValueQuotient q{};
  for (std::size_t k = 0; k < 3; ++k) {
    q.x[k] = triangle.x[k];
    q.y[k] = triangle.y[k];
    q.w[k] = triangle.w[k];
    q.c[k] = triangle.a[k];
    q.e[k] = 1;
  }
  return library::NearestValue(q, column + 0.5, row + 0.5);
}

namespace {

using reference::ValueMethod;

// A method as it is drawn and shown.
struct ValueContender {
  std::string name;
  std::string target;
  bool is_derivative = false;
  bool is_of_window = false;
  ValueBound bound;
  std::string floor;  ///< whose time is taken off
  std::function<void()> draw;
  std::function<float(const ExactValue&)> show;
};

const ValueMethod* MethodNamed(std::string_view name) {
  const auto methods = reference::ValueMethods();
  const auto found = std::ranges::find(methods, name, &ValueMethod::name);
  return found == methods.end() ? nullptr : &*found;
}

// Of the methods that the reference states, by name; "-f64": its double's and a rounding.
void SetBound(const std::string& name, ValueContender& contender) {
  const bool is_double = name.ends_with("-f64");
  const ValueMethod* method =
      MethodNamed(is_double ? std::string_view(name).substr(0, name.size() - 4) : name);
  // A difference is of both pixels' conditions, a stepped value of the span's both ends; and the
  // processor's 12 bits are off by up to 1.5 2^-12, of which nothing is proved.
  contender.bound.is_stated = method != nullptr &&
                              method->target == reference::ValueTarget::kValue &&
                              !name.starts_with("reciprocal-12");
  contender.is_derivative = name.ends_with("-difference");
  if (name == kCorrectlyRounded) {
    contender.bound.is_stated = true;
    contender.bound.ulps = reference::kCorrectlyRoundedUlps;
  }
  if (method == nullptr) return;
  contender.is_of_window = method->space == reference::ValueSpace::kWindow;
  contender.bound.about = static_cast<std::size_t>(method->about);
  contender.bound.conditions = method->conditions[is_double ? 1 : 0];
  if (is_double) {
    contender.bound.unit = 0x1p-53;
    contender.bound.ulps = 0.5;
  }
}

class KernelDrawer {
 public:
  KernelDrawer(const ValueScene& scene, int width)
      : scene_(scene), row_(static_cast<std::size_t>(width) + 64) {}
  void Draw(const ValueKernel& kernel) {
    kernel.fill({scene_.triangles.data(), scene_.runs.data(), scene_.runs.size(), row_.data()});
  }
  float Show(const ValueKernel& kernel, const ExactValue& at) {
    const ValueRun run{0, at.y, at.first_x, at.x + 1};
    kernel.fill({&at.triangle, &run, 1, row_.data()});
    return row_[static_cast<std::size_t>(at.x)];
  }

 private:
  const ValueScene& scene_;
  std::vector<float> row_;
};

void AddKernels(const ValueKernels& kernels, std::string_view prefix, KernelDrawer& drawer,
                std::vector<ValueContender>& list) {
  for (std::size_t k = 0; k < kernels.count; ++k) {
    const ValueKernel& kernel = kernels.kernels[k];
    const std::string name = kernel.name;
    if (!name.starts_with(prefix)) continue;
    ValueContender contender;
    contender.name = name;
    contender.target = kernels.target;
    contender.floor = kValueFloor;
    SetBound(name, contender);
    contender.draw = [&drawer, &kernel] { drawer.Draw(kernel); };
    contender.show = [&drawer, &kernel](const ExactValue& at) { return drawer.Show(kernel, at); };
    list.push_back(std::move(contender));
  }
}

// The library's values of the same spans, onto its planes: coverage is known, and the floor is a
// constant stored there.
class LibraryDrawer {
 public:
  LibraryDrawer(const ValueScene& scene, const ValueFamilyKind& kind, const ValueKernels& kernels)
      : scene_(scene),
        kind_(kind),
        store_(kernels.store),
        values_(static_cast<std::size_t>(kind.width) * static_cast<std::size_t>(kind.height)),
        dx_(values_.size()),
        dy_(values_.size()) {
    for (const ValueRun& run : scene.runs) {
      spans_.push_back({run.triangle, true, run.row, run.x0, run.x1});
    }
  }

  void Floor() {
    drawn_ = {};
    const auto on_span = [](const void* state, const library::kernels::KernelSpan& span) {
      LibraryDrawer& self = **static_cast<LibraryDrawer* const*>(state);
      const std::size_t row =
          static_cast<std::size_t>(span.row) * static_cast<std::size_t>(self.kind_.width);
      self.store_(self.values_.data() + row + span.x0, span.x1 - span.x0, 1.0F);
    };
    LibraryDrawer* const state = this;
    ForEachSpan(on_span, static_cast<const void*>(&state));
  }
  void Draw(RasterRounding rounding, bool with_derivatives) {
    drawn_ = {};
    library::DrawValues(scene_.Mesh(), In(scene_.numbers, rounding, with_derivatives),
                        library::kernels::SupportedTargets().back(),
                        [&](auto* on_span, const void* state) { ForEachSpan(on_span, state); });
  }
  // Pixels of one triangle are asked for one after the other: it is drawn once.
  float Show(const ExactValue& at, RasterRounding rounding, bool derivative) {
    const Drawn drawn{at.index, rounding, derivative};
    if (drawn != drawn_) {
      const std::size_t first = std::size_t{3} * at.index;
      RasterMesh mesh = scene_.Mesh();
      mesh.indices = mesh.indices.subspan(first, 3);
      RasterizeValues(mesh, In(scene_.numbers, rounding, derivative));
      drawn_ = drawn;
    }
    const std::size_t pixel =
        static_cast<std::size_t>(at.y) * static_cast<std::size_t>(kind_.width) +
        static_cast<std::size_t>(at.x);
    return derivative ? dx_[pixel] : values_[pixel];
  }

 private:
  RasterValues In(std::span<const float> numbers, RasterRounding rounding, bool derivatives) {
    return {.numbers = numbers,
            .channels = 1,
            .interpolation = RasterInterpolation::kPerspective,
            .rounding = rounding,
            .width = kind_.width,
            .height = kind_.height,
            .pitch = static_cast<std::size_t>(kind_.width),
            .values = values_,
            .dx = derivatives ? std::span(dx_) : std::span<float>(),
            .dy = derivatives ? std::span(dy_) : std::span<float>()};
  }

  struct Drawn {
    std::uint32_t triangle = kNoTriangle;
    RasterRounding rounding = RasterRounding::kFast;
    bool derivative = false;
    friend bool operator==(const Drawn&, const Drawn&) = default;
  };

  void ForEachSpan(void (*on_span)(const void*, const library::kernels::KernelSpan&),
                   const void* state) const {
    for (const library::kernels::KernelSpan& span : spans_) on_span(state, span);
  }

  const ValueScene& scene_;
  const ValueFamilyKind& kind_;
  void (*store_)(float* to, int count, float value);
  std::vector<library::kernels::KernelSpan> spans_;
  std::vector<float> values_, dx_, dy_;
  Drawn drawn_;
};

constexpr const char* kLibraryFloor = "library-constant";

void AddLibrary(LibraryDrawer& drawer, const std::string& target,
                std::vector<ValueContender>& list) {
  const auto add = [&](const char* name, RasterRounding rounding, bool derivative,
                       const ValueBound& bound) {
    ValueContender contender;
    contender.name = name;
    contender.target = target;
    contender.is_derivative = derivative;
    contender.bound = bound;
    contender.floor = kLibraryFloor;
    contender.draw = [&drawer, rounding, derivative] { drawer.Draw(rounding, derivative); };
    contender.show = [&drawer, rounding, derivative](const ExactValue& at) {
      return drawer.Show(at, rounding, derivative);
    };
    list.push_back(std::move(contender));
  };
  ValueContender floor;
  floor.name = kLibraryFloor;
  floor.draw = [&drawer] { drawer.Floor(); };
  list.push_back(std::move(floor));
  ValueBound value;
  value.conditions = kValueConditions;
  ValueBound derivative;
  derivative.conditions = kDerivativeConditions;
  derivative.is_of_derivative = true;
  ValueBound nearest;
  nearest.ulps = reference::kCorrectlyRoundedUlps;
  add("library", RasterRounding::kFast, false, value);
  add("library-derivatives", RasterRounding::kFast, true, derivative);
  add("library-nearest", RasterRounding::kNearest, false, nearest);
}

// Seconds of each contender, round by round: as many draws as take a millisecond.
std::vector<std::vector<double>> Times(const std::vector<ValueContender>& list, int rounds) {
  std::vector<std::vector<double>> seconds(list.size());
  std::vector<int> repeats(list.size(), 1);
  for (std::size_t k = 0; k < list.size(); ++k) {
    list[k].draw();
    const double start = ThreadSeconds();
    list[k].draw();
    repeats[k] = 1 + static_cast<int>(1e-3 / std::max(1e-6, ThreadSeconds() - start));
  }
  for (int round = 0; round < rounds; ++round) {
    for (const std::size_t k : RoundOrder(list.size(), static_cast<std::size_t>(round))) {
      const double start = ThreadSeconds();
      for (int n = 0; n < repeats[k]; ++n) list[k].draw();
      seconds[k].push_back((ThreadSeconds() - start) / repeats[k]);
    }
  }
  return seconds;
}

// Pixels spread over the covered ones, and what is true of them.
std::vector<ExactValue> Judged(const ValueScene& scene, std::size_t count) {
  std::vector<ExactValue> judged;
  const std::uint64_t step = std::max<std::uint64_t>(1, scene.covered / count);
  std::uint64_t next = step / 2;
  std::uint64_t before = 0;
  for (const ValueRun& run : scene.runs) {
    const auto width = static_cast<std::uint64_t>(run.x1 - run.x0);
    for (; next < before + width; next += step) {
      const int x = run.x0 + static_cast<int>(next - before);
      if (auto exact = ExactValueAt(scene.triangles[run.triangle], x, run.row)) {
        exact->index = run.triangle;
        exact->first_x = run.x0;
        judged.push_back(std::move(*exact));
      }
    }
    before += width;
  }
  return judged;
}

void SetTimes(const std::vector<double>& seconds, const std::vector<double>& floor,
              std::uint64_t pixels, ValueBenchRow& row) {
  std::vector<double> ns;
  for (std::size_t k = 0; k < seconds.size(); ++k) {
    ns.push_back(1e9 * (seconds[k] - floor[k]) / static_cast<double>(pixels));
  }
  const Interval interval = MedianInterval(std::move(ns));
  row.ns_low = interval.low;
  row.ns = interval.median;
  row.ns_high = interval.high;
}

bool IsFloor(const ValueContender& contender) {
  return contender.name == kValueFloor || contender.name == kLibraryFloor;
}

// What draws a scene.
class Drawers {
 public:
  Drawers(const ValueScene& scene, const ValueFamilyKind& kind,
          const std::vector<const ValueKernels*>& kernels)
      : kernels_(scene, kind.width), library_(scene, kind, *kernels.front()) {
    for (const ValueKernels* of : kernels) {
      AddKernels(*of, of == kernels.front() ? "" : "reciprocal", kernels_, list_);
    }
    AddLibrary(library_, kernels.front()->target, list_);
    if (kind.is_clip_space) std::erase_if(list_, &IsOfWindow);
  }
  Drawers(const Drawers&) = delete;
  Drawers& operator=(const Drawers&) = delete;

  const std::vector<ValueContender>& list() const { return list_; }

 private:
  static bool IsOfWindow(const ValueContender& contender) { return contender.is_of_window; }

  KernelDrawer kernels_;
  LibraryDrawer library_;
  std::vector<ValueContender> list_;
};

void RunValueFamily(const ValueFamilyKind& kind, const ValueBenchOptions& options,
                    const std::vector<const ValueKernels*>& kernels, BenchResult& result) {
  const ValueScene scene = MakeValueScene(kind, options.covered, options.seed);
  const Drawers drawers(scene, kind, kernels);
  const std::vector<ValueContender>& list = drawers.list();
  const std::vector<std::vector<double>> seconds = Times(list, options.rounds);
  const std::vector<ExactValue> judged = Judged(scene, options.judged);
  const auto floor_of = [&](const std::string& name) -> const std::vector<double>& {
    const auto found = std::ranges::find(list, name, &ValueContender::name);
    return seconds[static_cast<std::size_t>(found - list.begin())];
  };
  ValueBenchFamily family{std::string(kind.name),
                          std::string(kind.summary),
                          kind.is_clip_space,
                          scene.triangles.size(),
                          scene.covered,
                          judged.size(),
                          0};
  family.floor_ns =
      1e9 * MedianInterval(floor_of(kValueFloor)).median / static_cast<double>(scene.covered);
  result.value_families.push_back(family);
  for (std::size_t k = 0; k < list.size(); ++k) {
    const ValueContender& contender = list[k];
    if (IsFloor(contender)) continue;
    ValueErrors errors(contender.is_derivative, contender.bound);
    for (const ExactValue& exact : judged) {
      errors.Add(exact, contender.show(exact));
    }
    ValueBenchRow row;
    row.family = static_cast<std::uint32_t>(result.value_families.size() - 1);
    row.method = contender.name;
    row.target = contender.target;
    row.shows = contender.is_derivative ? "d/dx" : "value";
    SetTimes(seconds[k], floor_of(contender.floor), scene.covered, row);
    errors.WriteTo(row);
    result.value_rows.push_back(std::move(row));
  }
}

// The largest error of each contender at one value of a parameter, in texels; infinity of a NaN.
void AddLimitsAt(const ValueParameter& parameter, int exponent, std::uint64_t seed,
                 const std::vector<const ValueKernels*>& kernels,
                 std::vector<ValueBenchLimit>& limits) {
  constexpr std::uint64_t kCovered = 1'000;
  constexpr std::size_t kJudged = 200;
  constexpr double kMostTexels = 0.5;
  ValueFamilyKind kind = parameter.kind;
  kind.value = exponent;
  const ValueScene scene = MakeValueScene(kind, kCovered, seed);
  const Drawers drawers(scene, kind, kernels);
  const std::vector<ExactValue> judged = Judged(scene, kJudged);
  for (const ValueContender& contender : drawers.list()) {
    if (IsFloor(contender) || contender.is_derivative) continue;
    auto limit = std::ranges::find_if(limits, [&](const ValueBenchLimit& one) {
      return one.parameter == kind.name && one.method == contender.name &&
             one.target == contender.target;
    });
    if (limit == limits.end()) {
      limit = limits.insert(limit, {.parameter = std::string(kind.name),
                                    .method = contender.name,
                                    .target = contender.target});
    }
    if (!std::isnan(limit->fails_at)) continue;
    ValueErrors errors(false, contender.bound);
    for (const ExactValue& exact : judged) errors.Add(exact, contender.show(exact));
    ValueBenchRow row;
    errors.WriteTo(row);
    const bool holds = row.not_finite == 0 && row.texels <= kMostTexels;
    (holds ? limit->held_to : limit->fails_at) = exponent;
  }
}

}  // namespace

void RunValues(const ValueBenchOptions& options, BenchResult& result) {
  for (const std::string& name : options.families) {
    if (std::ranges::find(ValueFamilyKinds(), name, &ValueFamilyKind::name) !=
        ValueFamilyKinds().end()) {
      continue;
    }
    std::string known;
    for (const ValueFamilyKind& kind : ValueFamilyKinds()) {
      known += (known.empty() ? "" : ", ") + std::string(kind.name);
    }
    throw InputError("--family " + name, "there is no such family of values", "choose of " + known);
  }
  const std::vector<const ValueKernels*> kernels = SupportedValueKernels();
  if (kernels.empty()) {
    throw InputError("--values", "this machine has no AVX2", "run it on one that has");
  }
  for (const ValueFamilyKind& kind : ValueFamilyKinds()) {
    const bool is_asked = options.families.empty() ||
                          std::ranges::find(options.families, kind.name) != options.families.end();
    if (!is_asked) continue;
    if (options.progress) options.progress(std::string(kind.name));
    RunValueFamily(kind, options, kernels, result);
  }
  if (!options.families.empty()) return;
  for (const ValueParameter& parameter : ValueParameters()) {
    if (options.progress) options.progress(std::string(parameter.kind.name));
    for (int exponent = parameter.first; exponent <= parameter.last; ++exponent) {
      AddLimitsAt(parameter, exponent, options.seed, kernels, result.value_limits);
    }
  }
}

}  // namespace rasterproof::bench
