// Options are parsed here, in one translation unit; cmd_*.cc do the work.
#include "tool/command_line.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <new>
#include <string>
#include <vector>

#include "CLI/CLI.hpp"
#include "core/error.h"
#include "core/subject_errors.h"
#include "core/suggestion.h"
#include "fmt/format.h"
#include "report/text.h"
#include "tool/commands.h"
#include "tool/interrupt.h"
#include "tool/outside.h"
#include "tool/progress.h"
#include "tool/shard.h"
#include "tool/shell.h"
#include "tool/typed_number.h"
#include "tool/verb_options.h"
#include "tool/workers.h"

namespace rasterproof::tool {
namespace {

void AddSubjects(CLI::App* app, std::vector<std::string>& subjects) {
  CLI::Option* const named =
      app->add_option("--subject", subjects, "Subjects")->capture_default_str();
  // The first one from outside takes the place of the default.
  bool replace = true;
  AddOutside(app, [&subjects, named, replace](const std::string& name) mutable {
    if (replace && named->count() == 0) subjects.clear();
    replace = false;
    subjects.push_back(name);
  });
}

void AddSeed(CLI::App* app, CampaignChoice& campaign) {
  app->add_option_function<std::string>(
         "--seed", [&](const std::string& text) { campaign.seed = ParseSeed(text); },
         "Seed of the generators, or 'random' (the one taken is printed)")
      ->default_str("1");
}

void AddSeconds(CLI::App* app, CampaignChoice& campaign, const std::string& of) {
  app->add_option("--seconds", campaign.seconds, "Most seconds a " + of + " (0: no limit)")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

void AddCampaign(CLI::App* app, CampaignChoice& campaign, const std::string& of = "property") {
  AddSeed(app, campaign);
  app->add_option("--cases", campaign.cases, "Cases a " + of)
      ->check(Positive())
      ->capture_default_str();
  AddSeconds(app, campaign, of);
}

void AddCount(CLI::App* app, const std::string& option, const std::string& help, int most,
              const std::function<void(int)>& take, int usual) {
  const auto parse = [=](const std::string& text) { take(ParseCount(option, text, most)); };
  app->add_option_function<std::string>(option, parse, help)
      ->type_name("COUNT")
      ->default_str(std::to_string(usual));
}

void AddJobs(CLI::App* app, int& jobs, const std::string& what) {
  jobs = DefaultJobs();
  AddCount(
      app, "--jobs", what + " at once (default: as many as there are cores)", kMostJobs,
      [&jobs](int count) { jobs = count; }, jobs);
}

constexpr std::string_view kCaseHelp = "Drawn case, by its name DOMAIN:INDEX@SEED (near-edge:17@1)";

void AddCase(CLI::App* app, CaseChoice& choice) {
  app->add_option("case", choice.path,
                  "Case or scene file, or what a fuzzer saved (- for standard input)");
  AddSubject(app, choice.subject, "Subject (default: the one the file names)");
  app->add_option("--property", choice.property, "Property (default: the one the file names)");
  app->add_option("--profile", choice.profile,
                  "Judge by this profile (default: the file's, or the subject's own)");
  app->add_option("--case", choice.name, std::string(kCaseHelp));
  app->add_flag("--fuzz-input", choice.is_fuzz_input,
                "The file is a fuzz input, though it looks like text");
}

void AddPipe(CLI::App* app, PipeOptions& options) {
  app->add_option("--property", options.property, "Property to put to the test")
      ->capture_default_str();
  app->add_option("--description", options.description,
                  "File that says what the program states (docs/subjects.md)");
  app->add_option("--profile", options.profile, "Judge by this profile, not by the description's");
  AddCampaign(app, options.campaign);
}

// For verbs that say what they know so far when they are interrupted. Any other one ends at once,
// as programs do.
int UntilInterrupted(const Run& verb) {
  CatchInterrupts();
  const int status = verb();
  return Interrupted() ? InterruptStatus() : status;
}

// Every verb adds its options and what is to be run. The option structures live as long as the
// program.

void AddList(CLI::App& app, Run& run) {
  static ListOptions options;
  CLI::App* verb =
      app.add_subcommand("list", "Subjects, properties, domains, profiles and their keys");
  verb->add_option("what", options.what,
                   "What; all leaves out profile keys and clauses, which are many")
      ->check(CLI::IsMember({"subjects", "properties", "domains", "worlds", "profiles", "mutants",
                             "keys", "clauses", "all"}))
      ->capture_default_str();
  verb->add_flag("--json", options.json, "Clauses as JSON");
  verb->callback([&run] { run = [] { return RunList(options); }; });
}

void AddFailOn(CLI::App* verb, FailOn& fail_on) {
  verb->add_option("--fail-on", fail_on, "Violations that fail: of what is stated, or of quality")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, FailOn>{{"stated", FailOn::kStated},
                                                                {"quality", FailOn::kQuality}})
              .description("{stated,quality}"))
      ->default_str("stated");
}

void AddCheck(CLI::App& app, Run& run, const std::string& own) {
  static CheckOptions options;
  options.subjects = {own};
  CLI::App* verb = app.add_subcommand(
      "check", "The properties, on generated cases, given scenes or cases by their names");
  verb->add_option("scenes", options.scenes, "Scene or case files (default: generated cases)");
  verb->add_option("--case", options.named, std::string(kCaseHelp))->allow_extra_args(false);
  AddSubjects(verb, options.subjects);
  verb->add_option("--property", options.properties, "Properties (default: all)");
  verb->add_option("--profile", options.profile, "Judge by this profile, not by the subject's own");
  verb->add_flag("--device", options.device,
                 "Put the subject's numbers into the legal set that --profile names: its subpixel "
                 "bits, sample locations, coordinate limit and guard band");
  verb->add_option("--save", options.save,
                   "Folder for shrunk counterexamples; those already there are replayed first");
  AddCampaign(verb, options.campaign);
  AddJobs(verb, options.jobs, "Properties");
  AddFailOn(verb, options.fail_on);
  AddCount(
      verb, "--batch", "Cases whose draws share calls, of a subject outside", kMostInABatch,
      [](int count) { options.batch = static_cast<std::size_t>(count); },
      static_cast<int>(options.batch));
  verb->callback(
      [&run] { run = [] { return UntilInterrupted([] { return RunCheck(options); }); }; });
}

void AddCertify(CLI::App& app, Run& run, const std::string& own) {
  static CertifyOptions options;
  options.subjects = {own};
  options.campaign.cases = 100;
  CLI::App* verb = app.add_subcommand("certify", "Certificate, JUnit file and report page");
  AddSubjects(verb, options.subjects);
  verb->add_flag(
      "--all", options.all,
      "Every built-in subject; the exit status then covers only those stated to be exact");
  verb->add_option("--scenes", options.scene_set, "Scene set to measure")
      ->default_str("scenes/certify.json beside the command");
  verb->add_option("-o,--out", options.output, "Folder")->capture_default_str();
  verb->add_option(
      "--bench", options.bench,
      "File that bench --json wrote: the page then begins with error against run time");
  AddSeed(verb, options.campaign);
  verb->add_option_function<std::string>(
          "--cases", [](const std::string& text) { ParseCases(text, options); },
          "Cases a property; A..B: those alone, A to B - 1, as a part for merge")
      ->default_str("100");
  AddSeconds(verb, options.campaign, "property");
  verb->add_option("--shard", options.shard,
                   "This shard alone, as a part for merge: I/N, or auto: as the variables of "
                   "GoogleTest, a Slurm array or Open MPI say");
  verb->add_option("--exhaustive", options.worlds,
                   "Small world, every case of which is run as well ('list worlds' names them)")
      ->allow_extra_args(false);
  AddJobs(verb, options.jobs, "Properties, worlds or scenes");
  AddFailOn(verb, options.fail_on);
  verb->callback(
      [&run] { run = [] { return UntilInterrupted([] { return RunCertify(options); }); }; });
}

void AddMerge(CLI::App& app, Run& run) {
  static MergeOptions options;
  CLI::App* verb =
      app.add_subcommand("merge", "The certificate of a campaign that was run in parts");
  verb->add_option("parts", options.parts, "Files that certify --shard or --cases A..B wrote")
      ->required();
  AddSubject(verb, options.subject, "Subject (default: the one the parts name)");
  verb->add_option("--scenes", options.scene_set, "Scene set to measure")
      ->default_str("scenes/certify.json beside the command");
  verb->add_option("-o,--out", options.output, "Folder")->capture_default_str();
  AddJobs(verb, options.jobs, "Scenes");
  AddFailOn(verb, options.fail_on);
  verb->callback(
      [&run] { run = [] { return UntilInterrupted([] { return RunMerge(options); }); }; });
}

void AddInfer(CLI::App& app, Run& run, const std::string& own) {
  static InferOptions options;
  options.subject = own;
  CLI::App* verb =
      app.add_subcommand("infer", "The model that a subject follows, found by experiment");
  AddSubject(verb, options.subject);
  verb->add_option("--profile", options.profile,
                   "Verify this profile's statements, not the subject's own");
  verb->add_option_function<std::string>(
          "--seed", [](const std::string& text) { options.seed = ParseSeed(text); },
          "Seed of the experiments, or 'random'")
      ->default_str("1");
  verb->add_option("--json", options.json, "Result as JSON (- for standard output)");
  verb->callback([&run] { run = [] { return RunInfer(options); }; });
}

void AddSurvey(CLI::App& app, Run& run, const std::string& own) {
  static SurveyOptions options;
  options.subject = own;
  CLI::App* verb = app.add_subcommand(
      "survey", "How a subject differs from the model nearest to it, domain by domain");
  AddSubject(verb, options.subject);
  verb->add_option("--profile", options.profile,
                   "Draw cases for this profile, not for the subject's own");
  AddCampaign(verb, options.campaign, "domain");
  verb->add_option("--json", options.json, "Result as JSON (- for standard output)");
  verb->add_option("--save", options.save, "Folder for the first case of each kind, shrunk");
  AddJobs(verb, options.jobs, "Domains");
  verb->callback(
      [&run] { run = [] { return UntilInterrupted([] { return RunSurvey(options); }); }; });
}

void AddReplay(CLI::App& app, Run& run, const std::string& typed) {
  static ReplayOptions options;
  options.choice.typed = typed;
  CLI::App* verb = app.add_subcommand("replay", "Run one case again, saved or generated");
  AddCase(verb, options.choice);
  verb->callback([&run] { run = [] { return RunReplay(options); }; });
}

void AddExplain(CLI::App& app, Run& run, const std::string& typed) {
  static ExplainOptions options;
  options.choice.typed = typed;
  CLI::App* verb =
      app.add_subcommand("explain", "The pixel grid at the failing place, with exact edge values");
  AddCase(verb, options.choice);
  verb->add_option_function<std::vector<int>>(
          "--pixel",
          [](const std::vector<int>& at) {
            options.x = at[0];
            options.y = at[1];
          },
          "Column and row (from the top) to look at")
      ->expected(2)
      ->delimiter(',');
  verb->add_option("--svg", options.svg, "Picture as SVG");
  verb->add_option("--png", options.png, "Picture as PNG");
  verb->add_flag("--colour", options.colour, "Colours in the terminal");
  verb->callback([&run] { run = [] { return RunExplain(options); }; });
}

void AddShrink(CLI::App& app, Run& run, const std::string& typed) {
  static ShrinkOptions options;
  options.choice.typed = typed;
  CLI::App* verb = app.add_subcommand("shrink", "Make a failing case as small as it gets");
  AddCase(verb, options.choice);
  verb->add_option("-o,--output", options.output, "File")->capture_default_str();
  verb->add_option("--budget", options.budget, "Most evaluations")->capture_default_str();
  verb->callback(
      [&run] { run = [] { return UntilInterrupted([] { return RunShrink(options); }); }; });
}

void AddClimb(CLI::App& app, Run& run) {
  static ClimbOptions options;
  CLI::App* verb =
      app.add_subcommand("climb", "The case of the largest error over its bound, by a search");
  AddSubject(verb, options.subject);
  verb->add_option("--property", options.property, "Property with a bound")->capture_default_str();
  verb->add_option_function<std::string>(
          "--seed", [](const std::string& text) { options.seed = ParseSeed(text); },
          "Seed of the search, or 'random'")
      ->default_str("1");
  verb->add_option("--evaluations", options.evaluations, "Cases judged in all")
      ->check(Positive())
      ->capture_default_str();
  verb->add_option("-o,--output", options.output, "Case file (- for standard output)");
  verb->callback(
      [&run] { run = [] { return UntilInterrupted([] { return RunClimb(options); }); }; });
}

void AddBench(CLI::App& app, Run& run, const std::string& typed) {
  static BenchOptions options;
  options.command = typed;
  CLI::App* verb = app.add_subcommand("bench", "Error against run time, measured in one run");
  verb->add_option("--family", options.families, "Families (default: all)");
  verb->add_option("--scene", options.scenes, "Scene files or meshes beside the families");
  verb->add_option("--subject", options.subjects, "Built-in methods and kernels (default: all)");
  verb->add_option("--plugin", options.plugins, "Libraries that are timed too, in this process");
  verb->add_option("--exec", options.programs, "Programs that are timed too, on a pipe");
  CLI::Option* limits =
      verb->add_flag("--limits", options.limits, "Up to where each method is right, and no times");
  verb->add_option("--save", options.save, "Folder for the failing case of each limit")
      ->needs(limits);
  verb->add_option_function<std::string>(
          "--budget",
          [](const std::string& text) { options.budget = ParseSeconds("--budget", text); },
          "Time for everything, as 90s or 10m; from 3m on families have their full size")
      ->default_str("60s");
  verb->add_option_function<std::string>(
      "--seed", [](const std::string& text) { options.seed = ParseSeed(text); },
      "Seed of the families");
  verb->add_option("--against", options.against,
                   "File of an earlier --json: tell what changed since; status 1 if for the worse");
  verb->add_option("--from", options.from, "File of an earlier --json, in place of a new run");
  verb->add_option("--json", options.json, "Result as JSON, raw times included");
  verb->add_option("--svg", options.svg, "Picture: error against run time, a panel a family");
  CLI::Option* fingerprint =
      verb->add_flag("--fingerprint", options.fingerprint,
                     "Only look at one sample with an edge's end in 256 x 256 neighbouring places")
          ->excludes(limits);
  verb->add_option("--out", options.folder, "Folder for the pictures: NAME-STEP.png")
      ->needs(fingerprint);
  verb->add_option("--width", options.width, "Of the target of meshes")->check(Positive());
  verb->add_option("--height", options.height, "Of the target of meshes")->check(Positive());
  verb->callback([&run] { run = [] { return RunBench(options); }; });
}

void AddDecode(CLI::App& app, Run& run) {
  static DecodeOptions options;
  CLI::App* verb = app.add_subcommand("decode", "The case that a fuzz input stands for, as a file");
  verb->add_option("input", options.input, "Fuzz input (- for standard input)")->required();
  verb->add_option("--subject", options.subject, "Subject it was run on")->required();
  verb->add_option("--property", options.property, "Property it was run against");
  verb->add_option("-o,--output", options.output, "File")->capture_default_str();
  verb->callback([&run] { run = [] { return RunDecode(options); }; });
}

void AddEncode(CLI::App& app, Run& run, const std::string& typed) {
  static EncodeOptions options;
  options.choice.typed = typed;
  CLI::App* verb = app.add_subcommand("encode", "A case or scene as a fuzz input for a subject");
  AddCase(verb, options.choice);
  verb->add_option("-o,--output", options.output, "File")->capture_default_str();
  verb->callback([&run] { run = [] { return RunEncode(options); }; });
}

void AddSelftest(CLI::App& app, Run& run) {
  static SelftestOptions options;
  CLI::App* verb = app.add_subcommand(
      "selftest", "Whether the properties find planted bugs and let legal variants pass");
  verb->add_option_function<std::string>(
          "--seed", [](const std::string& text) { options.seed = ParseSeed(text); },
          "Seed of the generators; legal variants take the next two as well")
      ->default_str("1");
  verb->add_option("--cases", options.cases,
                   "Most cases a property; a tenth of them for legal variants")
      ->check(Positive())
      ->capture_default_str();
  verb->add_option("--only", options.only, "Mutants and legal variants (default: all)");
  verb->add_option("--json", options.json, "Result as JSON");
  AddJobs(verb, options.jobs, "Mutants or legal variants");
  verb->callback([&run] { run = [] { return RunSelftest(options); }; });
}

void AddDoctor(CLI::App& app, Run& run) {
  CLI::App* verb =
      app.add_subcommand("doctor", "Whether this machine and build can be trusted to judge");
  verb->callback([&run] { run = [] { return RunDoctor(); }; });
}

void AddGen(CLI::App& app, Run& run) {
  static PipeOptions options;
  CLI::App* verb = app.add_subcommand("gen", "Requests to draw, for a program's standard input");
  AddPipe(verb, options);
  verb->callback([&run] { run = [] { return RunGen(options); }; });
}

void AddVer(CLI::App& app, Run& run) {
  static PipeOptions options;
  CLI::App* verb =
      app.add_subcommand("ver", "Judge the answers to gen's requests, on standard input");
  AddPipe(verb, options);
  verb->callback([&run] { run = [] { return RunVer(options); }; });
}

void AddHost(CLI::App& app, Run& run) {
  static HostOptions options;
  CLI::App* verb = app.add_subcommand("host", "Answer requests by a plugin, on a pipe");
  verb->add_option("subject", options.subject, "plugin:PATH")->required();
  verb->add_flag("--describe", options.describe, "Say only what it states");
  verb->callback([&run] { run = [] { return HostSubject(options.subject, options.describe); }; });
}

// A standard file that the caller closed would give its number to the next file that is opened.
// Nothing is to be read there and nothing to be written; only complaints may get lost.
void OpenStandardFiles() {
  for (int n = STDIN_FILENO; n <= STDERR_FILENO; ++n) {
    if (fcntl(n, F_GETFD) < 0) open("/dev/null", n == STDERR_FILENO ? O_WRONLY : O_RDONLY);
  }
}

int Parse(int argc, char** argv, const std::string& own) {
  CLI::App app{"rasterproof: certify triangle rasterizers against exact arithmetic"};
  app.require_subcommand(1);
  app.set_version_flag("--version", "rasterproof " RASTERPROOF_VERSION);
  Run run;
  AddCheck(app, run, own);
  const std::string typed = CommandLine(argc, argv);
  AddExplain(app, run, typed);
  AddReplay(app, run, typed);
  AddInfer(app, run, own);
  AddSurvey(app, run, own);
  AddCertify(app, run, own);
  AddMerge(app, run);
  AddList(app, run);
  AddSceneVerbs(app, run);
  AddBench(app, run, typed);
  AddShrink(app, run, typed);
  AddClimb(app, run);
  AddDecode(app, run);
  AddEncode(app, run, typed);
  AddSelftest(app, run);
  AddGen(app, run);
  AddVer(app, run);
  AddHost(app, run);
  AddDoctor(app, run);
  // Left to itself the parser would say that a verb is missing, not that this one is unknown.
  const auto is_verb = [&](const std::string& name) {
    return !app.get_subcommands([&](const CLI::App* verb) { return verb->get_name() == name; })
                .empty();
  };
  if (argc > 1 && argv[1][0] != '-' && !is_verb(argv[1])) {
    std::vector<std::string> verbs;
    for (const CLI::App* verb : app.get_subcommands({})) verbs.push_back(verb->get_name());
    throw InputError(fmt::format("verb '{}'", argv[1]), "there is no such verb",
                     Suggestion(argv[1], verbs) + "rasterproof --help lists them");
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitHolds : kExitUsage;
  }
  return run();
}

}  // namespace

int RunCommandLine(int argc, char** argv, const std::string& own) {
  // A closed pipe is an error that is reported, not a signal that kills.
  std::signal(SIGPIPE, SIG_IGN);
  OpenStandardFiles();
  try {
    return Parse(argc, argv, own);
  } catch (const InputError& error) {
    // The words of a file or a program may be in it: nothing of theirs steers the terminal.
    std::cerr << "rasterproof: " << report::CleanText(error.what()) << '\n';
    return kExitUsage;
  } catch (const SubjectFault& fault) {
    std::cerr << "rasterproof: the subject failed: " << report::CleanText(fault.what()) << '\n';
    return kExitViolated;
  } catch (const SubjectTooSlow& slow) {
    std::cerr << "rasterproof: the subject was too slow to judge: "
              << report::CleanText(slow.what()) << '\n';
    return Interrupted() ? InterruptStatus() : kExitInconclusive;
  } catch (const std::bad_alloc&) {
    std::cerr << "rasterproof: not enough memory; use a smaller target or scene\n";
    return kExitUsage;
  } catch (const std::exception& error) {
    std::cerr << "rasterproof: fault of the program itself: " << error.what() << '\n';
    return kExitFault;
  }
}

}  // namespace rasterproof::tool
