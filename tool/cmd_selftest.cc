// rasterproof selftest: do the properties find planted bugs, and let legal variants pass?
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "fmt/format.h"
#include "io/output.h"
#include "subjects/mutants/mutants.h"
#include "tool/commands.h"
#include "tool/progress.h"
#include "tool/selftest.h"
#include "tool/session.h"

namespace rasterproof::tool {
namespace {

using Clock = std::chrono::steady_clock;

// A legal variant passes only by running to the end, three times over: a mutant seldom does.
constexpr std::uint64_t kLegalSeeds = 3;
constexpr std::uint64_t kLegalShare = 10;

std::vector<subjects::MutantInfo> Chosen(const std::vector<std::string>& only) {
  std::vector<subjects::MutantInfo> chosen;
  for (const std::string& name : only) {
    const auto found = std::ranges::find(subjects::Mutants(), name, &subjects::MutantInfo::name);
    if (found == subjects::Mutants().end()) {
      throw InputError("--only " + name, "there is no such mutant or legal variant",
                       "rasterproof list mutants names them");
    }
    chosen.push_back(*found);
  }
  return only.empty() ? subjects::Mutants() : chosen;
}

HuntResult HuntOne(const subjects::MutantInfo& mutant, std::uint64_t seed, std::uint64_t cases,
                   Progress& progress) {
  progress.Stage(fmt::format("{}, seed {}, cases", mutant.name, seed));
  HuntOptions options;
  options.seed = seed;
  options.cases = cases;
  options.progress = [&](std::uint64_t done) { progress.Done(done); };
  const std::unique_ptr<Subject> subject = MakeSubject(mutant.name);
  return {mutant, seed, HuntBug(*subject, options)};
}

}  // namespace

int RunSelftest(const SelftestOptions& options) {
  RequireHonestEnvironment();
  const std::vector<subjects::MutantInfo> chosen = Chosen(options.only);
  const Clock::time_point start = Clock::now();
  const std::uint64_t legal_cases = std::max<std::uint64_t>(1, options.cases / kLegalShare);
  std::vector<HuntResult> results;
  {
    Progress progress;
    for (const subjects::MutantInfo& mutant : chosen) {
      if (!mutant.legal) {
        results.push_back(HuntOne(mutant, options.seed, options.cases, progress));
        continue;
      }
      for (std::uint64_t k = 0; k < kLegalSeeds; ++k) {
        results.push_back(HuntOne(mutant, options.seed + k, legal_cases, progress));
      }
    }
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  io::WriteStandardOutput(SelftestText(results, options.cases, legal_cases, seconds));
  if (!options.json.empty()) io::WriteFile(options.json, SelftestJson(results));
  return std::ranges::all_of(results, &HuntResult::AsItShould) ? kExitHolds : kExitViolated;
}

}  // namespace rasterproof::tool
