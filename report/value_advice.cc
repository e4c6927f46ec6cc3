#include "report/value_advice.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fmt/format.h"

namespace rasterproof::report {
namespace {

struct Compared {
  std::string_view text;
  std::string_view method;
  std::string_view beside;
};
constexpr std::array kCompared{
    Compared{"Differences from one vertex are the same", "differences", "edge-products"},
    Compared{"A x + B y + C is the same", "origin-plane", "vertex-plane"},
    Compared{"Step, don't multiply (a scalar loop beside vectors: not like for like)", "stepped",
             "vertex-plane"},
    Compared{"rcp and one Newton step is enough", "reciprocal-14-newton", "inverse-matrix"},
    Compared{"rcp and one Newton step is enough", "reciprocal-12-newton", "inverse-matrix"},
    Compared{"Derivatives by differences will do", "perspective-difference", "library-derivatives"},
    Compared{"Interpolate in double", "inverse-matrix-f64", "inverse-matrix"},
    Compared{"Correct rounding is too dear, in one frame", "correctly-rounded",
             "perspective-planes"},
    Compared{"Correct rounding is too dear, in one frame", "correctly-rounded",
             "inverse-matrix-f64"},
    Compared{"Correct rounding is too dear", "library-nearest", "library"}};

const ValueBenchRow* FindValueRow(const BenchResult& result, std::uint32_t family,
                                  std::string_view name) {
  const auto found = std::ranges::find_if(result.value_rows, [&](const ValueBenchRow& row) {
    return row.family == family && row.method == name;
  });
  return found == result.value_rows.end() ? nullptr : &*found;
}

// One method beside another over the families that have both, by the same instruction set.
std::string Sentence(const BenchResult& result, const Compared& compared) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  std::size_t families = 0;
  std::size_t worse = 0;
  const ValueBenchRow* worst = nullptr;
  const ValueBenchRow* there = nullptr;
  for (std::uint32_t family = 0; family < result.value_families.size(); ++family) {
    const ValueBenchRow* const row = FindValueRow(result, family, compared.method);
    const ValueBenchRow* const other = FindValueRow(result, family, compared.beside);
    if (row == nullptr || other == nullptr || row->target != other->target) continue;
    ++families;
    worse += row->ulps > other->ulps ? 1 : 0;
    if (row->ns > 0 && other->ns > 0) {
      least = std::min(least, row->ns / other->ns);
      most = std::max(most, row->ns / other->ns);
    }
    // Where it stands out most beside the other.
    if (worst == nullptr || row->ulps * there->ulps > worst->ulps * other->ulps) {
      worst = row;
      there = other;
    }
  }
  if (worst == nullptr) return {};
  const std::string times =
      most > 0 ? fmt::format("{:.2f} to {:.2f} times the time of {}", least, most, compared.beside)
               : fmt::format("beside {}", compared.beside);
  return fmt::format(
      "{}; a larger error on {} of {} families, at most on {}: {:.3g} ulps and {:.3g} texels, {} "
      "{:.3g} and {:.3g}",
      times, worse, families, result.value_families[worst->family].name, worst->ulps, worst->texels,
      compared.beside, there->ulps, there->texels);
}

}  // namespace

std::vector<ValueAdvice> ValueAdviceOf(const BenchResult& result) {
  std::vector<ValueAdvice> advice;
  for (const Compared& compared : kCompared) {
    std::string measured = Sentence(result, compared);
    if (measured.empty()) continue;
    advice.push_back({compared.text, compared.method, compared.beside, std::move(measured)});
  }
  return advice;
}

}  // namespace rasterproof::report
