// Published statements about edge functions, barycentrics, windings, tie rules and wireframes, each
// with its verdict, executable.
#ifndef RASTERPROOF_TESTS_STATEMENTS_STATEMENT_H_
#define RASTERPROOF_TESTS_STATEMENTS_STATEMENT_H_

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace rasterproof::props {

enum class Truth : std::uint8_t {
  kTrue,         ///< as stated
  kConditional,  ///< under a precondition that the text leaves out
  kWrong,        ///< `holds` is the corrected statement
  kImprecise,    ///< true of something, but not what the words say
  kConvention,   ///< a choice of sign or axis that others make the other way
  kMismatch      ///< the text and its own code differ
};
std::string_view TruthName(Truth truth);

/// How often a statement was put to the test, and how often it held.
struct StatementTally {
  std::uint64_t drawn = 0;
  std::uint64_t met = 0;  ///< configurations that met the precondition
  std::uint64_t held = 0;
};

struct Statement {
  std::string_view id;
  std::string_view text;  ///< the statement, in our words
  Truth verdict;
  /// The precondition, or for a wrong statement the correction; empty for a true one.
  std::string_view holds;
  /// A concrete configuration at which the statement as written fails; empty if there is none.
  std::string_view counterexample;
  /// Checks the statement under its precondition (or its correction) on `count` random
  /// configurations, by exact rationals.
  StatementTally (*check)(std::uint64_t seed, int count);
  /// Returns whether the statement as written really fails at the counterexample. nullptr if none.
  bool (*fails_as_written)();
};

/// Every statement, in the order of docs/mathematics.md.
std::vector<Statement> Statements();

/// By subject. Statements() joins them.
std::span<const Statement> EdgeStatements();           ///< H1 to H12
std::span<const Statement> CoverageStatements();       ///< C1 to C7, C10 to C13, C16, C17
std::span<const Statement> InterpolationStatements();  ///< C8, C9, C14, C15
std::span<const Statement> HomogeneousStatements();    ///< E1 to E12
std::span<const Statement> WireframeStatements();      ///< W1 to W16

}  // namespace rasterproof::props

#endif  // RASTERPROOF_TESTS_STATEMENTS_STATEMENT_H_
