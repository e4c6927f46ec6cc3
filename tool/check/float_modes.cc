#include "tool/check/float_modes.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/float_mode.h"
#include "core/result.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "props/float_modes/float_modes.h"
#include "report/proportion.h"
#include "report/text.h"
#include "tool/exit_status.h"
#include "tool/file_names.h"
#include "tool/interrupt.h"
#include "tool/outside.h"
#include "tool/progress.h"
#include "tool/resolve.h"

namespace rasterproof::tool {
namespace {

using props::FloatModeResult;

// Where a mode is set, and what a user would have done to set it there.
struct Way {
  std::string_view name;
  bool is_of_host;  // by how the host of a library is started
  FloatModeOfHost::Where where = FloatModeOfHost::Where::kNowhere;
};
constexpr std::array kWays{
    Way{"call", false},
    Way{"load", true, FloatModeOfHost::Where::kFromTheStart},
    Way{"workers", true, FloatModeOfHost::Where::kInOtherThreads},
};

std::vector<FloatMode> ModesNamed(const std::vector<std::string>& names) {
  std::vector<FloatMode> modes;
  for (const std::string& name : names) {
    const std::optional<FloatMode> mode = FindFloatMode(name);
    if (!mode || *mode == FloatMode::kUsual) {
      throw InputError("option --fp-env", fmt::format("'{}' is no floating-point mode", name),
                       "give some of ftz, daz, up, down, zero, trap, with commas between");
    }
    if (!HasFloatMode(*mode)) {
      throw InputError("option --fp-env", fmt::format("this processor has no mode '{}'", name),
                       "leave it out");
    }
    modes.push_back(*mode);
  }
  return modes;
}

std::string Sentence(const FloatModeResult& r) {
  if (r.touched == 0) return "no case could be touched";
  std::string text;
  if (r.changed != 0) {
    text = "changed " + report::CountedText(r.changed, r.touched);
    if (r.by_snap != 0) text += fmt::format("; {} by the snap alone", r.by_snap);
  }
  if (r.failed != 0) {
    text +=
        fmt::format("{}failed {} of {}: {}", text.empty() ? "" : "; ", r.failed, r.touched, r.why);
  }
  return text.empty() ? fmt::format("unchanged, {} of {} could be touched", r.touched, r.cases)
                      : text;
}

// Subjects of this program run in it; a library runs in a host.
class Measured {
 public:
  Measured(const SubjectFactory& factory, const CheckOptions& options)
      : factory_(factory), usual_subject_(factory.Make()) {
    if (!usual_subject_->Info().takes_float_modes) {
      throw InputError("subject " + factory.name(),
                       "it is a program, which sets its floating-point mode itself",
                       "give it as a plugin or a C++ type to call it in other modes");
    }
    plan_.seed = options.campaign.seed;
    plan_.cases = options.campaign.cases;
    plan_.stop = Interrupted;
    usual_ = props::DrawAsUsual(*usual_subject_, plan_);
  }

  FloatModeResult In(FloatMode mode, const Way& way) {
    if (!way.is_of_host) {
      return CompareWithUsual(*usual_subject_, usual_, mode, mode, plan_.stop);
    }
    const std::unique_ptr<Subject> subject = MakeInHost(factory_.name(), {mode, way.where});
    subject->JudgeAs(usual_subject_->Info());
    return CompareWithUsual(*subject, usual_, mode, FloatMode::kUsual, plan_.stop);
  }

  bool HasHost() const { return IsOutside(factory_.name()); }
  bool StatesExact() const { return usual_subject_->Info().states_exact; }

 private:
  const SubjectFactory& factory_;
  props::FloatModesPlan plan_;
  std::unique_ptr<Subject> usual_subject_;
  std::vector<props::UsualDrawing> usual_;
};

void Save(const std::string& folder, const std::string& subject, FloatMode mode,
          const FloatModeResult& result) {
  if (folder.empty() || !result.first) return;
  io::MakeFolder(folder);
  io::WriteFile(fmt::format("{}/{}-{}.json", folder, FileNameOf(subject), FloatModeName(mode)),
                io::CaseToJson({*result.first, subject, "EnvironmentKeepsCoverage"}));
}

}  // namespace

int CheckFloatModes(const CheckOptions& options) {
  const std::vector<FloatMode> modes = ModesNamed(options.float_modes);
  const ResolvedCheck asked = ResolveCheck(options);
  if (!options.save.empty()) io::RequireFolderCanBe(options.save);
  Progress progress(1);
  int status = kExitHolds;
  for (const SubjectFactory& factory : asked.subjects) {
    progress.Stage(factory.name() + " in the usual mode");
    Measured measured(factory, options);
    std::string text = fmt::format("{}, seed {}\n", factory.name(), options.campaign.seed);
    bool is_touched = false;
    bool depends = false;
    for (const FloatMode mode : modes) {
      for (const Way& way : kWays) {
        if (way.is_of_host && (!measured.HasHost() || mode == FloatMode::kTrapping)) continue;
        if (Interrupted()) break;
        progress.Stage(
            fmt::format("{} in mode {}, {}", factory.name(), FloatModeName(mode), way.name));
        const FloatModeResult result = measured.In(mode, way);
        is_touched = is_touched || result.touched != 0;
        depends = depends || result.changed + result.failed != 0;
        if (!way.is_of_host) Save(options.save, factory.name(), mode, result);
        text += fmt::format("  {:<5} {:<8} {}\n", FloatModeName(mode), way.name, Sentence(result));
      }
    }
    io::WriteStandardOutput(report::CleanText(text));
    if (depends && (measured.StatesExact() || options.fail_on == FailOn::kQuality)) {
      status = WorseStatus(status, kExitViolated);
    }
    if (!is_touched || Interrupted()) status = WorseStatus(status, kExitInconclusive);
  }
  return status;
}

}  // namespace rasterproof::tool
