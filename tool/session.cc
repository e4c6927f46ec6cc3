#include "tool/session.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <memory>
#include <numeric>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/subject_errors.h"
#include "core/target_size.h"
#include "exact/coverage.h"
#include "exact/environment.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "io/case_file.h"
#include "io/mesh.h"
#include "io/output.h"
#include "io/scene_file.h"
#include "props/domains/case_name.h"
#include "props/domains/domain.h"
#include "props/judging/as_shown.h"
#include "props/run/facings.h"
#include "props/run/property_domains.h"
#include "subjects/builtin/builtin.h"
#include "subjects/mutants/mutants.h"
#include "tool/outside.h"
#include "tool/progress.h"
#include "tool/shell.h"

namespace rasterproof::tool {
namespace {

constexpr std::array<std::pair<std::string_view, exact::Decider>, 3> kOracles{{
    {"exact", exact::Decider::kFast},
    {"exact-integers", exact::Decider::kIntegers},
    {"exact-cgal", exact::Decider::kCgal},
}};

// The oracle in the place of a subject, so that it can be compared with any other and with itself.
class OracleSubject final : public Subject {
 public:
  OracleSubject(std::string_view name, exact::Decider decider, const Profile& profile)
      : decider_(decider) {
    info_.name = name;
    info_.profile = profile;
    info_.summary = "the oracle, decided by " + std::string(exact::DeciderName(decider));
    info_.input = Precision::kFloat64;
    info_.takes_clip = true;
    info_.claims_exact = true;
  }
  const SubjectInfo& OwnInfo() const override { return info_; }
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    counts += exact::Coverage(scene, info_.profile, options, decider_);
  }

 private:
  SubjectInfo info_;
  exact::Decider decider_;
};

// From here on the subject is judged by a profile that is not its own.
void JudgeBy(const Profile& profile, Subject& subject) {
  SubjectInfo info = subject.Info();
  // What it claims, it claims of its own profile.
  info.claims_exact = info.claims_exact && SameModel(info.profile, profile);
  // What it can be given is no matter of judgement.
  const std::optional<FixedInput> fixed = info.profile.fixed;
  info.profile = profile;
  if (!profile.fixed) info.profile.fixed = fixed;
  info.profile.name = io::ProfileName(info.profile);
  subject.JudgeAs(std::move(info));
}

// How many letters must be put in, taken out or exchanged (Levenshtein), capitals or not.
std::size_t Distance(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (const char letter : a) {
    std::size_t diagonal = row[0]++;
    for (std::size_t k = 1; k < row.size(); ++k) {
      const std::size_t exchanged = diagonal + (lower(letter) == lower(b[k - 1]) ? 0 : 1);
      diagonal = row[k];
      row[k] = std::min({exchanged, row[k] + 1, row[k - 1] + 1});
    }
  }
  return row.back();
}

// "did you mean NAME? ", if one is near.
std::string Suggestion(std::string_view wrong, const std::vector<std::string>& names) {
  const auto distance = [&](const std::string& name) { return Distance(wrong, name); };
  const auto nearest = std::ranges::min_element(names, {}, distance);
  if (nearest == names.end() || distance(*nearest) > std::max<std::size_t>(wrong.size() / 3, 2)) {
    return "";
  }
  return fmt::format("did you mean {}? ", *nearest);
}

// What this program is made of: no name of these makes another program run than the user's own.
bool IsOurs(const std::string& name) {
  if (NamesWhatToRun(name)) return false;
  const std::vector<std::string> own = OwnNames();
  return MakeOracle(name, {}) != nullptr || subjects::MakeBuiltin(name) != nullptr ||
         subjects::MakeMutant(name) != nullptr || std::ranges::find(own, name) != own.end();
}

// Case files are what people exchange: one must not decide what runs on the machine that reads it.
void RequireOursInFile(const std::string& name, const CaseChoice& choice, std::string_view verb) {
  if (IsOurs(name)) return;
  if (!NamesWhatToRun(name)) {
    throw InputError(choice.path,
                     fmt::format("there is no subject {}, which it names", ShellWord(name)),
                     "give --subject; 'rasterproof list subjects' names all that there are");
  }
  constexpr std::size_t kLongestShown = 1000;  // what a reader can judge before typing it
  const std::string option = SubjectOption(name);
  if (option.size() > kLongestShown) {
    throw InputError(choice.path,
                     fmt::format("the file names a subject outside this program, in {} characters, "
                                 "and no file decides what is run",
                                 name.size()),
                     "if you trust it, name it yourself: --plugin, --exec or --subject");
  }
  const std::string typed = choice.typed.empty() ? CommandFor(verb, choice) : choice.typed;
  throw InputError(choice.path,
                   "the file names a subject outside this program, and no file decides what is run",
                   fmt::format("if you trust it, name it yourself: {} {}", typed, option));
}

}  // namespace

