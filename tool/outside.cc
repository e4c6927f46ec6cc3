#include "tool/outside.h"

#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <utility>

#include "core/error.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "subjects/plugin/plugin.h"
#include "subjects/process/process.h"
#include "subjects/process/serve.h"
#include "tool/description.h"
#include "tool/exit_status.h"
#include "tool/other_threads.h"

namespace rasterproof::tool {
namespace {

std::string ThisProgram() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

using Program = subjects::ProcessSubject::Program;

// Every subject outside is made here, whatever described it. That a method is exact, and what is
// proved of its arithmetic, only reference/ and exact/ may state: a subject from outside states
// neither, whatever it is called.
SubjectInfo AsOutside(SubjectInfo info, Program program) {
  info.states_exact = false;
  info.takes_float_modes = program == Program::kOurs;
  info.proofs.clear();
  return info;
}

SubjectMaker InAProcess(std::vector<std::string> command, SubjectInfo given, Program program) {
  const SubjectInfo info = AsOutside(std::move(given), program);
  return [command = std::move(command), info, program]() -> std::unique_ptr<Subject> {
    return std::make_unique<subjects::ProcessSubject>(command, info, OutsideLimits(), program);
  };
}

// This program once more, as the host of a library or an own type: what they break, they break
// there.
SubjectMaker Hosted(const std::string& name, const FloatModeOfHost& float_mode) {
  const std::string text = subjects::OutputOf({ThisProgram(), "pipe", "answer", name, "--describe"},
                                              name, OutsideLimits());
  SubjectInfo info = ParseDescription(text, name).info;
  info.summary = info.name + (info.summary.empty() ? "" : ": ") + info.summary;
  info.stated_name = std::exchange(info.name, name);
  info.takes_same = info.takes_wants = info.takes_npy = true;  // this program reads them
  std::vector<std::string> command{ThisProgram(), "pipe", "answer", name};
  if (float_mode.where != FloatModeOfHost::Where::kNowhere) {
    const bool is_workers = float_mode.where == FloatModeOfHost::Where::kInOtherThreads;
    command.insert(command.end(), {is_workers ? "--fp-env-of-workers" : "--fp-env",
                                   std::string(FloatModeName(float_mode.mode))});
  }
  return InAProcess(std::move(command), info, Program::kOurs);
}

// Throws if the program does not exist, before anything is run: the caller can mend that. The shell
// looks it up, as it will to start it.
void RequireProgram(const std::string& command, const std::string& name) {
  const std::string program = command.substr(0, command.find_first_of(" \t"));
  if (program.find_first_of("'\"\\$") != std::string::npos) return;  // only the shell knows
  try {
    subjects::OutputOf({"/bin/sh", "-c", "command -v -- \"$0\"", program}, name, OutsideLimits());
  } catch (const InputError&) {
    throw InputError(name, "there is no program " + program,
                     "give the path of one that this user may run");
  }
  // Of a path, dash says only that the file is there.
  const bool is_path = program.find('/') != std::string::npos;
  if (is_path && (access(program.c_str(), X_OK) != 0 || std::filesystem::is_directory(program))) {
    throw InputError(name, program + " is not a program that this user may run",
                     "make it executable (chmod +x), or name its interpreter before it");
  }
}

SubjectInfo NamedProgram(SubjectInfo info, const std::string& name) {
  info.stated_name = std::exchange(info.name, name);
  info.list_length = kListLengthOfPrograms;
  return info;
}

SubjectMaker Executed(const ProgramDescription& description, const std::string& name) {
  if (description.command.empty()) {
    throw InputError(name, "it names no command", "add a line: command PROGRAM ARGUMENT...");
  }
  RequireProgram(description.command, name);
  return InAProcess({"/bin/sh", "-c", "exec " + description.command},
                    NamedProgram(description.info, name), Program::kTheUsers);
}

// A subject in this very process, and its profile as text.
subjects::LoadedPlugin MakeHere(const std::string& name) {
  if (name.starts_with(kPluginPrefix)) {
    return subjects::LoadPlugin(name.substr(kPluginPrefix.size()));
  }
  std::unique_ptr<Subject> subject = MakeOwn(name);
  if (!subject) {
    throw InputError("pipe answer " + name, "there is no such subject", "give plugin:PATH");
  }
  std::string profile = io::ProfileToJson(subject->Info().profile);
  if (profile.starts_with('"')) profile = subject->Info().profile.name;
  return {std::move(subject), profile};
}

// A subject whose own threads are in the mode, those of them that were started by an earlier call.
class BesideOtherThreads final : public Subject {
 public:
  BesideOtherThreads(Subject& subject, FloatMode mode) : subject_(subject), mode_(mode) {}
  const SubjectInfo& OwnInfo() const override { return subject_.Info(); }
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override {
    SetModeOfOtherThreads(mode_);
    return subject_.DrawMany(jobs);
  }

