#include "tests/props/rapidcheck_bridge.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/ulp.h"
#include "props/domains/bit_source.h"
#include "props/run/conclude.h"
#include "props/run/counterexample.h"
#include "props/run/property_domains.h"
#include "props/shrink/cost.h"
#include "props/shrink/passes.h"
#include "props/shrink/shrink.h"

namespace rasterproof::props {
namespace {

// RapidCheck's random numbers as a source of bits.
class RandomSource final : public BitSource {
 public:
  explicit RandomSource(const rc::Random& random) : random_(random) {}
  std::uint64_t Bits(int count) override { return random_.next() >> (64 - count); }

 private:
  rc::Random random_;
};

// What RapidCheck would print is in the result instead.
class SilentListener final : public rc::detail::TestListener {
 public:
  void onTestCaseFinished(const rc::detail::CaseDescription&) override {}
  void onShrinkTried(const rc::detail::CaseDescription&, bool) override {}
  void onTestFinished(const rc::detail::TestMetadata&, const rc::detail::TestResult&) override {}
};

template <class T>
double DrawHardFloat(BitSource& bits) {
  using Limits = std::numeric_limits<T>;
  const T sign = bits.Chance(128) ? T{1} : T{-1};
  const auto steps = bits.Int(-2, 2);
  const auto exponent = [&](int low, int high) { return static_cast<int>(bits.Int(low, high)); };
  switch (bits.Int(0, 6)) {
    case 0:
      return sign * T{0};
    case 1:
      return sign * Limits::denorm_min() * static_cast<T>(bits.Int(1, 1024));
    case 2:
      return sign * MoveByUlps(Limits::min(), steps);
    case 3:
      return sign * MoveByUlps(Limits::max(), -std::abs(steps));
    case 4:
      return sign * MoveByUlps(std::ldexp(T{1}, exponent(-24, 32)), steps);
    case 5:
      return sign * MoveByUlps(static_cast<T>(bits.Int(0, 128)) / 2, steps);
    default: {
      const T mantissa =
          1 + std::ldexp(static_cast<T>(bits.Bits(Limits::digits - 1)), 1 - Limits::digits);
      return sign *
             std::ldexp(mantissa, exponent(Limits::min_exponent - 1, Limits::max_exponent - 1));
    }
  }
}

std::vector<double> SimplerFloats(double x) {
  std::vector<double> simpler = SimplerCoordinates(x);
  std::erase_if(simpler, [x](double y) { return CoordinateCost(y) >= CoordinateCost(x); });
  return simpler;
}

// The property as RapidCheck asks it: cases count until one fails, then only the search goes on.
class Run {
 public:
  Run(Subject& subject, const Property& property, std::uint64_t seed, std::uint64_t budget)
      : subject_(subject),
        property_(property),
        domains_(DomainsFor(subject.Info(), property)),
        result_(NothingRun(subject.Info(), property, seed)),
        budget_(budget) {}

  bool Holds(const Case& c) {
    if (minimal_ && tried_++ >= budget_) return true;
    if (!could_not_judge_.empty()) return true;
    const Verdict verdict = RunCase(subject_, property_, c);
    if (!minimal_) {
      const auto domain = std::ranges::find(domains_, c.scene.name, &Domain::name);
      AddCase(static_cast<std::size_t>(domain - domains_.begin()), c, verdict, result_);
    }
    if (verdict.outcome == Outcome::kInconclusive && !minimal_) could_not_judge_ = verdict.message;
    if (verdict.outcome != Outcome::kViolated) return true;
    minimal_ = c;  // RapidCheck goes on from the first shrink that fails: the last one is the least
    seen_ = verdict;
    return false;
  }

  bool HasDomains() const { return !domains_.empty(); }

  PropertyResult Result() {
    result_.why = could_not_judge_;
    if (!could_not_judge_.empty()) {
      result_.end = End::kInconclusive;
    } else if (minimal_) {
      result_.end = End::kFailed;
      result_.counterexample = RunOnceMore(subject_, property_, *minimal_, seen_);
    }
    Conclude(subject_.Info(), property_, result_);
    return result_;
  }

 private:
  Subject& subject_;
  const Property& property_;
  std::vector<const Domain*> domains_;
  PropertyResult result_;
  std::uint64_t budget_;
  std::uint64_t tried_ = 0;
  std::optional<Case> minimal_;
  Verdict seen_;  ///< of the minimal case
  std::string could_not_judge_;
};

}  // namespace

rc::Gen<Case> CasesFor(const SubjectInfo& info, const Property& property) {
  std::vector<const Domain*> domains = DomainsFor(info, property);
  return [info, domains = std::move(domains)](const rc::Random& random, int) {
    RandomSource bits(random);
    const Domain& domain = *bits.OneOf(std::span<const Domain* const>(domains));
    return rc::shrinkable::shrinkRecur(DrawNamed(domain, bits, info), [](const Case& c) {
      return rc::seq::fromContainer(ShrinkCandidates(c));
    });
  };
}

rc::Gen<double> HardFloats(Precision precision) {
  return [precision](const rc::Random& random, int) {
    RandomSource bits(random);
    const double x =
        precision == Precision::kFloat32 ? DrawHardFloat<float>(bits) : DrawHardFloat<double>(bits);
    return rc::shrinkable::shrinkRecur(
        double{x}, [](double value) { return rc::seq::fromContainer(SimplerFloats(value)); });
  };
}

PropertyResult CheckWithRapidCheck(Subject& subject, const Property& property, std::uint64_t seed,
                                   std::uint64_t cases, std::uint64_t shrink_budget) {
  const auto start = std::chrono::steady_clock::now();
  Run run(subject, property, seed, shrink_budget);
  if (run.HasDomains()) {
    const rc::Gen<Case> generator = CasesFor(subject.Info(), property);
    rc::detail::TestParams params;
    params.seed = seed;
    params.maxSuccess = static_cast<int>(std::min<std::uint64_t>(cases, 1 << 30));
    SilentListener listener;
    // rc::check takes its seed from RC_PARAMS or the clock, and says so; this is the same check
    // with ours, and no failures of RapidCheck's own to reproduce.
    const std::unordered_map<std::string, rc::detail::Reproduce> nothing_to_reproduce;
    rc::detail::checkTestable([&] { RC_ASSERT(run.Holds(*generator)); }, rc::detail::TestMetadata{},
                              params, listener, nothing_to_reproduce);
  }
  PropertyResult result = run.Result();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace rasterproof::props
