// What explains the violations of a subject: a suspect that draws as it does, or what must vary.
#ifndef RASTERPROOF_PROPS_CAUSE_CAUSE_H_
#define RASTERPROOF_PROPS_CAUSE_CAUSE_H_

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/subject.h"
#include "props/cause/evidence.h"

namespace rasterproof::props {

/// How a cause was found.
enum class CauseKind : std::uint8_t {
  kModel,         ///< a suspect reproduces every draw of the evidence
  kPart,          ///< one of several that together reproduce every draw of the evidence
  kNothingDrawn,  ///< no draw covers anything, where some should
  kCircumstance,  ///< the failing draws are right once one thing about them is changed
  kMistake,       ///< a mistake gives every number that is shown beside coverage
  kShownValues,   ///< every draw is as stated: what fails is in the values that are shown
  kUnexplained    ///< no suspect, or too few draws to name one
};

/// One cause, with the violated properties that it explains.
struct Cause {
  CauseKind kind = CauseKind::kUnexplained;
  std::string name;                     ///< its section of docs/causes.md; "" if unexplained
  std::vector<std::string> what;        ///< one, or several that no draw tells apart
  std::vector<std::size_t> properties;  ///< by their places in what was asked
  std::size_t reproduced = 0;  ///< draws of `draws` that it reproduces; of kMistake, numbers
  std::size_t draws = 0;
  std::size_t together = 0;  ///< if not 0, so many suspects at once reproduce them
  /// The different scenes, drawn otherwise than the stated model, that a suspect was named by.
  std::size_t wrong_scenes = 0;
  /// Of kUnexplained: `what` are suspects that draw these scenes alike, but the scenes are so few
  /// that others may do so by chance.
  bool rests_on_few = false;
  /// What all draws have that differ from the stated model, and hardly others: "x < 0".
  std::vector<std::string> only_with = {};
  /// Of kUnexplained: where all wrong samples lie; "" if nothing is to be said.
  std::string pattern = {};
};

/// Whether a suspect reproduces so few scenes that it is not named: fewer than four, and, if it is
/// one of a part, fewer than half of the scenes drawn wrong.
bool AreFewScenes(CauseKind kind, std::size_t explained, std::size_t wrong);

/// Causes of violations, those with a name first, and of these the one of most properties.
struct Causes {
  std::vector<Cause> all;
  std::size_t suspects = 0;   ///< that were compared with the draws
  bool is_cut_short = false;  ///< time was up before all was drawn and compared
  std::size_t draws = 0;      ///< of the subject
  std::size_t wrong = 0;      ///< of these, draws that differ from the stated model
};

/// What `check` takes, in seconds of processor time: a quarter of it to gather draws, and the rest
/// to compare suspects with them. A subject outside has four times as much of the clock to draw.
inline constexpr double kCauseSeconds = 8;

/// The names that a cause may have: the sections of docs/causes.md, "none" among them.
std::vector<std::string_view> CauseNames();

using MakesSubject = std::function<std::unique_ptr<Subject>()>;

/// Finds what explains the failed properties of the subject.
///
/// Each suspect (suspect.h) is compared with the subject on the same draws: those of the failing
/// cases, and others around them. A suspect that draws one of them otherwise is refuted. What is
/// left must foretell draws more in which it differs from the stated model. If none is left, those
/// are searched that explain all draws together, or each some of them and all of them all; never
/// is one named that leaves a draw unexplained. Then comes what about the failing draws must be so.
///
/// Domain:     properties that subjects of `make` violate; each call makes another of them, which
///             has drawn nothing.
/// Returns:    each failed property in one cause.
/// Cost:       some hundreds of draws of the subject, and at most `seconds`, shared out as those of
///             kCauseSeconds: is_cut_short says if they were not enough. A circumstance takes as
///             long as the subject takes for some dozens of draws more.
Causes FindCauses(const MakesSubject& make, std::span<const FailedProperty> failures,
                  double seconds = kCauseSeconds);

/// What was changed about a wrong draw that made it right.
struct Circumstance {
  std::string name;
  std::string what;  ///< completes "it is right ..."
};

/// Finds what must be so for the draws to be wrong: other draws before them, an option, a list; or
/// that nothing must, where equal questions have different answers. An empty name if nothing makes
/// all of them right. `all` is what was asked before them, in the order of Observation::place.
Circumstance FindCircumstance(const MakesSubject& make, std::span<const Observation* const> wrong,
                              std::span<const Observation> all);

/// Returns where all wrong samples of the draws lie, to be read after "every wrong sample": in one
/// row or column, in blocks that are drawn or left out whole, on one side of a line; "" if nowhere
/// in particular.
std::string PatternOf(std::span<const Observation* const> wrong, Subject& stated);

/// What the draws that differ from the stated model have in common, and most others lack.
std::vector<std::string> OnlyWith(std::span<const Observation> observations);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CAUSE_CAUSE_H_
