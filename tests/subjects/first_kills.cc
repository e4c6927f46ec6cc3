// Which of the first cases of each domain kill which mutants, property by property: what
// scripts/first_cases chooses by. Prints a line "MUTANT PROPERTY CASE" for each.
//
// usage: first_kills CASES MUTANT...
#include <algorithm>
#include <cstdint>
#include <exception>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/subject.h"
#include "props/domains/case_name.h"
#include "props/judging/gate.h"
#include "props/property.h"
#include "props/run/case_order.h"
#include "props/run/description.h"
#include "props/run/property_domains.h"
#include "props/run/trial.h"
#include "subjects/mutants/mutants.h"

namespace rasterproof::props {
namespace {

void PrintKills(Subject& subject, const std::string& mutant, const Property& property,
                std::uint64_t cases) {
  std::vector<const Domain*> domains = DomainsFor(subject.Info(), property);
  const auto repeats = std::ranges::unique(domains);  // a domain's turns follow each other
  domains.erase(repeats.begin(), repeats.end());
  for (const Domain* domain : domains) {
    for (std::uint64_t index = 0; index < cases; ++index) {
      const CaseName name{std::string(domain->name), index, kFirstCasesSeed};
      const Trial trial = TryCase(subject, property, DrawCase(subject.Info(), name));
      if (trial.verdict.outcome != Outcome::kViolated) continue;
      std::cout << mutant << ' ' << property.name << ' ' << ToText(name) << '\n';
    }
  }
}

}  // namespace
}  // namespace rasterproof::props

int main(int argc, char** argv) {
  using namespace rasterproof;  // NOLINT(google-build-using-namespace)
  try {
    const std::uint64_t cases = argc < 2 ? 0 : std::stoull(argv[1]);
    for (int k = 2; k < argc; ++k) {
      const std::unique_ptr<Subject> subject = subjects::MakeMutant(argv[k]);
      if (subject == nullptr) throw std::runtime_error(std::string("no mutant ") + argv[k]);
      const props::Description description = props::DescriptionOf(*subject);
      for (const props::Property& property : props::Catalog()) {
        if (props::DoesNotApply(property.gate, description)) continue;
        props::PrintKills(*subject, argv[k], property, cases);
      }
    }
  } catch (const std::exception& error) {
    std::cerr << "first_kills: " << error.what() << '\n';
    return 2;
  }
  return 0;
}
