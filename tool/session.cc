#include "tool/session.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/error.h"
#include "core/target_size.h"
#include "exact/environment.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/mesh.h"
#include "io/output.h"
#include "io/scene_file.h"
#include "props/codec/codec.h"
#include "props/domains/case_name.h"
#include "props/judging/as_shown.h"
#include "props/run/facings.h"
#include "props/run/property_domains.h"
#include "subjects/builtin/builtin.h"
#include "subjects/mutants/mutants.h"
#include "tool/case_choice.h"
#include "tool/interrupt.h"
#include "tool/outside.h"
#include "tool/resolve.h"
#include "tool/shared_files.h"
#include "tool/shell.h"

namespace rasterproof::tool {
namespace {

// Case files are what people exchange: one must not decide what runs on the machine that reads it.
void RequireOursInFile(const std::string& name, const CaseChoice& choice, std::string_view verb) {
  if (IsOurs(name)) return;
  if (!NamesWhatToRun(name)) {
    throw InputError(choice.path,
                     fmt::format("there is no subject {}, which it names", ShellWord(name)),
                     "give --subject; 'rasterproof list subjects' names all");
  }
  constexpr std::size_t kLongestShown = 1000;  // what a reader can judge before typing it
  const std::string option = SubjectOption(name);
  if (option.size() > kLongestShown) {
    throw InputError(choice.path,
                     fmt::format("the file names an outside subject, in {} characters, and files "
                                 "may not choose what runs",
                                 name.size()),
                     "if you trust it, name it yourself: --plugin, --exec or --subject");
  }
  const std::string typed = choice.typed.empty() ? CommandFor(verb, choice) : choice.typed;
  throw InputError(choice.path,
                   "the file names an outside subject, and files may not choose what runs",
                   fmt::format("if you trust it, name it yourself: {} {}", typed, option));
}

}  // namespace

CoverageCounts Draw(Subject& subject, const Scene& scene, const DrawOptions& options) {
  const int samples = subject.Info().profile.pattern.samples();
  RequireTargetSize("scene", scene.width, scene.height, samples);
  CoverageCounts counts(scene.width, scene.height, samples);
  const CallEnd end = props::DrawByFacing(subject, scene, options, counts);
  if (end.stop != Stop::kNone) throw SubjectStop(end);
  return counts;
}

CoverageCounts ShownBy(Subject& subject, const Scene& scene, CoverageCounts counts) {
  const bool as_shown = props::IsJudgedAsShown(subject.Info(), scene);
  return as_shown ? props::AsShown(std::move(counts)) : counts;
}

std::optional<CoverageCounts> DrawUnlessItFails(Subject& subject, const Scene& scene,
                                                const DrawOptions& options, std::string& reason) {
  try {
    return Draw(subject, scene, options);
  } catch (const SubjectStop& stop) {
    if (!IsBreakdown(stop.stop())) throw;
    reason = std::string("the subject failed: ") + stop.what();
    return std::nullopt;
  }
}

void RequireTakes(const Subject& subject, const Scene& scene, const std::string& place) {
  const SubjectInfo& info = subject.Info();
  if (Takes(info, scene)) return;
  if (scene.clip_space && !info.takes_clip) {
    throw InputError(place,
                     "the scene is in clip space and subject " + info.name + " takes window space",
                     "use a subject that takes clip space (hom-..., exact), or vertices [x, y]");
  }
  if (!scene.clip_space && !info.takes_window) {
    throw InputError(place,
                     "the scene is in window space and subject " + info.name + " takes clip space",
                     "give vertices [x, y, z, w], or use another subject");
  }
  if (info.profile.fixed) {
    const FixedInput& fixed = *info.profile.fixed;
    throw InputError(place,
                     fmt::format("subject {} does not take a coordinate: fixed point {}.{}, {}",
                                 info.name, fixed.integer_bits, fixed.fraction_bits,
                                 fixed.is_signed ? "signed" : "unsigned"),
                     fmt::format("give multiples of 2^-{} from {} to {}", fixed.fraction_bits,
                                 fixed.Least(), fixed.Largest()));
  }
  throw InputError(place, "the scene is float64 and subject " + info.name + " computes in float32",
                   "use a float64 subject (f64-..., spans-exact), or \"precision\": \"float32\"");
}

void RequireDrawsSamples(const Subject& subject, const Profile& profile, const std::string& place) {
  const SubjectInfo& info = subject.Info();
  const bool is_fixed = subjects::IsBuiltin(info.name) || subjects::IsMutant(info.name);
  const int drawn = (is_fixed ? subject.OwnInfo() : info).profile.pattern.samples();
  const int needed = profile.pattern.samples();
  if (drawn == needed) return;
  const auto samples = [](int n) { return n == 1 ? "one sample" : fmt::format("{} samples", n); };
  const std::string remedy =
      fmt::format("name another subject, such as --subject exact{}",
                  is_fixed ? ", or a --plugin" : ", or state its samples by --profile");
  throw InputError(place,
                   fmt::format("subject {} draws {} a pixel, and this case has {}", info.name,
                               samples(drawn), needed),
                   remedy);
}

namespace {

// Whether a file is none of text: no JSON, then, but bytes that a fuzzer saved.
bool IsNoText(std::string_view content) {
  const auto is_control = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < ' ' && c != '\n' && c != '\r' && c != '\t';
  };
  const std::size_t first = content.find_first_not_of(" \n\r\t");
  if (first == std::string_view::npos) return false;
  return content[first] != '{' && std::ranges::any_of(content, is_control);
}

std::unique_ptr<Subject> Made(const std::string& name, const CaseChoice& choice,
                              const SubjectMaker& make) {
  return make ? make() : MakeSubject(name, choice.profile, choice.list_length);
}

// Bytes mean a case only with a subject, whose lattice and profile are part of what they mean.
LoadedCase LoadFuzzInput(const CaseChoice& choice, std::string_view bytes, std::string_view verb,
                         const SubjectMaker& make) {
  CaseChoice stated = choice;
  const std::vector<std::string> own = OwnNames();
  if (stated.subject.empty() && !own.empty()) stated.subject = own.front();
  if (stated.subject.empty()) {
    throw InputError(choice.path, "a fuzz input needs a subject to be a case",
                     "give the --subject that it was run on");
  }
  LoadedCase loaded;
  if (!choice.property.empty()) loaded.property = &RequireProperty(choice.property);
  loaded.subject = Made(stated.subject, choice, make);
  const std::span data(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  loaded.value = props::DecodeCase(data, loaded.subject->Info());
  if (loaded.value.origin.empty()) loaded.value.origin = choice.path;
  loaded.replay = CommandFor(verb, stated);
  return loaded;
}

}  // namespace

std::string SubjectOption(const std::string& name) {
  if (name.starts_with(kPluginPrefix)) {
    return "--plugin " + ShellWord(name.substr(kPluginPrefix.size()));
  }
  if (name.starts_with(kExecPrefix)) return "--exec " + ShellWord(name.substr(kExecPrefix.size()));
  return "--subject " + ShellWord(name);
}

bool IsCaseText(const std::string& path) { return path.starts_with('{'); }

std::string CommandFor(std::string_view verb, const CaseChoice& choice) {
  std::string command = fmt::format("rasterproof {}", verb);
  const auto add = [&](std::string_view option, const std::string& value) {
    if (!value.empty()) command += fmt::format("{} {}", option, ShellWord(value));
  };
  // Prefix "./" so that a leading dash is not taken for an option.
  const bool like_option = choice.path.size() > 1 && choice.path.front() == '-';
  const bool is_text = IsCaseText(choice.path);
  if (!is_text) add("", like_option ? "./" + choice.path : choice.path);
  if (!choice.subject.empty()) command += " " + SubjectOption(choice.subject);
  add(" --property", choice.property);
  add(" --profile", choice.profile);
  add(" --case", choice.name);
  if (choice.is_fuzz_input) command += " --fuzz-input";
  if (choice.list_length != 0) {
    command += fmt::format(" --list-length {}", choice.list_length);
  }
  if (is_text) add("", choice.path);  // long, so the last
  return command;
}

LoadedCase LoadCase(const CaseChoice& choice, std::string_view verb, const SubjectMaker& make) {
  LoadedCase loaded = LoadCaseOrDrawing(choice, verb, make);
  if (!loaded.drawing) return loaded;
  throw InputError(choice.path, "it holds a drawing of no subject",
                   "judge the drawing by 'rasterproof legal " + choice.path +
                       "', or give --subject to draw the scene");
}

LoadedCase LoadCaseOrDrawing(const CaseChoice& choice, std::string_view verb,
                             const SubjectMaker& make) {
  LoadedCase loaded;
  std::string subject = choice.subject;
  std::string property = choice.property;
  const std::vector<std::string> own = OwnNames();
  const std::string unnamed = own.empty() ? std::string() : own.front();  // of kit/main.h's program
  if (!choice.name.empty()) {
    if (subject.empty()) subject = unnamed;
    if (!choice.path.empty()) {
      throw InputError("--case", "a case file and the name of a drawn case were both given",
                       "give one of them");
    }
    if (subject.empty()) {
      throw InputError("--case", "the name of a case needs a subject", "give --subject as well");
    }
    const CaseName case_name = RequireCaseName(choice.name);
    if (!property.empty()) loaded.property = &RequireProperty(property);
    loaded.subject = Made(subject, choice, make);
    loaded.value = props::DrawCase(loaded.subject->Info(), case_name);
    CaseChoice stated = choice;
    stated.subject = subject;
    loaded.replay = CommandFor(verb, stated);
    return loaded;
  }
  if (choice.path.empty()) {
    throw InputError("case", "no case was given", "give a case file, or --subject and --case NAME");
  }
  const bool is_text = IsCaseText(choice.path);
  const std::string content = is_text ? choice.path : io::ReadFile(Located(choice.path));
  if (choice.is_fuzz_input || IsNoText(content)) return LoadFuzzInput(choice, content, verb, make);
  io::CaseFile file = io::ParseCase(content, is_text              ? "the case typed"
                                             : choice.path == "-" ? "standard input"
                                                                  : choice.path);
  if (choice.subject.empty() && file.drawing) {
    loaded.drawing = std::move(file);
    return loaded;
  }
  if (subject.empty() && !file.subject.empty()) {
    RequireOursInFile(file.subject, choice, verb);
    subject = file.subject;
  }
  if (subject.empty()) subject = unnamed;
  if (property.empty()) property = file.property;
  if (subject.empty()) {
    throw InputError(choice.path, "the file names no subject", "give --subject");
  }
  loaded.value = file.value;
  // The oracle models any profile, and so the one that the case is judged by.
  if (!make && file.states_profile && choice.profile.empty() && IsOracle(subject)) {
    loaded.subject = MakeOracle(subject, file.value.profile);
  } else {
    loaded.subject = Made(subject, choice, make);
  }
  // A scene states nothing: what is judged is what the subject does.
  if (!file.states_profile || !choice.profile.empty()) {
    loaded.value.profile = loaded.subject->Info().profile;
  }
  if (!property.empty()) loaded.property = &RequireProperty(property);
  CaseChoice stated = choice;
  stated.subject = subject;
  stated.property = property;
  loaded.replay = CommandFor(verb, stated);
  return loaded;
}

props::CampaignOptions CampaignOn(const Subject& subject, props::CampaignOptions options,
                                  SubjectMaker make) {
  options.stop = Interrupted;
  if (!IsOutside(subject.Info().name)) return options;
  options.time_limit = OutsideLimits().seconds;
  if (!make) return options;
  options.afresh = [make = std::move(make)]() -> std::unique_ptr<Subject> {
    try {
      return make();
    } catch (const InputError&) {
    } catch (const SubjectStop&) {  // it was interrupted
    }
    return nullptr;
  };
  return options;
}

}  // namespace rasterproof::tool
