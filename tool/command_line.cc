// The command line is parsed here; verbs add their own options (tool/verb.h).
#include "tool/command_line.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstddef>
#include <exception>
#include <iostream>
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
#include "report/text.h"
#include "subjects/builtin/builtin.h"
#include "subjects/mutants/mutants.h"
#include "tool/exit_status.h"
#include "tool/interrupt.h"
#include "tool/outside.h"
#include "tool/shell.h"
#include "tool/subject_kinds.h"
#include "tool/verb.h"

namespace rasterproof::tool {

// The build makes these of the rows of verbs.
extern const Verb* const kAllVerbs[];
extern const std::size_t kNumberOfVerbs;

namespace {

constexpr std::array<const char*, 4> kGroupTitles{"Every day", "One scene", "Campaign",
                                                  "Development"};

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

// In the order of --help.
std::vector<const Verb*> RowsInOrder() {
  std::vector<const Verb*> rows(kAllVerbs, kAllVerbs + kNumberOfVerbs);
  std::ranges::sort(rows, {}, [](const Verb* row) { return std::pair(row->group, row->place); });
  return rows;
}

int Parse(int argc, char** argv, const std::string& own) {
  CLI::App app{"rasterproof: certify triangle rasterizers against exact arithmetic"};
  app.require_subcommand(1);
  // Of an option that is given twice the last one counts: scripts add theirs behind.
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.set_version_flag("--version", "rasterproof " RASTERPROOF_VERSION);
  Run run;
  const Invocation call{own, CommandLine(argc, argv)};
  for (const Verb* row : RowsInOrder()) {
    CLI::App* const verb = app.add_subcommand(std::string(row->name), std::string(row->summary));
    verb->callback([&run, runs = row->add(verb, call)] { run = runs; });
    // Last: verbs below this one would inherit it.
    verb->group(kGroupTitles[static_cast<std::size_t>(row->group)]);
  }
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
