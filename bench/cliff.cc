#include "bench/cliff.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "reference/exactness.h"

namespace rasterproof::bench {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// The largest value whose coordinates are within the limit; infinite where they do not grow with
// it, negative or NaN where none is.
double ValueAt(const Parameter& parameter, double coordinate_limit) {
  return std::floor((coordinate_limit - parameter.reach_beside) / parameter.reach);
}

// The values that are tried upwards.
std::set<double> ValuesToTry(const Parameter& parameter, double coordinate_limit) {
  std::set<double> values;
  const double least = std::ldexp(1.0, parameter.least_exponent);
  const double most = std::ldexp(1.0, parameter.most_exponent);
  for (int k = parameter.least_exponent; k <= parameter.most_exponent; ++k) {
    const double power = std::ldexp(1.0, k);
    values.insert(power);
    if (parameter.scale == Scale::kPowers) continue;
    values.insert(power - 1);
    // From 2^53 on not every whole number is a double.
    if (power < 0x1p53) values.insert({power + 1, 1.5 * power});
  }
  const double limit = ValueAt(parameter, coordinate_limit);
  if (parameter.scale == Scale::kWhole && limit >= least && limit <= most) {
    values.insert({limit - 1, limit, limit + 1});
  }
  return values;
}

class Search {
 public:
  Search(SceneDrawer& drawer, const Parameter& parameter, JudgedCases& cases)
      : drawer_(drawer), parameter_(parameter), cases_(cases) {}

  std::optional<BenchCliff> Find() {
    bool is_asked = false;
    for (const double value : ValuesToTry(parameter_, drawer_.method().coordinate_limit)) {
      const CaseErrors errors = Try(value);
      is_asked = is_asked || errors.asked != 0;
      if (errors.wrong != 0) {
        Bisect();
        break;
      }
    }
    if (!is_asked) return std::nullopt;
    return cliff_;
  }

 private:
  CaseErrors Try(double value) {
    CaseErrors errors = cases_.Of(drawer_, parameter_, value, WithBounds::kNo);
    if (errors.wrong != 0) {
      cliff_.first_failing = value;
      cliff_.scene = errors.first_wrong->scene;
      cliff_.x = errors.first_wrong->x;
      cliff_.y = errors.first_wrong->y;
    } else if (errors.asked != 0) {
      cliff_.held_to = value;
    }
    return errors;
  }

  // The value below what fails is no whole number, or was tried, or asks for what is not drawn.
  void Bisect() {
    if (parameter_.scale == Scale::kPowers || std::isnan(cliff_.held_to)) return;
    double low = cliff_.held_to;
    double high = cliff_.first_failing;
    while (high - low > 1) {
      const double middle = low + std::floor((high - low) / 2);
      (Try(middle).wrong != 0 ? high : low) = middle;
    }
  }

  SceneDrawer& drawer_;
  const Parameter& parameter_;
  JudgedCases& cases_;
  BenchCliff cliff_;
};

}  // namespace

std::optional<BenchCliff> FindCliff(SceneDrawer& drawer, const Parameter& parameter,
                                    JudgedCases& cases) {
  return Search(drawer, parameter, cases).Find();
}

double ProvedTo(const BenchMethod& method, const Parameter& parameter) {
  const double most = std::ldexp(1.0, parameter.most_exponent);
  if (parameter.compared == Compared::kSample && method.is_proved) {
    const double limit = ValueAt(parameter, method.coordinate_limit);
    return limit > 0 ? std::min(most, limit) : kNone;
  }
  const reference::ExactnessRow* row = reference::FindExactness(method.name);
  if (row == nullptr || !parameter.is_grid) return kNone;
  if (parameter.compared == Compared::kValues) return static_cast<double>(row->values);
  // Samples lie on the grid of half pixels: a pixel is two of its steps.
  const double step = std::min(parameter.reach, 0.5);
  const double box = static_cast<double>(row->signs) - row->columns_before / step;
  return std::floor(box * step / parameter.reach);
}

}  // namespace rasterproof::bench
