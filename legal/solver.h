// A SAT solver: the only place that knows PicoSAT.
#ifndef RASTERPROOF_LEGAL_SOLVER_H_
#define RASTERPROOF_LEGAL_SOLVER_H_

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>

namespace rasterproof::legal {

/// A variable (positive) or its negation (negative); never 0.
using Literal = int;

enum class Answer : std::uint8_t { kSatisfiable, kUnsatisfiable, kGaveUp };

/// Holds clauses and decides whether some assignment satisfies all of them.
class Solver {
 public:
  Solver();
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  ~Solver();

  Literal NewVariable() { return ++variables_; }
  void Add(std::span<const Literal> clause);
  void Add(std::initializer_list<Literal> clause) { Add(std::span(clause.begin(), clause.size())); }

  /// Returns whether the clauses and all assumptions can hold together.
  ///
  /// Returns:    kGaveUp once the limit of propagations is reached.
  Answer Solve(std::span<const Literal> assumptions, std::uint64_t most_propagations);
  /// Returns whether the last answer, kUnsatisfiable, depends on the assumption.
  bool RestsOn(Literal assumption) const;

 private:
  struct Backend;
  std::unique_ptr<Backend> backend_;
  int variables_ = 0;
};

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_SOLVER_H_
