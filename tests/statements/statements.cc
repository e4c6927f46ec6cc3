#include <array>
#include <string_view>
#include <vector>

#include "tests/statements/statement.h"

namespace rasterproof::props {

std::string_view TruthName(Truth truth) {
  switch (truth) {
    case Truth::kTrue:
      return "true";
    case Truth::kConditional:
      return "conditional";
    case Truth::kWrong:
      return "wrong";
    case Truth::kImprecise:
      return "imprecise";
    case Truth::kConvention:
      return "convention";
    case Truth::kMismatch:
      return "mismatch";
  }
  return "";
}

std::vector<Statement> Statements() {
  std::vector<Statement> all;
  for (const auto part : {EdgeStatements(), CoverageStatements(), InterpolationStatements(),
                          HomogeneousStatements(), WireframeStatements()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace rasterproof::props
