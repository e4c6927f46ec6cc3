// Fits a profile to a subject: directed experiments eliminate models until those that remain agree.
#ifndef RASTERPROOF_PROPS_INFER_INFER_H_
#define RASTERPROOF_PROPS_INFER_INFER_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/profile.h"
#include "core/subject.h"
#include "props/infer/observer.h"
#include "props/infer/sample_places.h"

namespace rasterproof::props {

/// Lets `Infer` request likely draws early, for subjects that answer in rounds.
struct InferAhead {
  /// Returns how many draws had no answer so far.
  std::function<std::uint64_t()> missed;
  /// Returns whether more may be asked.
  std::function<bool()> has_room;
};

struct InferOptions {
  std::uint64_t seed = 1;
  /// Cases that are not aimed at a pair of models, drawn after the pairs.
  int checks = 400;
  /// The same for the nearest model where none fits: near ones differ in few samples.
  int nearest_checks = 1200;
  /// If set, the run only collects requests; ignore its result.
  std::optional<InferAhead> ahead = {};
};

/// The model that comes nearest where none fits.
struct NearestModel {
  Profile profile;
  std::uint64_t wrong_samples = 0;
  std::uint64_t samples = 0;  ///< of all experiments
  std::uint64_t wrong_experiments = 0;
  std::uint64_t experiments = 0;
};

/// The result for one statement.
struct StatementVerdict {
  std::string statement;  ///< "subpixel bits", "tie rule", ...
  std::string stated;
  std::string found;  ///< every value among the remaining models, " or " between
  bool agrees = false;
};

struct Inference {
  /// Every model that explains all experiments, simplest first. If there are several, the search
  /// found no experiment that distinguishes them.
  std::vector<Profile> remaining;
  FacingReport facing = FacingReport::kNotTold;
  std::uint64_t models = 0;       ///< models at the start of the race
  std::uint64_t experiments = 0;  ///< draws of the subject
  /// If a model fits: what was left out, if anything. If none fits: why, in one line, with the case
  /// that the nearest model gets wrong, and that model.
  std::string message;
  std::optional<Case> witness;
  std::optional<NearestModel> nearest;
  /// Where none fits: the model that was left last, and the scene whose draw refuted it.
  std::optional<Case> last_refuted;
  /// Filled for several samples, and for one sample if no model fits.
  std::optional<SamplePlaces> sample_places;
  /// Each statement of the subject's profile compared with the models found; empty if none fits.
  std::vector<StatementVerdict> statements;
  /// A case in which the stated model itself is wrong.
  std::optional<Case> against_stated;
  double seconds = 0;

  /// True if the stated limits left no room for experiments, or the subject was too slow: the
  /// message says which, and why.
  bool is_inconclusive = false;

  bool Fits() const { return !remaining.empty(); }
  /// False if a statement is contradicted.
  bool Agrees() const;
};

/// Finds the models that explain the subject: subpixel bits 0 to 16 or none, five rules, three
/// forms about 1/2 or a sample's own place, eight tie rules, `inclusive` and `exclusive`, any
/// sample locations on multiples of 2^-8, y down or up, facings as on screen or reversed.
///
/// Domain:     a subject that draws float32 scenes and takes coordinates up to 1026; up to 514,
///             258, 130 or 66 the samples' locations are looked for on multiples of 2^-7, 2^-6,
///             2^-5 or 2^-4 (its profile's limit bounds all other draws); a fixed-point input
///             is given its integers, in range. Of its statements the search trusts only the number
///             of samples, the kind of its counts, its limits (coordinates, largest extent,
///             guard-band rectangle) and its freedom. With `by_target_size` it finds the model of
///             the smallest targets.
/// Error:      none: a subject that throws fits no model, and the message says why. A scene that it
///             refuses is skipped, unless it is one of the first, which show where samples lie.
Inference Infer(Subject& subject, const InferOptions& options = {});

/// A guess at what a subject does.
struct LikelyModel {
  Profile profile;
  FacingReport facing = FacingReport::kAsOnScreen;
};

/// Returns the models that come nearest to the subject's draws of some scenes, the nearest first;
/// none if it breaks off.
///
/// Domain:     as for Infer(); scenes of one triangle in window space, which it takes.
std::vector<LikelyModel> LikelyModels(Subject& subject, std::span<const Scene> scenes,
                                      std::size_t most);

/// Has the subject draw what Infer() may draw of a subject that no model fits, whatever it draws.
void DrawAimless(Subject& subject, const InferOptions& options = {});

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_INFER_INFER_H_
