// Fuzzes a subject that the command line names, in this process:
//
//     fuzz_plugin --plugin mine.so [--property NAME]... [what libFuzzer takes]
//     fuzz_plugin --subject NAME ...
//
// --subject: one of this program's own, a planted bug among them. Without --property: the
// properties of the contract that the subject states. --profile: what a plugin is judged by, not by
// what it states.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/subject.h"
#include "core/subject_info.h"
#include "fuzz/fuzz_target.h"
#include "io/case_file.h"
#include "subjects/plugin/plugin.h"

namespace {

using rasterproof::fuzz::Bound;

std::optional<Bound> bound;

struct Options {
  std::string plugin;
  std::string profile;
  std::string subject;
  std::vector<std::string> properties;
};

[[noreturn]] void Refuse(const std::string& why) {
  std::fprintf(stderr, "fuzz_plugin: %s\n", why.c_str());
  std::exit(2);
}

// The words that are for this program; the others stay.
Options TakeOptions(int* argc, char*** argv) {
  Options asked;
  int kept = 0;
  for (int k = 0; k < *argc; ++k) {
    const std::string_view word = (*argv)[k];
    const auto value = [&] {
      if (++k == *argc) Refuse(std::string(word) + " names nothing");
      return std::string((*argv)[k]);
    };
    if (word == "--plugin") {
      asked.plugin = value();
    } else if (word == "--profile") {
      asked.profile = value();
    } else if (word == "--subject") {
      asked.subject = value();
    } else if (word == "--property") {
      asked.properties.push_back(value());
    } else {
      (*argv)[kept++] = (*argv)[k];
    }
  }
  *argc = kept;
  return asked;
}

std::unique_ptr<rasterproof::Subject> Loaded(const Options& asked) {
  if (asked.plugin.empty() == asked.subject.empty()) {
    Refuse("no subject; give --plugin FILE or --subject NAME");
  }
  if (!asked.subject.empty()) return rasterproof::fuzz::SubjectNamed(asked.subject);
  auto [subject, profile] = rasterproof::subjects::LoadPlugin(asked.plugin);
  rasterproof::SubjectInfo judged_as = subject->Info();
  judged_as.profile = asked.profile.empty() ? rasterproof::io::ParseProfile(profile, asked.plugin)
                                            : rasterproof::io::ReadProfile(asked.profile);
  subject->JudgeAs(judged_as);
  return std::move(subject);
}

void Bind(const Options& asked) {
  std::unique_ptr<rasterproof::Subject> subject = Loaded(asked);
  std::vector<std::string_view> names(asked.properties.begin(), asked.properties.end());
  if (names.empty()) names = rasterproof::fuzz::ContractPropertiesOf(*subject);
  if (names.empty()) Refuse("the subject states no contract; name a --property");
  for (const std::string_view name : names) rasterproof::fuzz::RequireApplies(*subject, name);
  bound.emplace(std::move(subject), names);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  try {
    Bind(TakeOptions(argc, argv));
  } catch (const std::exception& error) {
    Refuse(error.what());
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return bound->PutToTheTest({data, size});
}
