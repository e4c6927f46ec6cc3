#include "tool/check/resolve_check.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/error.h"
#include "io/case_file.h"
#include "tool/shared_files.h"

namespace rasterproof::tool {
namespace {

// The case files of the folder, in the order of their names. None if there is no folder yet.
std::multimap<std::string, GivenCase> SavedIn(const std::string& folder) {
  std::multimap<std::string, GivenCase> saved;
  if (folder.empty() || !std::filesystem::is_directory(folder)) return saved;
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") paths.push_back(entry.path().string());
  }
  std::ranges::sort(paths);
  for (const std::string& path : paths) {
    const io::CaseFile file = io::ReadCase(path);
    if (file.property.empty()) {
      throw InputError(path, "the saved failure names no property",
                       "move it out of the folder, or check it as a scene");
    }
    saved.emplace(file.property, GivenCase{path, file.value, {}, file.states_profile});
  }
  return saved;
}

}  // namespace

ResolvedCheck ResolveCheck(const CheckOptions& options) {
  ResolvedCheck asked;
  asked.is_whole_catalogue = options.properties.empty();
  for (const std::string& name : options.properties) {
    asked.properties.push_back(&RequireProperty(name));
  }
  if (asked.is_whole_catalogue) {
    for (const props::Property& property : props::Catalog()) asked.properties.push_back(&property);
  }
  if (!options.known.empty()) asked.known = ReadKnownFailures(options.known);
  for (const KnownFailure& known : asked.known) {
    if (known.cause.empty() || !options.no_cause) continue;
    throw InputError("--no-cause", known.place + " is known by its cause",
                     "leave the option out, or the entry's cause");
  }
  for (const std::string& path : options.scenes) {
    GivenCase& given = asked.cases.emplace_back();
    given.place = path;
    io::CaseFile file = io::ReadCase(Located(path));
    given.value = std::move(file.value);
    given.states_profile = file.states_profile;
  }
  for (const std::string& name : options.named) {
    GivenCase& given = asked.cases.emplace_back();
    given.place = name;
    given.name = RequireCaseName(name);
  }
  for (const std::string& name : options.subjects) {
    asked.subjects.push_back(
        ResolveSubject(name, options.profile, options.device, options.list_length));
  }
  if (asked.cases.empty()) asked.saved = SavedIn(options.save);
  return asked;
}

}  // namespace rasterproof::tool