void RequireHonestEnvironment() {
  const exact::Environment environment = exact::InspectEnvironment();
  if (environment.Honest()) return;
  throw InputError("floating-point environment", environment.Complaint(),
                   "mend it and run again (rasterproof doctor shows it); no verdict is given here");
}

std::vector<std::string> SubjectNames() {
  std::vector<std::string> names = subjects::BuiltinNames();
  for (const auto& oracle : kOracles) names.emplace_back(oracle.first);
  for (const std::string& own : OwnNames()) names.push_back(own);
  return names;
}

void SayOfPreset(const Profile& profile) {
  static std::set<std::string> said;
  if (!IsApiPreset(profile.name) || PresetProfile(profile.name) != profile) return;
  if (!said.insert(profile.name).second) return;
  Tell(fmt::format(
      "note: profile {} is judged by its canonical model: {} subpixel bits, {}, {}; of a "
      "rasterizer that the API lets do otherwise (4 bits, another rounding) say so in a "
      "profile file, snap_tolerance and any_tie_rule included\n",
      profile.name, profile.snap.bits, SnapRuleName(profile.snap.rule),
      FillRuleName(profile.fill_rule)));
}

std::unique_ptr<Subject> MakeSubject(std::string_view name) { return MakeSubject(name, ""); }

std::unique_ptr<Subject> MakeOracle(std::string_view name, const Profile& profile) {
  for (const auto& [oracle, decider] : kOracles) {
    if (name != oracle) continue;
    if (decider != exact::Decider::kFast && !profile.crossing.IsNone()) {
      throw InputError(
          fmt::format("subject '{}'", name),
          fmt::format("it does not decide the rounded crossings of profile {}", profile.name),
          "use --subject exact, or a profile without crossing");
    }
    return std::make_unique<OracleSubject>(name, decider, profile);
  }
  return nullptr;
}

std::unique_ptr<Subject> MakeSubject(std::string_view name, const std::string& profile) {
  const Profile named = profile.empty() ? Profile{} : io::ReadProfile(profile);
  std::unique_ptr<Subject> oracle = MakeOracle(name, named);
  std::unique_ptr<Subject> subject = subjects::MakeBuiltin(name);
  if (subject == nullptr) subject = subjects::MakeMutant(name);
  const std::vector<std::string> own = OwnNames();
  if ((oracle || subject) && std::ranges::find(own, name) != own.end()) {
    throw InputError(fmt::format("subject '{}'", name),
                     "a type of your own has the name of one of rasterproof's subjects",
                     "rename the type");
  }
  if (oracle) return oracle;
  if (subject == nullptr) subject = MakeOutside(std::string(name));
  if (subject == nullptr) {
    throw InputError(
        fmt::format("subject '{}'", name), "there is no such subject",
        fmt::format("{}choose one of: {}; or plugin:PATH, exec:COMMAND, FILE.subject",
                    Suggestion(name, SubjectNames()), fmt::join(SubjectNames(), ", ")));
  }
  if (!profile.empty()) JudgeBy(named, *subject);
  return subject;
}

const props::Property& RequireProperty(const std::string& name) {
  if (const props::Property* property = props::FindProperty(name)) return *property;
  std::vector<std::string> names;
  for (const props::Property& property : props::Catalog()) names.emplace_back(property.name);
  throw InputError(
      fmt::format("property '{}'", name), "there is no such property",
      Suggestion(name, names) + "'rasterproof list properties' names all that there are");
}

props::CaseName RequireCaseName(const std::string& name) {
  props::CaseName parsed = props::ParseCaseName(name);
  if (props::FindDomain(parsed.domain) == nullptr) {
    std::vector<std::string> names;
    for (const props::Domain& domain : props::Domains()) names.emplace_back(domain.name);
    throw InputError(
        fmt::format("case '{}'", name), fmt::format("there is no domain '{}'", parsed.domain),
        Suggestion(parsed.domain, names) + "'rasterproof list domains' names all that there are");
  }
  return parsed;
}

bool IsMeshPath(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  if (dot == std::string::npos) return false;
  std::string ending = path.substr(dot + 1);
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  constexpr std::array<std::string_view, 6> kMeshEndings{"obj", "ply", "off", "stl", "gltf", "glb"};
  return std::ranges::find(kMeshEndings, ending) != kMeshEndings.end();
}

