#include "legal/solver.h"

#include <memory>

extern "C" {
#include <picosat/picosat.h>
}

namespace rasterproof::legal {

struct Solver::Backend {
  struct Reset {
    void operator()(PicoSAT* solver) const { picosat_reset(solver); }
  };
  std::unique_ptr<PicoSAT, Reset> solver{picosat_init()};
};

Solver::Solver() : backend_(std::make_unique<Backend>()) {}
Solver::~Solver() = default;

void Solver::Add(std::span<const Literal> clause) {
  for (const Literal literal : clause) picosat_add(backend_->solver.get(), literal);
  picosat_add(backend_->solver.get(), 0);
}

Answer Solver::Solve(std::span<const Literal> assumptions, std::uint64_t most_propagations) {
  PicoSAT* const solver = backend_->solver.get();
  for (const Literal literal : assumptions) picosat_assume(solver, literal);
  picosat_set_propagation_limit(solver, most_propagations);
  constexpr int kAnyNumberOfDecisions = -1;
  const int status = picosat_sat(solver, kAnyNumberOfDecisions);
  if (status == PICOSAT_SATISFIABLE) return Answer::kSatisfiable;
  return status == PICOSAT_UNSATISFIABLE ? Answer::kUnsatisfiable : Answer::kGaveUp;
}

bool Solver::RestsOn(Literal assumption) const {
  return picosat_failed_assumption(backend_->solver.get(), assumption) != 0;
}

}  // namespace rasterproof::legal
