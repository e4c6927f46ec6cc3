// How often the 95 % interval of a ratio holds 1 where a method is compared with itself.
//
//     cmake --build build --target self_comparisons && build/bench/self_comparisons [ROUNDS]
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "bench/bench.h"
#include "bench/contender.h"
#include "bench/family.h"
#include "bench/paired.h"
#include "core/bench_result.h"
#include "reference/method.h"

namespace rasterproof::bench {
namespace {

// Every method twice; each pair's two members stand in the same rounds.
std::vector<std::unique_ptr<Contender>> EachTwice() {
  std::vector<std::unique_ptr<Contender>> contenders;
  for (const reference::Method& method : reference::Methods()) {
    for (int member = 0; member < 2; ++member) contenders.push_back(MakeMethodContender(method));
  }
  const auto target = library::kernels::SupportedTargets().back();
  for (int member = 0; member < 2; ++member) {
    contenders.push_back(MakeKernelContender(target, library::kernels::Sink::kFacing));
  }
  const auto widest = library::rivals::WidestTarget();
  for (const auto& rival : library::rivals::kRivals) {
    if (!Draws(rival, widest, library::kernels::Sink::kFacing)) continue;
    for (int member = 0; member < 2; ++member) {
      contenders.push_back(MakeRivalContender(rival, widest, library::kernels::Sink::kFacing));
    }
  }
  return contenders;
}

int Run(std::size_t rounds) {
  const auto contenders = EachTwice();
  std::size_t compared = 0;
  std::size_t held = 0;
  for (const FamilyKind& kind : FamilyKinds()) {
    BenchOptions options;
    options.seconds_per_family = 0;
    options.least_rounds = options.most_rounds = rounds;
    options.judged_pixels = 1;
    BenchResult result;
    RunFamily(MakeFamily(kind, FamilySize::kQuick, 1), contenders, options, result);
    for (std::size_t i = 0; i + 1 < result.rows.size(); i += 2) {
      const Interval ratio = RatioInterval(result.rows[i].seconds, result.rows[i + 1].seconds);
      ++compared;
      held += ratio.low <= 1 && 1 <= ratio.high ? 1 : 0;
    }
    std::printf("%-14s %zu of %zu intervals hold 1\n", std::string(kind.name).c_str(), held,
                compared);
    std::fflush(stdout);
  }
  std::printf("%.1f %% of %zu comparisons of a method with itself, %zu rounds each\n",
              100.0 * static_cast<double>(held) / static_cast<double>(compared), compared, rounds);
  return 0;
}

}  // namespace
}  // namespace rasterproof::bench

int main(int argc, char** argv) {
  const long rounds = argc > 1 ? std::atol(argv[1]) : 9;
  return rasterproof::bench::Run(rounds < 6 ? 6 : static_cast<std::size_t>(rounds));
}
