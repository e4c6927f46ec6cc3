#include "props/run/case_places.h"

#include <cstddef>
#include <string>

namespace rasterproof::props {

void Add(CountsOfPlaces& counts, const CountsOfPlaces& more) {
  for (std::size_t p = 0; p < counts.size(); ++p) {
    counts[p].asked += more[p].asked;
    counts[p].refused += more[p].refused;
  }
}

std::string RefusedThroughout(const CountsOfPlaces& counts) {
  std::string text;
  for (std::size_t p = 0; p < counts.size(); ++p) {
    if (counts[p].asked < kFewestCasesAtAPlace || counts[p].refused < counts[p].asked) continue;
    text += text.empty() ? "" : ", ";
    text +=
        "all " + std::to_string(counts[p].refused) + " cases with " + std::string(kCasePlaces[p]);
  }
  return text;
}

}  // namespace rasterproof::props
