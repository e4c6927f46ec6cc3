// Options are parsed here, in one translation unit; VERB/cmd_*.cc do the work.
#include "tool/command_line.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <new>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "CLI/CLI.hpp"
#include "core/call_end.h"
#include "core/error.h"
#include "core/suggestion.h"
#include "fmt/format.h"
#include "report/case_code.h"
#include "report/text.h"
#include "subjects/builtin/builtin.h"
#include "subjects/mutants/mutants.h"
#include "tool/bench/cmd_bench.h"
#include "tool/browser/cmd_browser.h"
#include "tool/case/cmd_case.h"
#include "tool/case_choice.h"
#include "tool/certify/shard.h"
#include "tool/climb/cmd_climb.h"
#include "tool/doctor/cmd_doctor.h"
#include "tool/exit_status.h"
#include "tool/infer/cmd_infer.h"
#include "tool/interrupt.h"
#include "tool/list/cmd_list.h"
#include "tool/outside.h"
#include "tool/progress.h"
#include "tool/selftest/cmd_selftest.h"
#include "tool/shell.h"
#include "tool/subject_kinds.h"
#include "tool/survey/cmd_survey.h"
#include "tool/sweep/cmd_sweep.h"
#include "tool/typed_number.h"
#include "tool/verb_options.h"
#include "tool/workers.h"

