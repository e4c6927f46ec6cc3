// The frame that all methods of values share: spans, triangle by triangle, pixels along the lanes.
#ifndef RASTERPROOF_BENCH_VALUES_VALUE_FRAME_H_
#define RASTERPROOF_BENCH_VALUES_VALUE_FRAME_H_

#include <cstddef>
#include <cstdint>

#include "bench/values/value_kernels.h"
#include "bench/values/value_policies.h"
#include "library/kernels/value_spans.h"
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
};
constexpr std::size_t kValueKernelCount = sizeof kValueKernels / sizeof kValueKernels[0];

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_BENCH_VALUES_VALUE_FRAME_H_
