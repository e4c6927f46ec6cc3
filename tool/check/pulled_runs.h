// Properties on the generated cases of a program that is asked in rounds.
#ifndef RASTERPROOF_TOOL_CHECK_PULLED_RUNS_H_
#define RASTERPROOF_TOOL_CHECK_PULLED_RUNS_H_

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "props/domains/worlds.h"
#include "props/engine/pulled.h"
#include "props/property.h"
#include "tool/check/cmd_check.h"
#include "tool/rounds/far_program.h"

namespace rasterproof::tool {

class PulledRuns {
 public:
  /// Gives the program a check of each property, and one more of each that is put to the width
  /// inputs. The program outlives this.
  PulledRuns(FarProgram& program, const std::vector<const props::Property*>& properties,
             const CheckOptions& options);
  PulledRuns(const PulledRuns&) = delete;
  PulledRuns& operator=(const PulledRuns&) = delete;

  /// Returns what RunCampaign() does, and adds the lines for --cases-json. `world` is nullptr for
  /// the cases of the property's domains, or WidthInputs().
  ///
  /// Domain:     the checks are done; a property that is put to the world.
  PropertyResult Result(const props::Property& property, const props::World* world,
                        std::string& cases) const;

 private:
  struct PulledRun {
    const props::PulledCheck* check = nullptr;
    std::string cases = {};
  };

  void Add(FarProgram& program, const props::Property& property, const props::World* world,
           const CheckOptions& options);

  std::map<std::pair<const props::Property*, const props::World*>, PulledRun> runs_;
};

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CHECK_PULLED_RUNS_H_