namespace rasterproof::tool {
namespace {

void AddCase(CLI::App* app, CaseChoice& choice) {
  app->add_option("case", choice.path,
                  "Case file, scene file, inline JSON or fuzz input (- for standard input)");
  AddSubject(app, choice.subject, "Subject (default: the file's)");
  app->add_option("--property", choice.property, "Property (default: the file's)");
  app->add_option("--profile", choice.profile,
                  "Judge by this profile (default: the file's, or the subject's own)");
  app->add_option("--case", choice.name, std::string(kCaseHelp));
  app->add_flag("--fuzz-input", choice.is_fuzz_input,
                "Read the file as a fuzz input even if it looks like text");
  AddListLength(app, choice.list_length);
}

// Every verb adds its options and what is to be run. The option structures live as long as the
// program.

void AddList(CLI::App& app, Run& run) {
  static ListOptions options;
  CLI::App* verb =
      app.add_subcommand("list", "List subjects, properties, domains, profiles and their keys");
  verb->add_option("what", options.what, "What to list; all omits keys and clauses")
      ->check(CLI::IsMember({"subjects", "properties", "domains", "worlds", "profiles", "mutants",
                             "keys", "clauses", "all"}))
      ->capture_default_str();
  verb->add_option("prefix", options.prefix,
                   "List only clauses whose names begin so: vulkan, gl.common-edge");
  verb->add_flag("--json", options.json, "Print clauses as JSON");
  verb->add_option("--subject", options.subject, "List only properties that apply to this subject");
  verb->callback([&run] { run = [] { return RunList(options); }; });
}

void AddInfer(CLI::App& app, Run& run, const std::string& own) {
  static InferOptions options;
  options.subject = own;
  CLI::App* verb =
      app.add_subcommand("infer", "Find by experiment the model that a subject follows");
  AddSubject(verb, options.subject);
  verb->add_option("--profile", options.profile,
                   "Verify this profile's statements, not the subject's own");
  AddSeed(verb, options.seed, "experiments");
  verb->add_option("--json", options.json, "Result as JSON (- for standard output)");
  verb->callback([&run] { run = [] { return RunInfer(options); }; });
}

void AddSurvey(CLI::App& app, Run& run, const std::string& own) {
  static SurveyOptions options;
  options.subject = own;
  CLI::App* verb = app.add_subcommand(
      "survey", "Count how a subject differs from its nearest model, without a verdict");
  AddSubject(verb, options.subject);
  verb->add_option("--profile", options.profile,
                   "Draw cases for this profile, not for the subject's own");
  AddCampaign(verb, options.campaign, "domain");
  verb->add_option("--json", options.json, "Result as JSON (- for standard output)");
  verb->add_option("--save", options.save, "Folder for the worst case of each cell that fails");
  AddJobs(verb, options.jobs, "Domains");
  verb->callback([&run] { run = [] { return UntilInterrupted(RunSurvey, options); }; });
}

CLI::Option* AddAs(CLI::App* verb, std::string& as) {
  const std::vector<std::string> languages(report::kCodeLanguages.begin(),
                                           report::kCodeLanguages.end());
  return verb->add_option("--as", as, "Print the case as code for a test, below the verdict")
      ->check(CLI::IsMember(languages));
}

void AddReplay(CLI::App& app, Run& run, const std::string& typed) {
  static ReplayOptions options;
  options.choice.typed = typed;
  CLI::App* verb =
      app.add_subcommand("replay", "Run one case again, or find a smaller one that still fails");
  AddCase(verb, options.choice);
  CLI::Option* const shrink =
      verb->add_option("--shrink", options.shrink,
                       "File for the smallest case that still fails (- for standard output)");
  verb->add_option("--evaluations", options.evaluations, "Maximum evaluations while shrinking")
      ->capture_default_str()
      ->needs(shrink);
  AddAs(verb, options.as);
  verb->callback([&run] {
    run = [] {
      return options.shrink.empty() ? RunReplay(options) : UntilInterrupted(RunReplay, options);
    };
  });
}

void AddConvert(CLI::App& app, Run& run, const std::string& typed) {
  static ConvertOptions options;
  options.choice.typed = typed;
  CLI::App* verb = app.add_subcommand(
      "convert", "Write a fuzz input as a case file, or a case or scene as a fuzz input");
  AddCase(verb, options.choice);
  verb->add_option("--to", options.to, "Format to write")
      ->check(CLI::IsMember({"case", "fuzz-input"}))
      ->required();
  verb->add_option("-o,--output", options.output, "File")->capture_default_str();
  verb->callback([&run] { run = [] { return RunConvert(options); }; });
}

void AddExplain(CLI::App& app, Run& run, const std::string& typed) {
  static ExplainOptions options;
  options.choice.typed = typed;
  CLI::App* verb =
      app.add_subcommand("explain", "Show the pixels where a case fails, with exact edge values");
  AddCase(verb, options.choice);
  verb->add_option_function<std::vector<int>>(
          "--pixel",
          [](const std::vector<int>& at) {
            options.x = at[0];
            options.y = at[1];
          },
          "Column and row (from the top) to show")
      ->expected(2)
      ->delimiter(',');
  verb->add_option("--svg", options.svg, "Picture as SVG");
  verb->add_option("--png", options.png, "Picture as PNG");
  verb->add_flag("--colour", options.colour, "Colours in the terminal");
  CLI::Option* const as = AddAs(verb, options.as);
  for (const char* const picture : {"--pixel", "--svg", "--png", "--colour"}) {
    as->excludes(verb->get_option(picture));
  }
  verb->callback([&run] { run = [] { return RunExplain(options); }; });
}

void AddClimb(CLI::App& app, Run& run) {
  static ClimbOptions options;
  CLI::App* verb =
      app.add_subcommand("climb", "Search for the case with the largest error over its bound");
  AddSubject(verb, options.subject);
  verb->add_option("--property", options.property, "Property with a bound")->capture_default_str();
  AddSeed(verb, options.seed, "search");
  verb->add_option("--evaluations", options.evaluations, "Cases to judge")
      ->check(Positive())
      ->capture_default_str();
  verb->add_option("--from", options.from, "Case file to start from, besides generated cases");
  verb->add_option("-o,--output", options.output, "Case file (- for standard output)");
  verb->callback([&run] { run = [] { return UntilInterrupted(RunClimb, options); }; });
}

void AddBench(CLI::App& app, Run& run, const std::string& typed) {
  static BenchOptions options;
  options.command = typed;
  CLI::App* verb = app.add_subcommand("bench", "Measure error against run time");
  verb->add_option("--family", options.families, "Families (default: all)");
  verb->add_option("--scene", options.scenes, "Scene files or meshes to add to the families");
  verb->add_option("--subject", options.subjects, "Built-in methods and kernels (default: all)");
  verb->add_option("--plugin", options.plugins, "Plugins to time too, in this process");
  verb->add_option("--exec", options.programs, "Programs to time too, on a pipe");
  verb->add_option("--target", options.target,
                   "Draw by kernels of this instruction set alone: avx2, avx512, ...");
  CLI::Option* limits = verb->add_flag("--limits", options.limits,
                                       "Find how far each method is right; measure no times");
  verb->add_option("--save", options.save, "Folder for the failing case of each limit")
      ->needs(limits);
  verb->add_flag("--values", options.values,
                 "Only measure how interpolated values err, and what they cost")
      ->excludes(limits);
  verb->add_option_function<std::string>(
          "--budget",
          [](const std::string& text) { options.budget = ParseSeconds("--budget", text); },
          "Time for the whole run, such as 90s or 10m; families have full size from 3m on")
      ->default_str("60s");
  AddSeed(verb, options.seed, "families");
  verb->add_option(
      "--against", options.against,
      "File of an earlier --json: report changes since; status 1 if anything got worse");
  verb->add_option(
      "--from", options.from,
      "File of an earlier --json: report it instead of measuring, or add --values to it");
  verb->add_flag("--growth", options.growth,
                 "Only measure times over 10^2 to 10^7 triangles, the target's side and threads")
      ->excludes(limits)
      ->excludes("--values")
      ->excludes("--from");
  verb->add_option("--json", options.json, "Result as JSON, raw times included");
  verb->add_option("--svg", options.svg, "Plot of error against run time, one panel per family");
  CLI::Option* fingerprint =
      verb->add_flag("--fingerprint", options.fingerprint,
                     "Only test one sample, with an edge's end at 256 x 256 neighbouring places")
          ->excludes(limits);
  verb->add_option("--out", options.folder, "Folder for the pictures: NAME-STEP.png")
      ->needs(fingerprint);
  verb->add_option("--width", options.width, "Of the target of meshes")->check(Positive());
  verb->add_option("--height", options.height, "Of the target of meshes")->check(Positive());
  verb->callback([&run] { run = [] { return RunBench(options); }; });
}

void AddSweep(CLI::App& app, Run& run) {
  static SweepOptions options;
  CLI::App* verb = app.add_subcommand(
      "sweep",
      "Find the builds (compilers, flags, targets) that change what your rasterizer covers");
  verb->add_option("sources", options.sources,
                   "C or C++ sources of a plugin (kit/rasterproof_plugin.h)")
      ->required();
  verb->add_option("--cflags", options.cflags,
                   "Flags for every build, in shell syntax: -I, -D, -std, libraries");
  verb->add_option("--build", options.builds,
                   "Compare only this build with the base: \"clang -O3\", \"i386\", \"aarch64 "
                   "-ffp-contract=fast\" (repeatable; default: about 40)")
      ->allow_extra_args(false);
  verb->add_option("--profile", options.profile, "Draw cases for this profile, not for its own");
  AddSeed(verb, options.seed);
  verb->add_option("--cases", options.cases, "Cases that every build draws")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  verb->add_option("--time-limit", options.seconds,
                   "Time limit in seconds for a compilation or an answer")
      ->check(Positive())
      ->capture_default_str();
  verb->add_option("--json", options.json, "Result as JSON (- for standard output)");
  AddJobs(verb, options.jobs, "Builds");
  verb->callback([&run] { run = [] { return UntilInterrupted(RunSweep, options); }; });
}

void AddSelftest(CLI::App& app, Run& run) {
  static SelftestOptions options;
  CLI::App* verb =
      app.add_subcommand("selftest", "Check that planted bugs are found and legal variants pass");
  AddSeed(verb, options.seed, "generators (legal variants take the next two as well)");
  verb->add_option("--cases", options.cases,
                   "Maximum cases per property; legal variants get a tenth")
      ->check(Positive())
      ->capture_default_str();
  verb->add_option("--only", options.only, "Mutants and legal variants (default: all)");
  verb->add_option("--json", options.json, "Result as JSON");
  verb->add_flag("--causes", options.causes,
                 "Explain each mutant's violation and compare with its planted bug");
  AddJobs(verb, options.jobs, "Mutants or legal variants");
  verb->callback([&run] { run = [] { return RunSelftest(options); }; });
}

void AddDoctor(CLI::App& app, Run& run) {
  CLI::App* verb =
      app.add_subcommand("doctor", "Check that this machine and build can be trusted to judge");
  verb->callback([&run] { run = [] { return RunDoctor(); }; });
}

void AddBrowser(CLI::App& app, Run& run) {
  CLI::App* verb =
      app.add_subcommand("browser", "Open the page that judges a GPU by WebGL2 or WebGPU");
  verb->callback([&run] { run = [] { return RunBrowser(); }; });
}

// A standard file that the caller closed would give its number to the next file that is opened.
// Nothing is to be read there and nothing to be written; only complaints may get lost.
void OpenStandardFiles() {
  for (int n = STDIN_FILENO; n <= STDERR_FILENO; ++n) {
    if (fcntl(n, F_GETFD) < 0) open("/dev/null", n == STDERR_FILENO ? O_WRONLY : O_RDONLY);
  }
}

// Verbs and options of earlier versions, and what to write now.
constexpr auto kFormer = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"check --catalogue", "compare"},
    {"check --family", "compare --families NAME"},
    {"check --fp-env", "compare --mode ftz"},
    {"decided", "legal SCENE --decided --profile P"},
    {"decode", "convert FILE --to case --subject S"},
    {"diff", "coverage SCENE --subject S --against exact"},
    {"encode", "convert FILE --to fuzz-input --subject S"},
    {"gen", "check --subject rounds:FOLDER"},
    {"host", "pipe answer plugin:PATH"},
    {"merge", "certify --merge PART..."},
    {"pipe ask", "check --subject rounds:FOLDER"},
    {"pipe infer", "infer --subject rounds:FOLDER"},
    {"pipe judge", "check --subject rounds:FOLDER"},
    {"pipe shrink", "replay CASE --shrink FILE --subject rounds:FOLDER"},
    {"render", "coverage SCENE --mode flat --png FILE"},
    {"shrink", "replay CASE --shrink FILE"},
    {"ver", "check --subject rounds:FOLDER"},
});

