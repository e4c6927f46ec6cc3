// The verbs of the command, each with what its options say. command_line.cc parses, and cmd_*.cc do
// the work.
#ifndef RASTERPROOF_TOOL_COMMANDS_H_
#define RASTERPROOF_TOOL_COMMANDS_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/authority.h"
#include "core/subject_info.h"
#include "props/cause/cause.h"
#include "props/run/campaign.h"

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

struct ListOptions {
  /// "subjects", "properties", "domains", "worlds", "profiles", "mutants", "keys", "clauses", or
  /// "all" but the last two
  std::string what = "all";
  std::string prefix;   ///< of clauses: those whose ids begin so; empty: all
  bool json = false;    ///< of clauses
  std::string subject;  ///< of properties: those that apply to it; empty: all
};
int RunList(const ListOptions& options);

/// What a subject covers, as rows of counts or a picture, or where it differs from another.
struct CoverageOptions {
  SceneOptions scene;
  std::string subject;  ///< empty: "exact", or "spans-exact" where pixels are shaded
  std::string profile;  ///< empty: "real" for exact, the subject's own otherwise
  std::string output = "-";
  std::string against;  ///< the subject to compare with; empty: none
  std::string png;      ///< a picture in place of the rows, or beside the comparison; empty: none
  std::string mode = "coverage";  ///< of the picture; flat, barycentrics, depth, wireframe: shaded
  double line_width = 1;
};
int RunCoverage(const CoverageOptions& options);

/// Whether one legal model explains a drawing, or what all legal models agree on.
struct LegalOptions {
  SceneOptions scene;
  std::string image;    ///< counts as text, or a picture; empty: `subject` draws
  std::string subject;  ///< empty: `image` is given
  std::string profile;  ///< empty: the subject's own
  std::string background = "000000";
  bool counts = false;          ///< the levels of a picture are counts
  bool ids = false;             ///< the numbers of `image` are 1 + ids of triangles
  std::string facings;          ///< how many of what `image` shows are front-facing; empty: unknown
  std::string visible = "any";  ///< of those that cover a sample: any, last, first
  std::string list;             ///< file of drawings to judge; empty: one drawing
  std::string junit;            ///< of a list; empty: none
  std::string json;             ///< file; empty: none
  std::string save;             ///< the part that no model explains, as a case file
  bool resolved = false;        ///< `image` shows how many of a pixel's samples are covered
  bool decided = false;         ///< no drawing is judged
  std::string png;              ///< where legal models differ; empty: none
  std::string mask;             ///< the same as grey levels of data; empty: none
  /// In roundings of float32: the profile states none, and the verdict rests on this.
  std::optional<double> transform_error = {};
  std::vector<int> view;  ///< of that picture: column, row, width, height; empty: the target
  int scale = 1;          ///< side of a pixel in it
};
int RunLegal(const LegalOptions& options);
/// The profile, with the error of the transform from clip space that the options assume.
Profile WithAssumptions(Profile profile, const LegalOptions& options);
/// The line that says what is assumed; empty if nothing is.
std::string AssumedErrorLine(const LegalOptions& options);
/// What `legal --list` does.
int JudgeList(const LegalOptions& options);
/// What `legal --resolved` does.
int JudgeResolved(const LegalOptions& options);
/// What `legal --decided` does.
int TellDecided(const LegalOptions& options);

struct CheckOptions {
  std::vector<std::string> subjects;
  std::vector<std::string> properties;
  std::vector<std::string> scenes;  ///< case or scene files
  std::vector<std::string> named;   ///< drawn cases, by their names; no scenes either: a campaign
  std::string profile;              ///< judge by this one instead of the subject's own
  bool device = false;              ///< with the numbers of its device in it
  props::CampaignOptions campaign;
  std::string save;             ///< folder for counterexamples; those there are asked first
  std::string cases_json;       ///< file for a line of JSON a drawn case; empty: none
  int jobs = 1;                 ///< properties at once
  std::size_t list_length = 0;  ///< 0: the subject's own
  FailOn fail_on = FailOn::kStated;
  bool no_cause = false;  ///< violations are not explained
  /// At most, for what explains them.
  double cause_seconds = props::kCauseSeconds;
  std::string known;       ///< file of failures that fail nothing; empty: none
  std::string json;        ///< file; empty: none
  bool verbose = false;    ///< every line, and every failure in full
  bool fail_fast = false;  ///< ends with the first violation
};
int RunCheck(const CheckOptions& options);

