// The check of a subject that is asked in rounds: what the module exports, in C++.
#ifndef RASTERPROOF_WEB_ENGINE_SESSION_H_
#define RASTERPROOF_WEB_ENGINE_SESSION_H_

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/subject_info.h"
#include "io/check_json.h"
#include "props/domains/worlds.h"
#include "props/engine/pulled.h"
#include "props/engine/pulled_causes.h"
#include "props/engine/pulled_infer.h"
#include "web/engine/open.h"
#include "web/engine/told.h"

namespace rasterproof::web {

class Session {
 public:
  explicit Session(Opened opened);

  /// Returns PackedJobs() of the next round; of none, if every property has its result.
  std::string Next();
  bool IsDone() { return engine_.Next().empty(); }
  /// Takes answers to the first of these draws.
  ///
  /// Returns:    false if a draw had another answer before: no result counts.
  /// Error:      InputError, as OutcomesFrom().
  bool Answer(std::string_view bytes);
  /// Returns {"done": N, "of": N}: cases.
  std::string Progress() const;
  std::string Save() const { return engine_.save(); }
  void Load(std::string_view saved) { engine_.load(saved); }
  /// Returns what `check --json` writes, and beyond that `opened`, the model, and
  /// of each failure its clauses and its picture.
  ///
  /// Domain:     IsDone().
  std::string Result() const;
  /// Returns the results of the properties, with what was seen of the failures.
  ///
  /// Domain:     as of Result().
  std::vector<PropertyResult> Results() const;
  const SubjectInfo& info() const { return opened_.info; }

 private:
  struct Checked {
    const props::PulledCheck* check = nullptr;
    const PulledSight* sight = nullptr;

    PropertyResult Result() const;
  };
  struct Run {
    Checked cases;
    std::optional<Checked> widths;  ///< nothing: it is not put to these inputs
  };

  Checked Add(const props::Property& property, const props::World* world);
  std::vector<std::size_t> FailedOf(std::span<const PropertyResult> results) const;
  std::optional<std::vector<props::FailedProperty>> Failed() const;
  std::vector<io::CheckedCause> CausesOf(std::span<const PropertyResult> results,
                                         std::vector<std::string>& names) const;
  int StatusOf(const std::vector<PropertyResult>& results) const;

  Opened opened_;
  props::PulledEngine engine_;
  std::vector<Run> runs_;
  const props::PulledInfer* infer_ = nullptr;    ///< nullptr: no model was asked for
  const props::PulledCauses* causes_ = nullptr;  ///< nullptr: no causes were asked for
};

}  // namespace rasterproof::web

#endif  // RASTERPROOF_WEB_ENGINE_SESSION_H_
