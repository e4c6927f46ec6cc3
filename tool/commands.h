// The verbs of the command, each with what its options say. main.cc parses, cmd_*.cc do the work.
#ifndef RASTERPROOF_TOOL_COMMANDS_H_
#define RASTERPROOF_TOOL_COMMANDS_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/authority.h"

namespace rasterproof::tool {

/// Exit statuses.
inline constexpr int kExitHolds = 0;
inline constexpr int kExitViolated = 1;
inline constexpr int kExitUsage = 2;
inline constexpr int kExitFault = 3;
inline constexpr int kExitInconclusive = 4;

/// A scene file, or a mesh and how it is seen.
struct SceneOptions {
  std::string path;
  std::string camera;  ///< for meshes; empty: "front"
  std::string project =
      "auto";  ///< "window", "clip", "auto": window unless a vertex lies behind the eye
  int width = 512;
  int height = 512;
};

/// How many cases, from which seed.
struct CampaignChoice {
  std::uint64_t seed = 1;
  std::uint64_t cases = 1000;
  double seconds = 0;
};

struct ListOptions {
  /// "subjects", "properties", "domains", "worlds", "profiles", "mutants", "keys", "clauses", or
  /// "all" but the last two
  std::string what = "all";
  bool json = false;  ///< of clauses
};
int RunList(const ListOptions& options);

struct CoverageOptions {
  SceneOptions scene;
  std::string subject = "exact";
  std::string profile;  ///< empty: "real" for exact, the subject's own otherwise
  std::string output = "-";
};
int RunCoverage(const CoverageOptions& options);

/// What all legal models of a scene agree on.
struct DecidedOptions {
  SceneOptions scene;
  std::string profile = "vulkan";
  std::string json;  ///< file; empty: none
  std::string png;
  std::vector<int> view;  ///< of the picture: column, row, width, height; empty: the target
  int scale = 1;          ///< side of a pixel in it
};
int RunDecided(const DecidedOptions& options);

/// Whether one legal model explains a drawing.
struct LegalOptions {
  SceneOptions scene;
  std::string image;    ///< counts as text, or a PNG picture; empty: `subject` draws
  std::string subject;  ///< empty: `image` is given
  std::string profile;  ///< empty: the subject's own
  std::string background = "000000";
  std::string json;  ///< file; empty: none
  std::string save;  ///< the part that no model explains, as a case file
};
int RunLegal(const LegalOptions& options);

struct DiffOptions {
  SceneOptions scene;
  std::string subject;
  std::string against = "exact";
  std::string profile;  ///< of the oracle; empty: the subject's own
  std::string png;
};
int RunDiff(const DiffOptions& options);

struct RenderOptions {
  SceneOptions scene;
  std::string mode =
      "flat";  ///< "flat", "barycentrics", "depth", "wireframe", "coverage", "difference"
  std::string subject = "spans-exact";
  double line_width = 1;
  std::string output;
};
int RunRender(const RenderOptions& options);

struct CheckOptions {
  std::vector<std::string> subjects;
  std::vector<std::string> properties;
  std::vector<std::string> scenes;  ///< case or scene files
  std::vector<std::string> named;   ///< drawn cases, by their names; no scenes either: a campaign
  std::string profile;              ///< judge by this one instead of the subject's own
  bool device = false;              ///< with the numbers of its device in it
  CampaignChoice campaign;
  std::size_t batch = 32;  ///< cases whose draws share calls
  std::string save;        ///< folder for counterexamples; those there are asked first
  int jobs = 1;            ///< properties at once
  FailOn fail_on = FailOn::kStated;
};
int RunCheck(const CheckOptions& options);

/// Cases `first` to `end` - 1 of a campaign.
struct CaseRange {
  std::uint64_t first = 0;
  std::uint64_t end = 0;

