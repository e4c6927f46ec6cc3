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

/// Clauses, and whether some assignment satisfies all of them.
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
  /// Returns:    kGaveUp after so many propagations.
  Answer Solve(std::span<const Literal> assumptions, std::uint64_t most_propagations);
  /// Whether the assumption is one of those that the last answer, kUnsatisfiable, rests on.
  bool RestsOn(Literal assumption) const;

 private:
  struct Backend;
  std::unique_ptr<Backend> backend_;
  int variables_ = 0;
};

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_SOLVER_H_
