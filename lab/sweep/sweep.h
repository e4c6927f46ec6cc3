// Which builds of a rasterizer draw other samples than the base, and what makes them do so.
#ifndef RASTERPROOF_LAB_SWEEP_SWEEP_H_
#define RASTERPROOF_LAB_SWEEP_SWEEP_H_

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/comparison.h"
#include "lab/sweep/sweep_blame.h"
#include "lab/sweep/sweep_builds.h"
#include "lab/sweep/sweep_runner.h"

namespace rasterproof::lab {

/// A build and what it draws.
struct SweepRow {
  SweepBuild build;
  SweepOutcome outcome;
  std::string note;       ///< why it was not built; empty: it was
  std::size_t group = 0;  ///< of builds that draw alike, from 0: the base's; meaningless otherwise

  bool IsDrawn() const { return note.empty() && outcome.HasDrawn(); }
  bool Differs() const { return note.empty() && outcome.Differs(); }
  /// What the table says of it: `note`, or how it failed, and that it was emulated.
  std::string Note() const;
};

/// What makes some of the rows differ.
struct Difference {
  Choices minimal;
  std::vector<std::size_t> rows;
  SweepBlame blame;
};

/// How the caller has work done.
struct SweepWork {
  /// Calls work(i) once for each first <= i < first + count, from as many threads as it likes, and
  /// shows that as `what`; throws what a call threw.
  std::function<void(const std::string& what, std::size_t first, std::size_t count,
                     const std::function<void(std::size_t)>& work)>
      share;
  /// Whether the sweep is to end: what it knows by then stands. Several threads ask it.
  std::function<bool()> stop;
};

/// Sweeps the builds.
///
/// Domain:     a runner that has drawn the base.
class Sweep {
 public:
  Sweep(SweepRunner& runner, SweepWork work);

  /// Builds the given ones; or the usual list, and pairs of those that differ.
  void Run(const std::vector<SweepBuild>& builds);

  /// The base's is the first.
  const std::vector<SweepRow>& rows() const { return rows_; }
  const std::vector<Difference>& differences() const { return differences_; }
  /// Of each group from the model; the base's is the first.
  const std::vector<Cell>& distances() const { return distances_; }
  /// How many rows are drawn, how many of them differ from the base, and how many builds do not
  /// draw every case.
  std::size_t Drawn() const;
  std::size_t Differing() const;
  std::size_t Stopped() const;

 private:
  void InParallel(std::size_t first, std::size_t count, const std::string& what,
                  const std::function<void(std::size_t)>& work);
  void Add(const std::vector<SweepBuild>& builds);
  void AddWhereToFind(SweepRow& row) const;
  void Group();
  void FindDistances();
  std::vector<SweepBuild> Representatives() const;
  Choices MinimalOf(const Choices& choices);
  void FindDifferences();
  std::vector<std::size_t> CasesOf(const Choices& minimal);

  SweepRunner& runner_;
  SweepWork work_;
  std::vector<SweepRow> rows_;
  std::vector<Difference> differences_;
  std::vector<std::size_t> first_rows_;  ///< of each group
  std::vector<Cell> distances_;
};

}  // namespace rasterproof::lab

#endif  // RASTERPROOF_LAB_SWEEP_SWEEP_H_
