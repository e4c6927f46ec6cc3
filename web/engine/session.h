// The check of a subject that is asked in rounds: what the module exports, in C++.
#ifndef RASTERPROOF_WEB_ENGINE_SESSION_H_
#define RASTERPROOF_WEB_ENGINE_SESSION_H_

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "props/domains/worlds.h"
#include "props/engine/pulled.h"
#include "web/engine/open.h"

namespace rasterproof::web {

class Session {
 public:
  explicit Session(Opened opened);

  /// Returns PackedJobs() of the next round; of none, if every property has its result.
  std::string Next();
  /// Takes answers to the first of these draws.
  ///
  /// Returns:    false if a draw had another answer before: no result counts.
  /// Error:      InputError, as OutcomesFrom().
  bool Answer(std::string_view bytes);
  /// Returns {"done": N, "of": N}: cases.
  std::string Progress() const;
  std::string Save() const { return engine_.save(); }
  void Load(std::string_view saved) { engine_.load(saved); }
  /// Returns what `check --json` writes, without causes.
  ///
  /// Domain:     Next() gave no draws.
  std::string Result() const;

 private:
  struct Run {
    const props::PulledCheck* cases = nullptr;
    const props::PulledCheck* widths = nullptr;  ///< nullptr: it is not put to these inputs
  };

  const props::PulledCheck* Add(const props::Property& property, const props::World* world);
  std::vector<PropertyResult> Results() const;
  int StatusOf(const std::vector<PropertyResult>& results) const;

  Opened opened_;
  props::PulledEngine engine_;
  std::vector<Run> runs_;
};

}  // namespace rasterproof::web

#endif  // RASTERPROOF_WEB_ENGINE_SESSION_H_
