#include "lab/sweep/sweep_runner.h"

#include <stdlib.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/error.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "props/compare/compare.h"
#include "props/compare/yardsticks.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/run/campaign.h"
#include "subjects/process/process.h"

namespace rasterproof::lab {
namespace {

using Kind = Choice::Kind;
using Clock = subjects::ProcessSubject::Clock;
namespace fs = std::filesystem;

// An emulator at -O0 is this much slower.
constexpr double kMostTimesTheBase = 100;
// A machine may give a build so much less time than it gave the base.
constexpr double kMostLoaded = 10;

constexpr std::array<std::string_view, 5> kCxxEndings{".cc", ".cpp", ".cxx", ".C", ".c++"};

bool IsCxx(const std::string& source) {
  return std::ranges::find(kCxxEndings, fs::path(source).extension().string()) != kCxxEndings.end();
}

// The line that says what is wrong, of all that a compiler prints.
std::string FirstError(const std::string& output) {
  std::istringstream lines(output);
  std::string first;
  for (std::string line; std::getline(lines, line);) {
    if (first.empty()) first = line;
    for (const char* sign :
         {"error", "undefined reference", "cannot find", "multiple definition"}) {
      if (line.find(sign) != std::string::npos) return line;
    }
  }
  return first.empty() ? "it fails without a message" : first;
}

// The samples of one case that a build draws otherwise than the base; added to `changes`, too.
props::Reading ReadChanges(const props::PlacedCase& c, std::size_t number,
                           const DrawOutcome& outcome, const DrawOutcome& base,
                           std::vector<ChangedSample>& changes) {
  const std::size_t first = changes.size();
  const bool is_drawn = outcome.end.stop == Stop::kNone;
  if (is_drawn != (base.end.stop == Stop::kNone)) changes.push_back({number});
  const auto value = [](const Drawing& d, std::size_t k) {
    if (d.primitive_ids.empty()) return std::pair(d.counts.front[k], d.counts.back[k]);
    return std::pair(static_cast<std::uint32_t>(d.primitive_ids[k]), std::uint32_t{0});
  };
  const bool are_both_drawn = is_drawn && changes.size() == first;
  for (std::size_t k = 0; are_both_drawn && k < base.drawing.counts.size(); ++k) {
    const auto [front, back] = value(outcome.drawing, k);
    if (std::pair(front, back) != value(base.drawing, k)) {
      changes.push_back({number, k, front, back});
    }
  }
  std::vector<std::size_t> wrong;
  for (std::size_t k = first; k < changes.size(); ++k) wrong.push_back(changes[k].sample);
  if (!are_both_drawn) return {.wrong = std::move(wrong)};
  return props::Measured(c, base.drawing.counts, std::move(wrong));
}

}  // namespace

SweepFolder::SweepFolder() {
  std::string name = (fs::temp_directory_path() / "rasterproof_sweep.XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw InputError(name, "it can't hold a new folder", "set TMPDIR to one that can be written");
  }
  folder_ = name;
}

SweepFolder::~SweepFolder() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string SweepFolder::NewPath(const std::string& ending) {
  const std::lock_guard lock(mutex_);
  return (folder_ / fmt::format("{}{}", next_++, ending)).string();
}

SweepRunner::SweepRunner(SweepSettings settings) : settings_(std::move(settings)) {
  for (const std::string& source : settings_.sources) {
    if (!fs::is_regular_file(source)) {
      throw InputError(source, "there is no such file", "give C or C++ sources of a plugin");
    }
    if (!IsCxx(source) && fs::path(source).extension() != ".c") {
      throw InputError(source, "it is not named as a C or C++ source",
                       "give files that end with .c, .cc, .cpp or .cxx");
    }
    has_cxx_ = has_cxx_ || IsCxx(source);
  }
  driver_ = fs::absolute(settings_.driver).string();
}

void SweepRunner::Run(const std::vector<std::string>& command, const std::string& shell_words) {
  // Words of --cflags are the shell's: it makes of quotes and variables what it does in a makefile.
  std::vector<std::string> shell{
      "/bin/sh", "-c",
      fmt::format("LC_ALL=C \"$0\" {} \"$@\" 2>&1; s=$?; echo; echo \"status $s\"", shell_words)};
  shell.insert(shell.end(), command.begin(), command.end());
  std::string output;
  try {
    output = subjects::OutputOf(shell, command.front(), {.seconds = settings_.seconds});
  } catch (const InputError& error) {
    throw BuildFailure(error.what());
  }
  if (!output.ends_with("\nstatus 0\n")) throw BuildFailure(FirstError(output));
}

std::string SweepRunner::Compile(const std::string& source, const Choices& choices,
                                 const std::vector<std::string>& more) {
  const Toolchain tools = ToolchainOf(choices);
  std::vector<std::string> command{IsCxx(source) ? tools.cxx : tools.c};
  if (IsCxx(source) && settings_.cflags.find("-std=") == std::string::npos) {
    command.emplace_back("-std=gnu++20");
  }
  command.insert(command.end(), tools.flags.begin(), tools.flags.end());
  command.insert(command.end(), kBaseFlags.begin(), kBaseFlags.end());
  for (const Choice& c : choices) {
    if (c.kind == Kind::kFlag) command.push_back(c.value);
  }
  command.insert(command.end(), more.begin(), more.end());
  const bool is_assembly = std::ranges::find(more, "-S") != more.end();
  if (!is_assembly) command.emplace_back("-c");
  const std::string kit = fs::path(driver_).parent_path().parent_path().string();
  command.insert(command.end(), {"-I" + kit, source});
  if (!is_assembly) {
    const std::lock_guard lock(objects_mutex_);
    if (const auto made = objects_.find(command); made != objects_.end()) return made->second;
  }
  const std::vector<std::string> key = command;
  const std::string output = folder_.NewPath(is_assembly ? ".s" : ".o");
  command.insert(command.end(), {"-o", output});
  Run(command, source == driver_ ? "" : settings_.cflags);
  if (!is_assembly) {
    const std::lock_guard lock(objects_mutex_);
    objects_.emplace(key, output);
  }
  return output;
}

// The driver is the same code in all builds of a target: no flag of theirs reaches what it reads
// and prints.
std::string SweepRunner::DriverOf(const Choices& choices) {
  Choices target;
  for (const Choice& c : choices) {
    if (c.kind == Kind::kTarget) target.push_back(c);
  }
  const std::string name = ChoicesText(target);
  const std::lock_guard lock(mutex_);
  std::string& object = drivers_[name];
  if (object.empty()) object = Compile(driver_, target);
  return object;
}

std::string SweepRunner::Link(const std::vector<std::string>& objects, const Choices& choices) {
  const Toolchain tools = ToolchainOf(choices);
  std::vector<std::string> command{has_cxx_ ? tools.cxx : tools.c};
  command.insert(command.end(), tools.flags.begin(), tools.flags.end());
  command.push_back(DriverOf(choices));
  command.insert(command.end(), objects.begin(), objects.end());
  for (const Choice& c : choices) {
    if (c.kind == Kind::kLinkFlag) command.push_back(c.value);
  }
  const std::string program = folder_.NewPath("");
  command.insert(command.end(), {"-o", program, "-lm"});
  Run(command, settings_.cflags);
  return program;
}

std::string SweepRunner::Build(const Choices& choices) {
  std::vector<std::string> objects;
  for (const std::string& source : settings_.sources) objects.push_back(Compile(source, choices));
  return Link(objects, choices);
}

// Of the clock: room for slow builds and emulators. What hangs is stopped by its own time.
double SweepRunner::MostSeconds() const {
  return base_.empty() ? 0 : 3 * settings_.seconds + kMostTimesTheBase * base_seconds_;
}

std::vector<DrawOutcome> SweepRunner::Draw(const std::string& program, const Choices& choices,
                                           const std::vector<std::size_t>& numbers) const {
  std::vector<std::string> command = ToolchainOf(choices).emulator;
  subjects::ProcessLimits limits{.seconds = settings_.seconds};
  if (!base_.empty()) limits.long_waits = 0;
  if (!command.empty()) limits.bytes = 0;  // an emulator reserves all addresses of its guest
  command.push_back(program);
  subjects::ProcessSubject subject(command, info_, limits);
  if (const double most = MostSeconds(); most != 0) {
    const std::chrono::duration<double> all(kMostLoaded * most);
    subject.SetDeadline(Clock::now() + std::chrono::duration_cast<Clock::duration>(all));
  }
  std::vector<DrawJob> jobs;
  for (const std::size_t n : numbers) jobs.push_back(jobs_[n]);
  return subject.DrawMany(jobs);
}

void SweepRunner::DrawBase(std::uint64_t seed, std::uint64_t count, const std::string& profile) {
  const std::string program = Build({});
  const std::string text = subjects::OutputOf({program, "--describe"}, settings_.sources.front());
  info_ = settings_.describe(text, settings_.sources.front());
  if (!profile.empty()) info_.profile = io::ReadProfile(profile);
  const char* const property =
      info_.takes_window ? "CoverageEqualsTheModel" : "ClipSpaceCoverageEqualsTheModel";
  std::vector<std::size_t> numbers;
  for (std::uint64_t k = 0; k < count; ++k) {
    const Case& c =
        cases_.emplace_back(props::DrawCase(info_, *props::FindProperty(property), seed, k));
    jobs_.push_back(props::WholeCallOf(c.scene, c.profile, {}).job);
    numbers.push_back(numbers.size());
  }
  const Clock::time_point began = Clock::now();
  base_ = Draw(program, {}, numbers);
  base_seconds_ = std::chrono::duration<double>(Clock::now() - began).count();
  for (std::size_t k = 0; k < base_.size(); ++k) {
    const CallEnd& end = base_[k].end;
    if (!EndsTheCall(end.stop)) continue;
    throw InputError("the base on " + cases_[k].origin, end.why,
                     "correct that first: 'rasterproof check' shows it");
  }
  const SweepOutcome again = Compare(program, {});
  if (!again.HasDrawn() || again.Differs()) {
    throw InputError("the base", "it draws the same cases differently from run to run",
                     "correct that first: check --property EqualDrawsGiveEqualCounts");
  }
}

const Drawing* SweepRunner::BaseDrawing(std::size_t number_of_case) const {
  const DrawOutcome& outcome = base_.at(number_of_case);
  return outcome.end.stop == Stop::kNone ? &outcome.drawing : nullptr;
}

std::string SweepRunner::WhyStopped(const CallEnd& end) const {
  if (end.stop == Stop::kBrokeDown || end.stop == Stop::kOutOfMemory) return end.why;
  if (end.stop != Stop::kDeadline) {
    return fmt::format("no answer within --time-limit {:g}", settings_.seconds);
  }
  return fmt::format("its cases took more than {:.2g} s, the base's {:.2g} s",
                     kMostLoaded * MostSeconds(), base_seconds_);
}

SweepOutcome SweepRunner::Compare(const std::string& program, const Choices& choices,
                                  const std::vector<std::size_t>& numbers) {
  std::vector<std::size_t> all = numbers;
  for (std::size_t k = 0; numbers.empty() && k < cases_.size(); ++k) all.push_back(k);
  const std::vector<DrawOutcome> drawn = Draw(program, choices, all);
  SweepOutcome outcome;
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const CallEnd& end = drawn[k].end;
    if (EndsTheCall(end.stop)) {
      outcome.is_breakdown = true;
      outcome.failure = fmt::format("stopped on {}: {}", cases_[all[k]].origin, WhyStopped(end));
      return outcome;
    }
  }
  const props::Row row{.cases = all.size(),
                       .at = [&](std::uint64_t k) { return cases_[all[k]]; },
                       .draw =
                           [&](const props::CaseAtHand& at) {
                             return props::Drawn{
                                 {}, {std::shared_ptr<void>(), &base_[all[at.index]].drawing}};
                           }};
  const props::Yardstick build = [&](const props::CaseAtHand& at) -> props::Judging {
    return {"", [&, k = at.index](const props::Drawn&) {
              return ReadChanges(at.placed(), all[k], drawn[k], base_[all[k]], outcome.changes);
            }};
  };
  outcome.cell = props::CompareRow(row, {{build}}).front();
  return outcome;
}

SweepOutcome SweepRunner::OutcomeOf(const Choices& choices) {
  Choices key = choices;
  std::ranges::sort(key);
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = outcomes_.find(key); known != outcomes_.end()) return known->second;
  }
  SweepOutcome outcome;
  try {
    const std::string program = Build(choices);
    outcome = Compare(program, choices);
    fs::remove(program);
  } catch (const BuildFailure& failure) {
    outcome.failure = failure.what();
  }
  const std::lock_guard lock(mutex_);
  return outcomes_.emplace(std::move(key), std::move(outcome)).first->second;
}

}  // namespace rasterproof::lab
