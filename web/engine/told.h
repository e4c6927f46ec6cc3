// What is told beside verdicts: the model that was inferred, and the pictures of failures.
#ifndef RASTERPROOF_WEB_ENGINE_TOLD_H_
#define RASTERPROOF_WEB_ENGINE_TOLD_H_

#include <memory>

#include "core/drawing.h"
#include "core/result.h"
#include "core/subject_info.h"
#include "io/json_writer.h"
#include "props/engine/known_answers.h"
#include "props/engine/pulled.h"
#include "props/infer/infer.h"

namespace rasterproof::web {

/// Draws the smallest case of a check that failed, if its verdict does not hold the drawing.
class PulledSight final : public props::PulledWork {
 public:
  /// Domain:     a check that outlives this.
  explicit PulledSight(const props::PulledCheck& check) : check_(check) {}

  bool GoOn(props::KnownAnswers& answers) override;
  props::PulledProgress progress() const override { return {}; }
  /// nullptr: nothing had to be drawn, or could be.
  const std::shared_ptr<const Drawing>& seen() const { return seen_; }

 private:
  const props::PulledCheck& check_;
  std::shared_ptr<const Drawing> seen_;
  bool is_done_ = false;
};

/// Writes the member `picture` of a failure: "x" and "y", the first column and row that it shows;
/// "width", "height", "samples"; "expected" and "actual", counts of each sample, row by row;
/// "edges", of the triangles that concern the failing sample {"triangle", "values"}, exact values
/// of E opposite v0, v1, v2, none of one that is not finite. Writes nothing if the verdict has no
/// place, nothing was drawn, or the oracle does not decide the scene.
void WritePicture(io::JsonWriter& json, const SubjectInfo& info, const Counterexample& failure);

/// Writes the members `model` {"subpixelBits", "snap", "ties", "samples"}, of all models that are
/// left, null if none fits; and `model_text`, the sentence that `infer` prints.
void WriteModel(io::JsonWriter& json, const props::Inference& inference);

}  // namespace rasterproof::web

#endif  // RASTERPROOF_WEB_ENGINE_TOLD_H_
