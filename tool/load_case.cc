#include "tool/load_case.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/error.h"
#include "fmt/format.h"
#include "io/output.h"
#include "props/codec/codec.h"
#include "props/domains/case_name.h"
#include "props/run/property_domains.h"
#include "tool/resolve.h"
#include "tool/resolve_case.h"
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

// The drawn case that choice.name names.
LoadedCase LoadNamed(const CaseChoice& choice, const std::string& subject, std::string_view verb,
                     const SubjectMaker& make) {
  if (!choice.path.empty()) {
    throw InputError("--case", "a case file and the name of a drawn case were both given",
                     "give one of them");
  }
  if (subject.empty()) {
    throw InputError("--case", "the name of a case needs a subject", "give --subject as well");
  }
  const CaseName case_name = RequireCaseName(choice.name);
  LoadedCase loaded;
  if (!choice.property.empty()) loaded.property = &RequireProperty(choice.property);
  loaded.subject = Made(subject, choice, make);
  loaded.value = props::DrawCase(loaded.subject->Info(), case_name);
  CaseChoice stated = choice;
  stated.subject = subject;
  loaded.replay = CommandFor(verb, stated);
  return loaded;
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
    return LoadNamed(choice, subject.empty() ? unnamed : subject, verb, make);
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

}  // namespace rasterproof::tool