/// Cases by yardsticks.
struct CompareOptions {
  std::vector<std::string> subjects;
  std::vector<std::string> scenes;             ///< rows: scene files; empty: families
  std::vector<std::string> families;           ///< rows: these alone; empty: all
  std::vector<std::string> by{"own", "real"};  ///< columns: these, or names of other subjects
  std::vector<std::string> modes;              ///< rows: floating-point modes of the subject itself
  std::string profile;                         ///< judge by this one instead of the subject's own
  bool device = false;                         ///< with the numbers of its device in it
  props::CampaignOptions campaign;
  std::size_t list_length = 0;  ///< 0: the subject's own
  FailOn fail_on = FailOn::kStated;
  std::string save;  ///< folder for the worst case of each cell that fails
  std::string json;  ///< file; empty: none
  int jobs = 1;      ///< rows at once
};
int RunCompare(const CompareOptions& options);

/// Cases `first` to `end` - 1 of a campaign.
struct CaseRange {
  std::uint64_t first = 0;
  std::uint64_t end = 0;

  friend bool operator==(const CaseRange&, const CaseRange&) = default;
};

struct CertifyOptions {
  std::vector<std::string> subjects;
  std::string profile;  ///< judge by this one; empty: by each subject's own
  bool all = false;
  std::string scene_set;  ///< file; empty: scenes/certify.json, which lies beside the command
  std::string output = "out";
  std::string bench;       ///< file that bench --json wrote, for the page; empty: none
  std::string survey;      ///< folder of what survey --json wrote, for the page; empty: none
  bool catalogue = false;  ///< the matrix of stiff and extreme cases on the page
  props::CampaignOptions campaign;
  /// Only these cases, as a part. `campaign.cases` plays no role.
  std::optional<CaseRange> range;
  std::string shard;                ///< only this shard, as a part: "2/5" or "auto"; empty: all
  std::vector<std::string> worlds;  ///< small worlds, every case of which is run
  int jobs = 1;                     ///< properties or scenes at once
  FailOn fail_on = FailOn::kStated;
  /// Files of parts of one subject's campaign, to be put together (RunMerge): no case is run.
  std::vector<std::string> parts;
};
int RunCertify(const CertifyOptions& options);
/// The subject is the one that the parts name unless the options name one.
int RunMerge(const CertifyOptions& options);

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
  props::CampaignOptions campaign{.cases = 2000};
  std::string json;  ///< file; empty: none
  std::string save;  ///< folder for the cases found
  int jobs = 1;      ///< domains at once
};
int RunSurvey(const SurveyOptions& options);

/// A saved case, or the name of a drawn one.
struct CaseChoice {
  std::string path;  ///< or the case itself, as JSON
  std::string subject;
  std::string property;
  std::string profile;  ///< judge by this one; empty: the file's, or the subject's own
  std::string name;     ///< of a drawn case: "near-edge:17@1"
  std::string typed;    ///< the command line as the user gave it, quoted for a shell
  /// The file is a fuzz input, as a fuzzer saves it, whatever it looks like.
  bool is_fuzz_input = false;
  std::size_t list_length = 0;  ///< 0: the subject's own
};

struct ReplayOptions {
  CaseChoice choice;
  std::string shrink;  ///< file for the smallest case that still fails; empty: as it is
  std::uint64_t evaluations = 10000;
  std::string as{};  ///< of report::kCodeLanguages: print the case so; empty: the verdict
};
int RunReplay(const ReplayOptions& options);

struct ExplainOptions {
  CaseChoice choice;
  int x = -1;
  int y = -1;
  std::string svg;
  std::string png;
  bool colour = false;
  std::string as;  ///< as of ReplayOptions
};
int RunExplain(const ExplainOptions& options);

