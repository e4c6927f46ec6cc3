// Makes programs of a user's sources and compares what they draw, for `sweep`.
#ifndef RASTERPROOF_LAB_SWEEP_SWEEP_RUNNER_H_
#define RASTERPROOF_LAB_SWEEP_SWEEP_RUNNER_H_

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/call_end.h"
#include "core/case.h"
#include "core/comparison.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "lab/sweep/sweep_builds.h"

namespace rasterproof::lab {

/// A folder that goes with this object.
class SweepFolder {
 public:
  SweepFolder();
  ~SweepFolder();
  SweepFolder(const SweepFolder&) = delete;
  SweepFolder& operator=(const SweepFolder&) = delete;
  /// A new path in it.
  std::string NewPath(const std::string& ending);

 private:
  std::filesystem::path folder_;
  std::mutex mutex_;
  std::uint64_t next_ = 0;
};

/// A build that can't be made; what() is the compiler's first error line.
class BuildFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct SweepSettings {
  std::vector<std::string> sources;
  std::string cflags;  ///< words of a shell
  double seconds = 30;
  std::string driver;  ///< kit/plugin_driver.c
  /// Reads what a program says of itself, or throws InputError at the place.
  std::function<SubjectInfo(const std::string& text, const std::string& place)> describe;
};

/// A sample that a build draws otherwise than the base.
struct ChangedSample {
  static constexpr std::size_t kWholeCase = static_cast<std::size_t>(-1);

  std::size_t number_of_case = 0;
  std::size_t sample = kWholeCase;  ///< kWholeCase: one of the two refused the scene
  /// Counts of front and back faces; or the primitive id, and 0.
  std::uint32_t front = 0;
  std::uint32_t back = 0;

  friend bool operator==(const ChangedSample&, const ChangedSample&) = default;
};

struct SweepOutcome {
  /// Empty: it was built and has drawn every case.
  std::string failure;
  bool is_breakdown = false;  ///< it was built and started
  Cell cell;                  ///< the base by this build, in cases and samples
  std::vector<ChangedSample> changes;

  bool Differs() const { return is_breakdown || !changes.empty(); }
  bool HasDrawn() const { return failure.empty(); }
};

/// Compiles, links and runs. All its calls may be made by several threads at once.
class SweepRunner {
 public:
  explicit SweepRunner(SweepSettings settings);

  const SweepSettings& settings() const { return settings_; }
  bool has_cxx() const { return has_cxx_; }
  SweepFolder& folder() { return folder_; }

  /// Compiles a source with the flags of the choices, and these; asked twice for the same object it
  /// answers at once.
  ///
  /// Returns:    the object's path, to be read only; or, if the flags hold -S, that of assembly,
  ///             which is the caller's.
  /// Error:      BuildFailure.
  std::string Compile(const std::string& source, const Choices& choices,
                      const std::vector<std::string>& more = {});
  /// Links objects for the target of the choices, by the compiler and link flags of the choices.
  ///
  /// Error:      BuildFailure.
  std::string Link(const std::vector<std::string>& objects, const Choices& choices);
  /// Runs a tool that is to succeed, with words that a shell reads before its arguments.
  ///
  /// Error:      BuildFailure.
  void Run(const std::vector<std::string>& command, const std::string& shell_words = "");
  /// All of it: the path of the program.
  std::string Build(const Choices& choices);

  /// Builds the base, asks what it is, and draws the cases twice.
  ///
  /// Error:      BuildFailure; InputError if it does not draw every case, and twice alike.
  void DrawBase(std::uint64_t seed, std::uint64_t count, const std::string& profile);
  /// Of the base.
  const SubjectInfo& info() const { return info_; }
  const std::vector<Case>& cases() const { return cases_; }
  const Drawing* BaseDrawing(std::size_t number_of_case) const;

  /// What a program of that target draws otherwise than the base, of these cases (empty: of all).
  SweepOutcome Compare(const std::string& program, const Choices& choices,
                       const std::vector<std::size_t>& numbers = {});
  /// The same of a build; asked twice it answers at once.
  SweepOutcome OutcomeOf(const Choices& choices);

 private:
  double MostSeconds() const;
  std::string WhyStopped(const CallEnd& end) const;
  std::string DriverOf(const Choices& choices);
  std::vector<DrawOutcome> Draw(const std::string& program, const Choices& choices,
                                const std::vector<std::size_t>& numbers) const;

  SweepSettings settings_;
  bool has_cxx_ = false;
  std::string driver_;  ///< its source
  SweepFolder folder_;
  SubjectInfo info_;
  std::vector<Case> cases_;
  std::vector<DrawJob> jobs_;
  std::vector<DrawOutcome> base_;
  double base_seconds_ = 0;  ///< that the base took for all cases
  std::mutex mutex_;
  std::map<std::string, std::string> drivers_;  ///< objects by target
  std::map<Choices, SweepOutcome> outcomes_;
  std::mutex objects_mutex_;
  std::map<std::vector<std::string>, std::string> objects_;  ///< by what compiles them
};

}  // namespace rasterproof::lab

#endif  // RASTERPROOF_LAB_SWEEP_SWEEP_RUNNER_H_