void RequireNotFormer(const std::string& place, const std::string& words) {
  for (const auto& [old, now] : kFormer) {
    if (words != old) continue;
    throw InputError(place,
                     fmt::format("{} is now a part of {}", words, now.substr(0, now.find(' '))),
                     fmt::format("write rasterproof {}", now));
  }
}

// Left to itself the parser would say that a verb is missing, not that this one is unknown.
void RequireVerb(const CLI::App& app, const std::string& name) {
  std::vector<std::string> verbs;
  for (const CLI::App* verb : app.get_subcommands({})) verbs.push_back(verb->get_name());
  if (std::ranges::find(verbs, name) != verbs.end()) return;
  const std::string place = fmt::format("verb '{}'", name);
  RequireNotFormer(place, name);
  throw InputError(place, "there is no such verb",
                   Suggestion(name, verbs) + "rasterproof --help lists them");
}

// A line for the option, or the word of a list, that may be meant; "" if none is near.
std::string NearestMeant(const CLI::App& app, const std::string& error) {
  const auto line = [](const std::string& suggestion) {
    return suggestion.empty() ? "" : suggestion.substr(0, suggestion.size() - 1) + "\n";
  };
  const auto list = error.find(" not in {");
  if (list != std::string::npos) {
    std::vector<std::string> words;
    std::stringstream rest(error.substr(list + 9, error.find('}', list) - list - 9));
    for (std::string word; std::getline(rest, word, ',');) words.push_back(word);
    const auto begin = error.rfind(' ', list - 1);
    return line(Suggestion(error.substr(begin + 1, list - begin - 1), words));
  }
  const auto option = error.find(": --");
  if (option == std::string::npos || error.find("not expected") == std::string::npos) return "";
  std::vector<std::string> names;
  for (const CLI::App* verb = &app; verb != nullptr;) {
    std::vector<const CLI::App*> groups =
        verb->get_subcommands([](const CLI::App* one) { return one->get_name().empty(); });
    groups.push_back(verb);
    for (const CLI::App* group : groups) {
      for (const CLI::Option* one : group->get_options()) {
        for (const std::string& name : one->get_lnames()) names.push_back("--" + name);
      }
    }
    const std::vector<CLI::App*> next = verb->get_subcommands();
    verb = next.empty() ? nullptr : next.front();
  }
  return line(Suggestion(
      error.substr(option + 2, error.find_first_of(" ,", option + 2) - option - 2), names));
}

