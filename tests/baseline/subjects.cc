#include "tests/baseline/subjects.h"

#include <map>
#include <string_view>
#include <utility>

#include "core/profile.h"
#include "fmt/format.h"
#include "subjects/builtin/builtin.h"
#include "subjects/mutants/mutants.h"
#include "tests/baseline/model_subject.h"
#include "tests/props/planted_bugs.h"
#include "tests/props/planted_subjects.h"

namespace rasterproof::baseline {
namespace {

using Drawn = props::testing::PlantedSubject;

NamedSubject DrawnBy(std::string_view name, bool is_bug, const std::function<Drawn()>& make) {
  return {"planted:" + std::string(name), is_bug,
          [make] { return std::make_unique<Drawn>(make()); }};
}

// Those of the tests of the engines.
std::vector<NamedSubject> DrawnSubjects() {
  const SubjectInfo real = props::testing::RealInfo();
  const SubjectInfo doubles = props::testing::RealInfo(Precision::kFloat64);
  SubjectInfo any_space = doubles;
  any_space.takes_clip = true;
  const SubjectInfo snapped = props::testing::SnappedInfo(8);
  const SubjectInfo coarse = props::testing::SnappedInfo(4);
  return {
      DrawnBy("sound", false, [=] { return props::testing::Sound(real); }),
      DrawnBy("sound-float64", false, [=] { return props::testing::Sound(doubles); }),
      DrawnBy("sound-any-space", false, [=] { return props::testing::Sound(any_space); }),
      DrawnBy("sound-snap8", false, [=] { return props::testing::Sound(snapped); }),
      DrawnBy("sound-snap4", false, [=] { return props::testing::Sound(coarse); }),
      DrawnBy("other-bits", true,
              [=] {
                return props::testing::WithProfile(snapped, [](Profile& p) { p.snap.bits = 7; });
              }),
      DrawnBy("y-up", true,
              [=] {
                return props::testing::WithProfile(coarse,
                                                   [](Profile& p) { p.y_axis = YAxis::kUp; });
              }),
      DrawnBy("drops-last-column", true, [=] { return props::testing::DropsLastColumn(real); }),
      DrawnBy("inclusive", true, [=] { return props::testing::Inclusive(snapped); }),
      DrawnBy("naive-float32", true, [=] { return props::testing::NaiveFloat32(real); }),
      DrawnBy("naive-float64", true, [=] { return props::testing::NaiveFloat64(doubles); }),
      DrawnBy("loses-large", true, [=] { return props::testing::LosesLarge(snapped, 12); }),
      DrawnBy("throwing", true, [=] { return props::testing::Throwing(real); }),
  };
}

// Those of the tests of the catalogue. Names by property and number: their words are long.
std::vector<NamedSubject> PlantedSubjects() {
  std::vector<NamedSubject> subjects;
  std::map<std::string_view, int> numbers;
  for (const props::PlantedBug& bug : props::PlantedBugs()) {
    const int number = ++numbers[bug.property];
    const auto make = [bug] {
      return std::make_unique<props::PlantedSubject>(subjects::MakeBuiltin(bug.sound), bug.bug);
    };
    subjects.push_back({.name = fmt::format("planted-bug:{}:{}", bug.property, number),
                        .is_bug = true,
                        .make = make});
    // It works out exact barycentrics for every draw: too slow for the others, which models answer
    // too.
    if (bug.bug.show) subjects.back().property = bug.property;
  }
  return subjects;
}

void Append(std::vector<NamedSubject> more, std::vector<NamedSubject>& all) {
  for (NamedSubject& subject : more) all.push_back(std::move(subject));
}

}  // namespace

std::vector<NamedSubject> AllSubjects() {
  std::vector<NamedSubject> all;
  for (const std::string& name : subjects::BuiltinNames()) {
    all.push_back({.name = name, .make = [name] { return subjects::MakeBuiltin(name); }});
  }
  for (const ModelSettings& settings : AllModels()) {
    all.push_back(
        {.name = ModelName(settings), .make = [settings] { return MakeModel(settings); }});
  }
  for (const subjects::MutantInfo& info : subjects::Mutants()) {
    all.push_back({.name = info.name, .is_bug = !info.legal, .make = [&info] {
                     return subjects::MakeMutant(info.name);
                   }});
  }
  Append(PlantedSubjects(), all);
  Append(DrawnSubjects(), all);
  return all;
}

}  // namespace rasterproof::baseline