  friend bool operator==(const CaseRange&, const CaseRange&) = default;
};

struct CertifyOptions {
  std::vector<std::string> subjects;
  bool all = false;
  std::string scene_set;  ///< file; empty: scenes/certify.json, which lies beside the command
  std::string output = "out";
  std::string bench;  ///< file that bench --json wrote, for the page; empty: none
  CampaignChoice campaign;
  /// Only these cases, as a part. `campaign.cases` plays no role.
  std::optional<CaseRange> range;
  std::string shard;                ///< only this shard, as a part: "2/5" or "auto"; empty: all
  std::vector<std::string> worlds;  ///< small worlds, every case of which is run
  int jobs = 1;                     ///< properties or scenes at once
  FailOn fail_on = FailOn::kStated;
};
int RunCertify(const CertifyOptions& options);

/// Parts of one subject's campaign, put together.
struct MergeOptions {
  std::vector<std::string> parts;  ///< files
  std::string subject;             ///< empty: the one that the parts name
  std::string scene_set;
  std::string output = "out";
  int jobs = 1;  ///< scenes at once
  FailOn fail_on = FailOn::kStated;
};
int RunMerge(const MergeOptions& options);

struct InferOptions {
  std::string subject = "spans-exact";
  std::string profile;  ///< stated in place of the subject's own
  std::uint64_t seed = 1;
  std::string json;  ///< file; empty: none
};
int RunInfer(const InferOptions& options);

struct SurveyOptions {
  std::string subject = "spans-exact";
  std::string profile;  ///< stated in place of the subject's own
  CampaignChoice campaign{.seed = 1, .cases = 2000, .seconds = 0};
  std::string json;  ///< file; empty: none
  std::string save;  ///< folder for the cases found
  int jobs = 1;      ///< domains at once
};
int RunSurvey(const SurveyOptions& options);

/// A saved case, or the name of a drawn one.
struct CaseChoice {
  std::string path;
  std::string subject;
  std::string property;
  std::string profile;  ///< judge by this one; empty: the file's, or the subject's own
  std::string name;     ///< of a drawn case: "near-edge:17@1"
  std::string typed;    ///< the command line as the user gave it, quoted for a shell
  /// The file is a fuzz input, as a fuzzer saves it, whatever it looks like.
  bool is_fuzz_input = false;
};

struct ReplayOptions {
  CaseChoice choice;
};
int RunReplay(const ReplayOptions& options);

struct ExplainOptions {
  CaseChoice choice;
  int x = -1;
  int y = -1;
  std::string svg;
  std::string png;
  bool colour = false;
};
int RunExplain(const ExplainOptions& options);

/// A search for the largest error over its bound.
struct ClimbOptions {
  std::string subject = "f32-direct";
  std::string property = "EdgeErrorStaysWithinItsBound";
  std::uint64_t seed = 1;
  std::uint64_t evaluations = 20'000;
  std::string output;  ///< file; empty: none
};
int RunClimb(const ClimbOptions& options);

struct ShrinkOptions {
  CaseChoice choice;
  std::string output = "-";
  std::uint64_t budget = 10000;
};
int RunShrink(const ShrinkOptions& options);

struct PlanOptions {
  SceneOptions scene;
  std::string profile = "real";
  bool barycentrics = false;
  bool depth = false;
  bool wireframe = false;
  bool verify = false;
  bool measure = false;
  double error = -1;  ///< pixels that an edge may be off; negative: the plan is exact
  std::string bench;  ///< file that bench --json wrote: the times, where an error is stated
};
int RunPlan(const PlanOptions& options);

struct BenchOptions {
  std::vector<std::string> families;  ///< names; empty: all, unless there are scenes
  std::vector<std::string> scenes;    ///< scene files or meshes
  std::vector<std::string> subjects;  ///< built-in methods and kernels by name; empty: all
  std::vector<std::string> plugins;   ///< libraries that are timed beside them, in this process
  std::vector<std::string> programs;  ///< commands that are timed beside them, on a pipe
  bool limits = false;                ///< cliffs alone, of plugins too each in its own process
  std::string save;                   ///< folder for the case of each cliff; empty: none
  double budget = 60;                 ///< seconds for everything
  std::uint64_t seed = 1;
  std::string json;
  std::string svg;
  bool fingerprint = false;  ///< fingerprints alone
  std::string folder;        ///< of their pictures; empty: none are written
  std::string against;       ///< file of an earlier run: what changed since
  std::string from;          ///< file of a run that is not to be repeated; empty: it is run
  std::string command;       ///< as it was typed
  int width = 1920;          ///< of meshes
  int height = 1080;
};
int RunBench(const BenchOptions& options);

struct DecodeOptions {
  std::string input;
  std::string subject;
  std::string property;
  std::string output = "-";
};
int RunDecode(const DecodeOptions& options);

struct EncodeOptions {
  CaseChoice choice;
  std::string output = "-";
};
int RunEncode(const EncodeOptions& options);

/// What goes through a pipe by hand: gen | PROGRAM | ver.
struct PipeOptions {
  std::string property = "CoverageEqualsTheModel";
  std::string description;  ///< file; empty: what is assumed of a program that says nothing
  std::string profile;      ///< in place of the description's
  CampaignChoice campaign;
};
int RunGen(const PipeOptions& options);
int RunVer(const PipeOptions& options);

struct HostOptions {
  std::string subject;
  bool describe = false;
};

struct SelftestOptions {
  std::vector<std::string> only;  ///< names; empty: every mutant and legal variant
  std::uint64_t seed = 1;
  std::uint64_t cases = 1000;  ///< most cases a property
  std::string json;
  int jobs = 1;  ///< mutants and variants at once
};
int RunSelftest(const SelftestOptions& options);

int RunDoctor();

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_COMMANDS_H_
