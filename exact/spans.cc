#include "exact/spans.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rasterproof::exact {

void SpanTarget::Sum() {
  const std::size_t stride = static_cast<std::size_t>(counts_->samples);
  const std::size_t row = static_cast<std::size_t>(counts_->width) * stride;
  for (std::vector<std::uint32_t>* plane : {&counts_->front, &counts_->back}) {
    for (std::size_t begin = 0; begin < plane->size(); begin += row) {
      std::uint32_t* p = plane->data() + begin;
      for (std::size_t k = stride; k < row; ++k) p[k] += p[k - stride];
    }
  }
}

}  // namespace rasterproof::exact
