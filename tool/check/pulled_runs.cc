#include "tool/check/pulled_runs.h"

#include <memory>

#include "props/domains/width_inputs.h"
#include "props/run/campaign_options.h"
#include "tool/check/check_json.h"

namespace rasterproof::tool {

PulledRuns::PulledRuns(FarProgram& program, const std::vector<const props::Property*>& properties,
                       const CheckOptions& options) {
  for (const props::Property* property : properties) {
    Add(program, *property, nullptr, options);
    if (props::IsPutToWidthInputs(property->name, program.Info()))
      Add(program, *property, &props::WidthInputs(), options);
  }
}

void PulledRuns::Add(FarProgram& program, const props::Property& property,
                     const props::World* world, const CheckOptions& options) {
  PulledRun& run = runs_[{&property, world}];
  props::CampaignOptions campaign = options.campaign;
  campaign.world = world;
  if (world != nullptr) campaign.cases = world->cases;
  if (!options.cases_json.empty()) {
    campaign.judged = [&](const Case& c, const Verdict& verdict) {
      run.cases += CaseLine(program.Info(), property, c, verdict);
    };
  }
  run.check = &program.Add(std::make_unique<props::PulledCheck>(property, campaign));
}

PropertyResult PulledRuns::Result(const props::Property& property, const props::World* world,
                                  std::string& cases) const {
  const PulledRun& run = runs_.at({&property, world});
  cases += run.cases;
  return run.check->result();
}

}  // namespace rasterproof::tool