 private:
  Subject& subject_;
  FloatMode mode_;
};

// Standard output for the answers alone: everything else that is printed there goes to standard
// error from here on.
int TakeStandardOutput() {
  const int answers = dup(STDOUT_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  return answers;
}

void SayAll(int file, const std::string& text) {
  for (std::size_t said = 0; said < text.size();) {
    const ssize_t n = write(file, text.data() + said, text.size() - said);
    if (n <= 0) throw InputError("standard output", "nobody reads the answers", "keep it open");
    said += static_cast<std::size_t>(n);
  }
}

}  // namespace

SubjectMaker ResolveOutside(const std::string& name) {
  if (name.starts_with(kPluginPrefix) || IsOwn(name)) return Hosted(name, {});
  if (name.starts_with(kExecPrefix)) {
    ProgramDescription description = PlainDescription();
    description.command = name.substr(kExecPrefix.size());
    return Executed(description, name);
  }
  if (name.starts_with(kRoundsPrefix)) {
    throw InputError(name, "this verb asks more than rounds of files can answer",
                     "give it to check, replay or infer");
  }
  if (name.ends_with(kDescriptionEnding)) {
    return Executed(ParseDescription(io::ReadFile(name), name), name);
  }
  return {};
}

SubjectInfo InfoOfProgram(const std::string& file) {
  const bool is_plain = file.empty();
  const ProgramDescription description =
      is_plain ? PlainDescription() : ParseDescription(io::ReadFile(file), file);
  const std::string name = is_plain ? std::string(kExecPrefix) + "PROGRAM" : file;
  return AsOutside(NamedProgram(description.info, name), Program::kTheUsers);
}

std::unique_ptr<Subject> MakeInHost(const std::string& name, const FloatModeOfHost& float_mode) {
  return Hosted(name, float_mode)();
}

int HostSubject(const HostOptions& options) {
  const int answers = TakeStandardOutput();
  const FloatModeOfHost& float_mode = options.float_mode;
  const bool is_from_the_start = float_mode.where == FloatModeOfHost::Where::kFromTheStart;
  const subjects::LoadedPlugin here = [&] {
    // A library keeps the mode that it finds here as its own.
    const WithinFloatMode mode(is_from_the_start ? float_mode.mode : FloatMode::kUsual);
    return MakeHere(options.subject);
  }();
  if (options.describe) {
    SubjectInfo info = here.subject->Info();
    info.takes_repeats = true;  // whatever it draws: Serve does it
    // No other request asks for them.
    info.takes_wants = info.fragments.shows_centroids || info.fragments.shows_values;
    SayAll(answers, DescriptionText(info, here.profile));
    return kExitHolds;
  }
  std::ios::sync_with_stdio(false);  // character by character otherwise
  const auto say = [&](const std::string& text) { SayAll(answers, text); };
  if (float_mode.where == FloatModeOfHost::Where::kInOtherThreads) {
    BesideOtherThreads beside(*here.subject, float_mode.mode);
    subjects::Serve(beside, std::cin, say);
  } else {
    subjects::Serve(*here.subject, std::cin, say);
  }
  return kExitHolds;
}

}  // namespace rasterproof::tool