int Parse(int argc, char** argv, const std::string& own) {
  CLI::App app{"rasterproof: certify triangle rasterizers against exact arithmetic"};
  app.require_subcommand(1);
  // Of an option that is given twice the last one counts: scripts add theirs behind.
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.set_version_flag("--version", "rasterproof " RASTERPROOF_VERSION);
  Run run;
  const std::string typed = CommandLine(argc, argv);
  const auto end_group = [&app](const std::string& name) {
    for (CLI::App* verb : app.get_subcommands(
             [](const CLI::App* one) { return one->get_group() == "Subcommands"; })) {
      verb->group(name);
    }
  };
  AddCheck(app, run, own);
  AddExplain(app, run, typed);
  AddReplay(app, run, typed);
  AddInfer(app, run, own);
  AddCertify(app, run, own);
  AddList(app, run);
  AddBrowser(app, run);
  end_group("Every day");
  AddSceneVerbs(app, run);
  end_group("One scene");
  AddCompare(app, run, own);
  AddSurvey(app, run, own);
  AddBench(app, run, typed);
  AddClimb(app, run);
  AddSweep(app, run);
  AddPipeVerb(app, run);
  AddVectorsVerb(app, run);
  end_group("Campaign");
  AddConvert(app, run, typed);
  AddSelftest(app, run);
  AddWidthsVerb(app, run);
  AddDoctor(app, run);
  end_group("Development");
  if (argc > 1 && argv[1][0] != '-') RequireVerb(app, argv[1]);
  for (int k = 2; k < argc; ++k) {
    const std::string_view option = argv[k];
    RequireNotFormer(argv[1], fmt::format("{} {}", argv[1], option.substr(0, option.find('='))));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int status = app.exit(error) == 0 ? kExitHolds : kExitUsage;
    if (status != kExitHolds) std::cerr << NearestMeant(app, error.what());
    return status;
  }
  return run();
}

}  // namespace

int RunCommandLine(int argc, char** argv, const std::string& own) {
  // A closed pipe is an error that is reported, not a signal that kills.
  std::signal(SIGPIPE, SIG_IGN);
  OpenStandardFiles();
  Kinds() = {{{subjects::IsBuiltin, subjects::MakeBuiltin, subjects::BuiltinNames},
              {subjects::IsMutant, subjects::MakeMutant, nullptr}},
             ResolveOutside,
             MakeInHost,
             InfoOfProgram};
  try {
    return Parse(argc, argv, own);
  } catch (const InputError& error) {
    // The words of a file or a program may be in it: nothing of theirs steers the terminal.
    std::cerr << "rasterproof: " << report::CleanText(error.what()) << '\n';
    return kExitUsage;
  } catch (const SubjectStop& stop) {
    const std::string why = report::CleanText(stop.what());
    if (!EndsTheCall(stop.stop())) {
      std::cerr << "rasterproof: " << why << '\n';
      return kExitUsage;
    }
    if (IsBreakdown(stop.stop())) {
      std::cerr << "rasterproof: the subject failed: " << why << '\n';
      return kExitViolated;
    }
    std::cerr << "rasterproof: the subject could not be judged: " << why << '\n';
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
