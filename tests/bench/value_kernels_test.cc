// The kernels of values, bit by bit what reference/value_methods.h defines, by every instruction
// set; and that the bench measures what it says.
#include "bench/values/value_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bench/values/value_bench.h"
#include "bench/values/value_errors.h"
#include "bench/values/value_families.h"
#include "core/bench_result.h"
#include "core/error.h"
#include "reference/value_methods.h"
#include "tests/share.h"

namespace rasterproof::bench {
namespace {

template <class T>
reference::ValueTask<T> TaskAt(const ValueTriangle& t, int x, int y, int steps) {
  reference::ValueTask<T> task;
  for (std::size_t k = 0; k < 3; ++k) {
    task.v[k] = {t.x[k], t.y[k], t.w[k]};
    task.a[k] = t.a[k];
  }
  task.x = static_cast<T>(x - steps) + T(0.5);
  task.y = static_cast<T>(y) + T(0.5);
  task.steps = steps;
  return task;
}

const reference::ValueMethod* Definition(std::string_view name) {
  const auto methods = reference::ValueMethods();
  const auto found = std::ranges::find(methods, name, &reference::ValueMethod::name);
  return found == methods.end() ? nullptr : &*found;
}

// What a kernel of this name should show, by the reference.
float DefinedValue(std::string_view name, const ValueTriangle& t, const ValueRun& run, int x) {
  if (name == kValueFloor) return t.a[0];
  const int steps = name == "stepped" ? x - run.x0 : 0;
  if (name.ends_with("-f64")) {
    name.remove_suffix(4);
    const auto task = TaskAt<double>(t, x, run.row, steps);
    return static_cast<float>(Definition(name)->float64(task));
  }
  const auto task = TaskAt<float>(t, x, run.row, steps);
  if (name == "perspective-difference") {
    const auto at = Definition("perspective-planes")->float32;
    return at(TaskAt<float>(t, x + 1, run.row, 0)) - at(task);
  }
  return Definition(name)->float32(task);
}

bool IsOfWindow(std::string_view name) {
  const std::string_view method = name.ends_with("-f64") ? name.substr(0, name.size() - 4) : name;
  const auto* const definition = Definition(method);
  return definition != nullptr && definition->space == reference::ValueSpace::kWindow;
}

// NaN of any kind is one.
bool IsSame(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}

void ExpectDefined(const ValueKernels& kernels, const ValueFamilyKind& kind) {
  const ValueScene scene = MakeValueScene(kind, 6'000, 3);
  ASSERT_GE(scene.covered, 3'000U) << kind.name;
  std::vector<float> row(static_cast<std::size_t>(kind.width) + 64);
  for (std::size_t k = 0; k < kernels.count; ++k) {
    const ValueKernel& kernel = kernels.kernels[k];
    const std::string_view name = kernel.name;
    if (name.starts_with("reciprocal") || (kind.is_clip_space && IsOfWindow(name))) continue;
    for (const ValueRun& run : scene.runs) {
      kernel.fill({scene.triangles.data(), &run, 1, row.data()});
      for (int x = run.x0; x < run.x1; ++x) {
        const float expected = DefinedValue(name, scene.triangles[run.triangle], run, x);
        ASSERT_TRUE(IsSame(row[static_cast<std::size_t>(x)], expected))
            << kernels.target << " " << name << " " << kind.name << ": "
            << row[static_cast<std::size_t>(x)] << ", not " << expected;
      }
    }
  }
}

TEST(ValueKernels, AreTheReferencesMethodsToTheBit) {
  for (const ValueKernels* kernels : SupportedValueKernels()) {
    for (const ValueFamilyKind& kind : ValueFamilyKinds()) ExpectDefined(*kernels, kind);
  }
}

TEST(ValueKernels, WriteTheirSpanAndNothingElse) {
  const ValueTriangle t{{0, 200, 0}, {0, 0, 200}, {1, 1, 1}, {1, 2, 3}};
  for (const ValueKernels* kernels : SupportedValueKernels()) {
    for (std::size_t k = 0; k < kernels->count; ++k) {
      std::vector<float> row(256, -7);
      const ValueRun run{0, 3, 5, 42};
      kernels->kernels[k].fill({&t, &run, 1, row.data()});
      for (int x = 0; x < 256; ++x) {
        EXPECT_EQ(row[static_cast<std::size_t>(x)] == -7, x < 5 || x >= 42)
            << kernels->kernels[k].name;
      }
    }
  }
}

TEST(ValueBench, HoldsEveryMethodToItsBound) {
  if (SupportedValueKernels().empty()) GTEST_SKIP() << "no AVX2";
  ValueBenchOptions options;
  options.covered = kOneCaseIn > 1 ? 1'000 : 4'000;
  options.judged = 150;
  options.rounds = kOneCaseIn > 1 ? 1 : 2;
  BenchResult result;
  RunValues(options, result);
  ASSERT_EQ(result.value_families.size(), ValueFamilyKinds().size());
  std::size_t bounded = 0;
  for (const ValueBenchRow& row : result.value_rows) {
    const std::string& family = result.value_families[row.family].name;
    EXPECT_GT(result.value_families[row.family].judged, 75U) << family;
    if (std::isnan(row.share_of_bound)) continue;
    ++bounded;
    EXPECT_LE(row.share_of_bound, 1) << row.method << " by " << row.target << " on " << family;
    if (row.method == "library-nearest") {
      EXPECT_LE(row.ulps, 0.5) << family;
    }
  }
  EXPECT_GT(bounded, 100U);
}

TEST(ValueBench, SeesAWrongValueAndANaN) {
  const ValueTriangle t{{0, 64, 0}, {0, 0, 64}, {1, 1, 1}, {1, 2, 1}};
  const auto exact = ExactValueAt(t, 31, 0);  // 1 + 31.5 / 64
  ASSERT_TRUE(exact);
  ValueBound bound;
  bound.conditions = 4;
  ValueErrors errors(false, bound);
  errors.Add(*exact, 1.4921875F);
  errors.Add(*exact, 1.4921875F + 0x1p-20F);
  errors.Add(*exact, std::nanf(""));
  ValueBenchRow row;
  errors.WriteTo(row);
  EXPECT_EQ(row.ulps, 8);
  EXPECT_EQ(row.texels, 0x1p-8);
  EXPECT_EQ(row.not_finite, 1U);
  EXPECT_GT(row.share_of_bound, 0);
  EXPECT_EQ(row.worst.shown, 1.4921875 + 0x1p-20);
  EXPECT_EQ(row.worst.exact, 1.4921875);
}

TEST(ValueBench, RefusesAFamilyThatThereIsNot) {
  ValueBenchOptions options;
  options.families = {"nowhere"};
  BenchResult result;
  EXPECT_THROW(RunValues(options, result), InputError);
}

}  // namespace
}  // namespace rasterproof::bench
