// Infer() on a subject whose answers arrive later.
#ifndef RASTERPROOF_PROPS_ENGINE_PULLED_INFER_H_
#define RASTERPROOF_PROPS_ENGINE_PULLED_INFER_H_

#include <cstdint>
#include <optional>
#include <span>

#include "core/drawing.h"
#include "props/engine/known_answers.h"
#include "props/engine/pulled.h"
#include "props/infer/infer.h"

namespace rasterproof::props {

/// Infer().
class PulledInfer final : public PulledWork {
 public:
  explicit PulledInfer(const InferOptions& options) : options_(options) {}

  bool GoOn(KnownAnswers& answers) override;
  /// Draws that the inference made before one without an answer.
  PulledProgress progress() const override { return {done_, 0}; }
  /// Domain: GoOn() was true.
  const Inference& result() const { return *result_; }

 private:
  void AskAhead(KnownAnswers& answers, std::span<const DrawJob> known) const;

  InferOptions options_;
  std::uint64_t done_ = 0;
  std::optional<Inference> result_;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_ENGINE_PULLED_INFER_H_
