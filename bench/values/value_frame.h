// The frame that all methods of values share: spans, triangle by triangle, pixels along the lanes.
#ifndef RASTERPROOF_BENCH_VALUES_VALUE_FRAME_H_
#define RASTERPROOF_BENCH_VALUES_VALUE_FRAME_H_

#include <cstddef>
#include <cstdint>

#include "bench/values/value_kernels.h"
#include "bench/values/value_policies.h"
#include "library/kernels/nearest_spans.h"
#include "library/kernels/value_set_up.h"
#include "library/kernels/value_spans.h"
#include "library/kernels/value_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

using bench::ValueFrame;
using bench::ValueKernel;
using bench::ValueRun;

HWY_INLINE void StoreValues(DF d, VF v, float* p, int n) { StoreFirst(d, v, p, n); }
HWY_INLINE void StoreValues(DD, VD v, float* p, int n) {
  StoreFirst(DDF(), hn::DemoteTo(DDF(), v), p, n);
}

// Calls fill(run) of each, its triangle and row set up.
template <class Policy, class Fill>
HWY_INLINE void ForEachRun(const ValueFrame& frame, Policy& policy, const Fill& fill) {
  using T = typename Policy::T;
  std::uint32_t triangle = ~std::uint32_t{0};
  for (std::size_t i = 0; i < frame.count; ++i) {
    const ValueRun& run = frame.runs[i];
    if (run.triangle != triangle) {
      triangle = run.triangle;
      policy.SetUp(frame.triangles[triangle]);
    }
    policy.Row(static_cast<T>(run.row) + T(0.5));
    fill(run);
  }
}

template <class Policy>
void Walk(const ValueFrame& frame) {
  using D = typename Policy::D;
  using T = typename Policy::T;
  const D d;
  const auto first = hn::Iota(d, T(0.5));
  Policy policy{};
  ForEachRun(frame, policy, [&](const ValueRun& run) {
    for (int x = run.x0; x < run.x1; x += kLanesOf<D>) {
      const auto centres = hn::Add(hn::Set(d, static_cast<T>(x)), first);
      StoreValues(d, policy.At(centres), frame.row + x, run.x1 - x);
    }
  });
}

// A value after another: each is the one before and the step.
template <class T>
void WalkSteps(const ValueFrame& frame) {
  VertexPlanePolicy<hn::CappedTag<T, 1>> policy{};
  ForEachRun(frame, policy, [&](const ValueRun& run) {
    const T along = policy.a * ((static_cast<T>(run.x0) + T(0.5)) - policy.x0);
    T value = policy.a0 + (along + policy.row);
    for (int x = run.x0; x < run.x1; ++x) {
      frame.row[x] = static_cast<float>(value);
      value += policy.a;
    }
  });
}

// What the library does with a channel of a triangle.
class NearestFill {
 public:
  HWY_INLINE void SetUp(const ValueTriangle& t, const ValueRun& first) {
    triangle_ = &t;
    for (int k = 0; k < 3; ++k) {
      corners_.x[k] = double{t.x[k]};
      corners_.y[k] = double{t.y[k]};
      corners_.w[k] = double{t.w[k]};
    }
    MoveCorners(first.x0, first.row, corners_);
    SetUpCorners<true>(true, corners_);
    n_ = {};
    const double a[3] = {double{t.a[0]}, double{t.a[1]}, double{t.a[2]}};
    for (int k = 0; k < 3; ++k) AddLine<true>(corners_.beta[k], a[k], n_);
    BoundDenominator(true, corners_);
    quick_ = QuickPlacesOf(corners_, n_, a);
  }
  HWY_INLINE void Fill(const ValueRun& run, float* value) const {
    const ValueTriangle* const triangle = triangle_;
    const int left = corners_.left;
    const int row = run.row;
    const auto decide = [triangle, left, row](int x) {
      return NearestValueOf(*triangle, left + x, row);
    };
    const LocalSpan at(corners_, run.row, run.x0, run.x1);
    const NearestLines lines{&n_, &corners_.d, corners_.r};
    if (corners_.r != 0) {
      DrawNearest<Divided::kByNumber>(lines, quick_, at, nullptr, value, decide);
    } else {
      DrawNearest<Divided::kByLine>(lines, quick_, at, nullptr, value, decide);
    }
  }

 private:
  const ValueTriangle* triangle_ = nullptr;
  ValueSetUp corners_ = {};
  ReachLine n_ = {};
  int quick_ = 0;
};

inline void WalkNearest(const ValueFrame& frame) {
  NearestFill fill;
  std::uint32_t triangle = ~std::uint32_t{0};
  for (std::size_t i = 0; i < frame.count; ++i) {
    const ValueRun& run = frame.runs[i];
    if (run.triangle != triangle) fill.SetUp(frame.triangles[run.triangle], run);
    triangle = run.triangle;
    fill.Fill(run, frame.row + run.x0);
  }
}

inline void StoreOne(float* to, int count, float value) { FillRow(to, count, value); }

#if HWY_TARGET <= HWY_AVX3
#define RASTERPROOF_RECIPROCAL "reciprocal-14"
#else
#define RASTERPROOF_RECIPROCAL "reciprocal-12"
#endif

constexpr ValueKernel kValueKernels[] = {
    {bench::kValueFloor, &Walk<ConstantPolicy<DF>>},
    {"edge-products", &Walk<EdgeProductsPolicy<DF>>},
    {"differences", &Walk<DifferencesPolicy<DF, PlainForm>>},
    {"differences-fma", &Walk<DifferencesPolicy<DF, FusedForm>>},
    {"origin-plane", &Walk<OriginPlanePolicy<DF>>},
    {"vertex-plane", &Walk<VertexPlanePolicy<DF>>},
    {"stepped", &WalkSteps<float>},
    {"perspective-planes", &Walk<PerspectivePlanesPolicy<DF, PlainForm>>},
    {"perspective-planes-fma", &Walk<PerspectivePlanesPolicy<DF, FusedForm>>},
    {"inverse-matrix", &Walk<InverseMatrixPolicy<DF, ByDivision>>},
    {"perspective-weights", &Walk<PerspectiveWeightsPolicy<DF>>},
    {RASTERPROOF_RECIPROCAL, &Walk<InverseMatrixPolicy<DF, ByEstimate<0>>>},
    {RASTERPROOF_RECIPROCAL "-newton", &Walk<InverseMatrixPolicy<DF, ByEstimate<1>>>},
    {RASTERPROOF_RECIPROCAL "-newton-2", &Walk<InverseMatrixPolicy<DF, ByEstimate<2>>>},
    {"quad-difference", &Walk<QuadDifferencePolicy<DifferencesPolicy<DF, PlainForm>>>},
    {"perspective-difference", &Walk<QuadDifferencePolicy<PerspectivePlanesPolicy<DF, PlainForm>>>},
    {"differences-f64", &Walk<DifferencesPolicy<DD, PlainForm>>},
    {"inverse-matrix-f64", &Walk<InverseMatrixPolicy<DD, ByDivision>>},
    {bench::kCorrectlyRounded, &WalkNearest},
};
constexpr std::size_t kValueKernelCount = sizeof kValueKernels / sizeof kValueKernels[0];

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_BENCH_VALUES_VALUE_FRAME_H_
