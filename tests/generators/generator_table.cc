// Runs one cell of docs/generators.md, or a row; scripts/generator_table runs them all.
//
//     generator_table judges (SUBJECT | FILE.so[,PROFILE])
//         the properties that judge the subject
//     generator_table race (SUBJECT | FILE.so[,PROFILE]) STREAM SEED CAP LEAST
//         cases and seconds to the first violation, one line: cases to the first or -, seconds to
//         it or -, violating cases, cases, seconds
//     generator_table wrong METHOD SEED CASES CAP STREAM-OR-DOMAIN...
//         for each: its name, cases, cases whose counts are not the oracle's
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "io/case_file.h"
#include "props/property.h"
#include "props/run/property_domains.h"
#include "subjects/builtin/builtin.h"
#include "subjects/mutants/mutants.h"
#include "subjects/plugin/plugin.h"
#include "tests/generators/case_streams.h"
#include "tests/generators/race.h"

namespace rasterproof::generators {
namespace {

using Words = std::span<char* const>;

std::unique_ptr<Subject> SubjectNamed(const std::string& name) {
  const std::string file = name.substr(0, name.find(','));
  if (file.ends_with(".so")) {
    auto [subject, profile] = subjects::LoadPlugin(file);
    SubjectInfo judged_as = subject->Info();
    judged_as.profile = file == name ? io::ParseProfile(profile, file)
                                     : io::ReadProfile(name.substr(file.size() + 1));
    subject->JudgeAs(judged_as);
    return std::move(subject);
  }
  std::unique_ptr<Subject> subject = subjects::MakeBuiltin(name);
  if (subject == nullptr) subject = subjects::MakeMutant(name);
  if (subject == nullptr) throw InputError(name, "no such subject", "see: rasterproof list");
  return subject;
}

// The cases of one domain.
class OneDomain final : public CaseStream {
 public:
  OneDomain(const SubjectInfo& info, std::string domain, std::uint64_t seed)
      : info_(info), name_{std::move(domain), 0, seed} {}

  Case Next() override {
    Case c = props::DrawCase(info_, name_);
    ++name_.index;
    return c;
  }

 private:
  const SubjectInfo& info_;
  props::CaseName name_;
};

int ListJudges(Words words) {
  if (words.size() != 1) return 2;
  const std::unique_ptr<Subject> subject = SubjectNamed(words[0]);
  for (const props::Property* const property : Applicable(*subject, JudgingProperties())) {
    std::printf("%s\n", std::string(property->name).c_str());
  }
  return 0;
}

int RaceOnce(Words words) {
  if (words.size() != 5) return 2;
  const std::unique_ptr<Subject> subject = SubjectNamed(words[0]);
  const auto properties = Applicable(*subject, JudgingProperties());
  const SubjectInfo info = subject->Info();
  const std::unique_ptr<CaseStream> cases =
      MakeStream(words[1], info, properties, std::strtoull(words[2], nullptr, 10));
  if (cases == nullptr || properties.empty()) return 2;
  const Race race = RunRace(*subject, properties, *cases, std::atof(words[3]), std::atof(words[4]));
  const auto text = [](const auto& x) { return x ? std::to_string(*x) : std::string("-"); };
  std::printf("%s %s %s %s %f\n", text(race.cases_to_first).c_str(),
              text(race.seconds_to_first).c_str(), std::to_string(race.violating).c_str(),
              std::to_string(race.cases).c_str(), race.seconds);
  return 0;
}

int CountRow(Words words) {
  if (words.size() < 5) return 2;
  const std::unique_ptr<Subject> subject = SubjectNamed(words[0]);
  const SubjectInfo info = subject->Info();
  const std::uint64_t seed = std::strtoull(words[1], nullptr, 10);
  for (const std::string name : words.subspan(4)) {
    std::unique_ptr<CaseStream> cases = MakeStream(name, info, {}, seed);
    if (cases == nullptr) cases = std::make_unique<OneDomain>(info, name, seed);
    const Wrong row =
        CountWrong(*subject, *cases, std::strtoull(words[2], nullptr, 10), std::atof(words[3]));
    std::printf("%s %s %s\n", name.c_str(), std::to_string(row.cases).c_str(),
                std::to_string(row.wrong).c_str());
    std::fflush(stdout);
  }
  return 0;
}

int Main(Words words) {
  const std::string_view verb = words.size() > 1 ? words[1] : "";
  int status = 2;
  try {
    if (verb == "judges") status = ListJudges(words.subspan(2));
    if (verb == "race") status = RaceOnce(words.subspan(2));
    if (verb == "wrong") status = CountRow(words.subspan(2));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "generator_table: %s\n", error.what());
    return 2;
  }
  if (status == 2) std::fprintf(stderr, "usage: see the beginning of generator_table.cc\n");
  return status;
}

}  // namespace
}  // namespace rasterproof::generators

int main(int argc, char** argv) {
  return rasterproof::generators::Main({argv, static_cast<std::size_t>(argc)});
}