Scene LoadScene(const SceneOptions& options) {
  if (!IsMeshPath(options.path)) {
    if (!options.camera.empty()) {
      throw InputError("--camera", options.path + " is a scene file, which has no use for a camera",
                       "leave the option out, or give a mesh (obj, ply, off, stl, gltf, glb)");
    }
    return io::ReadScene(options.path);
  }
  RequireTargetSize(fmt::format("--width {} --height {}", options.width, options.height),
                    options.width, options.height, 1);
  const io::Mesh mesh = io::ReadMesh(options.path);
  const std::string text = options.camera.empty() ? "front" : options.camera;
  const io::Camera camera = io::ParseCamera(text, mesh);
  const auto project = [&](io::ProjectTo to) {
    return io::ProjectMesh(mesh, camera, options.width, options.height, to);
  };
  if (options.project == "window") return project(io::ProjectTo::kWindow);
  Scene clip = project(io::ProjectTo::kClip);
  if (options.project == "clip") return clip;
  const bool in_front = std::ranges::all_of(clip.vertices, [](const Vertex& v) { return v.w > 0; });
  return in_front ? project(io::ProjectTo::kWindow) : clip;
}

CoverageCounts Draw(Subject& subject, const Scene& scene, const DrawOptions& options) {
  const int samples = subject.Info().profile.lattice.samples();
  RequireTargetSize("scene", scene.width, scene.height, samples);
  CoverageCounts counts(scene.width, scene.height, samples);
  props::DrawByFacing(subject, scene, options, counts);
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
  } catch (const SubjectFault& fault) {
    reason = std::string("the subject failed: ") + fault.what();
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
    throw InputError(
        place,
        fmt::format("a coordinate is none that subject {} takes: fixed point {}.{}, {}", info.name,
                    fixed.integer_bits, fixed.fraction_bits,
                    fixed.is_signed ? "signed" : "unsigned"),
        fmt::format("give multiples of 2^-{} from {} to {}", fixed.fraction_bits, fixed.Least(),
                    fixed.Largest()));
  }
  throw InputError(place, "the scene is float64 and subject " + info.name + " computes in float32",
                   "use a float64 subject (f64-..., spans-exact), or \"precision\": \"float32\"");
}

std::string SubjectOption(const std::string& name) {
  if (name.starts_with(kPluginPrefix)) {
    return "--plugin " + ShellWord(name.substr(kPluginPrefix.size()));
  }
  if (name.starts_with(kExecPrefix)) return "--exec " + ShellWord(name.substr(kExecPrefix.size()));
  return "--subject " + ShellWord(name);
}

std::string CommandFor(std::string_view verb, const CaseChoice& choice) {
  std::string command = fmt::format("rasterproof {}", verb);
  const auto add = [&](std::string_view option, const std::string& value) {
    if (!value.empty()) command += fmt::format("{} {}", option, ShellWord(value));
  };
  // What begins like an option is none behind "./".
  const bool like_option = choice.path.size() > 1 && choice.path.front() == '-';
  add("", like_option ? "./" + choice.path : choice.path);
  if (!choice.subject.empty()) command += " " + SubjectOption(choice.subject);
  add(" --property", choice.property);
  add(" --profile", choice.profile);
  add(" --case", choice.name);
  return command;
}

LoadedCase LoadCase(const CaseChoice& choice, std::string_view verb) {
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
      throw InputError("--case", "a name stands for a case together with a subject",
                       "give --subject as well");
    }
    const props::CaseName case_name = RequireCaseName(choice.name);
    if (!property.empty()) loaded.property = &RequireProperty(property);
    loaded.subject = MakeSubject(subject, choice.profile);
    loaded.value = props::DrawCase(loaded.subject->Info(), case_name);
    CaseChoice stated = choice;
    stated.subject = subject;
    loaded.replay = CommandFor(verb, stated);
    return loaded;
  }
  if (choice.path.empty()) {
    throw InputError("case", "no case was given", "give a case file, or --subject and --case NAME");
  }
  const io::CaseFile file = io::ReadCase(choice.path);
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
  loaded.subject = MakeSubject(subject, choice.profile);
  // A scene promises nothing: what is judged is what the subject does.
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

void WriteOutput(const std::string& path, std::string_view content) {
  if (path == "-") {
    io::WriteStandardOutput(content);
  } else {
    io::WriteFile(path, content);
  }
}

}  // namespace rasterproof::tool
