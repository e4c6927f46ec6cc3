// Every float64 method of the table.
#include <vector>

#include "reference/float_rows.h"

namespace rasterproof::reference {

std::vector<Method> Float64Methods() {
  using Direct = DirectForm<double>;
  return {
      FloatMethod<CornerWalk<Direct>, EdgeArithmetic::kIncremental>(
          "f64-incremental", "Pineda's increments in double"),
      FloatMethod<FreshWalk<Direct>, EdgeArithmetic::kDirect>("f64-direct",
                                                              "the direct form in double"),
      FloatMethod<FreshWalk<KahanForm<double>>, EdgeArithmetic::kKahan>(
          "f64-kahan", "the direct form in double with Kahan's difference of products"),
  };
}

}  // namespace rasterproof::reference