/// A search for the largest error over its bound.
struct ClimbOptions {
  std::string subject = "f32-direct";
  std::string property = "EdgeErrorStaysWithinItsBound";
  std::uint64_t seed = 1;
  std::uint64_t evaluations = 20'000;
  std::string from;    ///< a case file to set out from as well; empty: drawn cases alone
  std::string output;  ///< file; empty: none
};
int RunClimb(const ClimbOptions& options);

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

/// A case as a file of another kind.
struct ConvertOptions {
  CaseChoice choice;
  std::string to;  ///< "case" or "fuzz-input"
  std::string output = "-";
};
int RunConvert(const ConvertOptions& options);

/// What goes through a pipe by hand: pipe ask | PROGRAM | pipe judge.
struct PipeOptions {
  std::string property = "CoverageEqualsTheModel";
  std::string description;  ///< file; empty: what is assumed of a program that says nothing
  std::string profile;      ///< in place of the description's
  props::CampaignOptions campaign;
};
int RunAsk(const PipeOptions& options);
int RunJudge(const PipeOptions& options);

/// A program that does not run here, asked in rounds.
struct RoundsOptions {
  std::string folder;       ///< of the rounds' files
  std::string description;  ///< file; empty: what is assumed of a program that says nothing
  std::string profile;      ///< in place of the description's
};

struct ShrinkRoundsOptions {
  RoundsOptions rounds;
  CaseChoice choice;   ///< its subject and its profile play no role
  std::string output;  ///< file for the smallest case
  std::uint64_t evaluations = 10000;
};
int RunShrinkRounds(const ShrinkRoundsOptions& options);

struct InferRoundsOptions {
  RoundsOptions rounds;
  std::uint64_t seed = 1;
  std::string json;  ///< file; empty: none
};
int RunInferRounds(const InferRoundsOptions& options);

/// Cases as files, for test benches that do not run this program.
struct GenerateOptions {
  std::string profile;
  std::uint64_t seed = 1;
  int level = 1;
  std::uint64_t cases = 0;       ///< 0: as many as the level has
  std::string world;             ///< "3.2": every triangle of it; empty: drawn cases
  bool yes = false;              ///< however long that takes
  std::string format = "jsonl";  ///< or "c", "readmemh"
  std::string output = "-";      ///< file; of readmemh a folder
};
int RunGenerate(const GenerateOptions& options);

/// Judges what a rasterizer covered of the cases of such a file.
struct VerifyOptions {
  std::string vectors;
  std::string answers;  ///< file; empty: `subject` draws
  std::string subject;  ///< empty: `answers` is given
  bool alone = false;   ///< each triangle was drawn in a call of its own
  std::uint64_t shown = 20;
};
int RunVerify(const VerifyOptions& options);

/// Builds of a rasterizer by several compilers and flags.
struct SweepOptions {
  std::vector<std::string> sources;
  std::string cflags;               ///< words of a shell, for every build
  std::vector<std::string> builds;  ///< those to compare with the base; empty: the usual list
  std::string profile;
  std::uint64_t seed = 1;
  std::uint64_t cases = 200;
  double seconds = 30;  ///< of one compilation, or of one answer
  std::string json;     ///< file; empty: none
  int jobs = 1;         ///< builds at once
};
int RunSweep(const SweepOptions& options);

struct SelftestOptions {
  std::vector<std::string> only;  ///< names; empty: every mutant and legal variant
  std::uint64_t seed = 1;
  std::uint64_t cases = 1000;  ///< most cases a property
  std::string json;
  int jobs = 1;         ///< mutants and variants at once
  bool causes = false;  ///< of mutants alone: is what explains them found?
};
int RunSelftest(const SelftestOptions& options);

/// How many bits the values of an integer edge function take.
struct WidthsOptions {
  std::string fixed;  ///< "12.4"
  bool is_signed = true;
  std::string target;                  ///< "4096x4096"
  std::string samples = "standard-1";  ///< or a list, as the profile key sample_locations
  int tile = 8;
  std::string json;  ///< file; empty: none
  std::string save;  ///< folder for the inputs as cases; empty: none
};
int RunWidths(const WidthsOptions& options);

int RunDoctor();

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_COMMANDS_H_
