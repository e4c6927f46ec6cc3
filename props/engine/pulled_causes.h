// FindCauses() on a subject whose answers arrive later.
#ifndef RASTERPROOF_PROPS_ENGINE_PULLED_CAUSES_H_
#define RASTERPROOF_PROPS_ENGINE_PULLED_CAUSES_H_

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "props/cause/cause.h"
#include "props/engine/known_answers.h"
#include "props/engine/pulled.h"

namespace rasterproof::props {

/// FindCauses(), without a limit of time: it is run again after each round, from the start.
class PulledCauses final : public PulledWork {
 public:
  /// The failed properties; nothing as long as they are not known.
  using Failures = std::function<std::optional<std::vector<FailedProperty>>()>;

  explicit PulledCauses(Failures failures) : failures_(std::move(failures)) {}

  bool GoOn(KnownAnswers& answers) override;
  PulledProgress progress() const override { return {}; }
  /// Domain: GoOn() was true.
  const Causes& result() const { return *result_; }

 private:
  Failures failures_;
  std::optional<Causes> result_;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_ENGINE_PULLED_CAUSES_H_
