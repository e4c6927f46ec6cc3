// Writes every verdict down: subject by property by seed by case, for comparing two builds of the
// suite by scripts/compare_dumps. A tool of the tests, no part of the product.
#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "fmt/format.h"
#include "fmt/ranges.h"
#include "tests/baseline/entry.h"
#include "tests/baseline/rows.h"
#include "tests/baseline/subjects.h"

namespace rasterproof::baseline {
namespace {

constexpr std::string_view kUsage =
    "usage: verdict_dump --out DIR [--cases 64] [--bug-cases 16] [--seeds 1,2,3] [--only GLOB]...\n"
    "                    [--property GLOB]... [--jobs 2] [--digests]\n"
    "       verdict_dump --list\n"
    "Writes DIR/SUBJECT.txt, one row a property, seed and case; --digests: one row a property. "
    "Subjects\n"
    "with a bug get --bug-cases. A GLOB has * for any letters; one of several is enough.\n";

struct CommandLine {
  std::string out;
  DumpOptions dump;
  std::vector<std::string> only;
  std::vector<std::string> properties;
  std::uint64_t jobs = 2;
  bool list = false;
};

std::uint64_t ToNumber(const std::string& text) {
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || last != end) {
    throw std::invalid_argument(fmt::format("'{}' is no number", text));
  }
  return number;
}

std::vector<std::uint64_t> ToNumbers(std::string_view text) {
  std::vector<std::uint64_t> numbers;
  for (std::size_t comma = 0; comma != std::string_view::npos;) {
    comma = text.find(',');
    numbers.push_back(ToNumber(std::string(text.substr(0, comma))));
    if (comma != std::string_view::npos) text.remove_prefix(comma + 1);
  }
  return numbers;
}

bool Matches(std::string_view glob, std::string_view name) {
  if (glob.empty()) return name.empty();
  if (glob.front() != '*') {
    return !name.empty() && glob.front() == name.front() && Matches(glob.substr(1), name.substr(1));
  }
  return Matches(glob.substr(1), name) || (!name.empty() && Matches(glob, name.substr(1)));
}

bool MatchesAny(const std::vector<std::string>& globs, std::string_view name) {
  return globs.empty() ||
         std::ranges::any_of(globs, [&](const auto& glob) { return Matches(glob, name); });
}

CommandLine Parse(const std::vector<std::string>& words) {
  CommandLine line;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string& option = words[k];
    const auto value = [&] {
      if (k + 1 == words.size()) throw std::invalid_argument(option + " needs a value");
      return words[++k];
    };
    if (option == "--out") {
      line.out = value();
    } else if (option == "--cases") {
      line.dump.cases = ToNumber(value());
    } else if (option == "--bug-cases") {
      line.dump.bug_cases = ToNumber(value());
    } else if (option == "--seeds") {
      line.dump.seeds = ToNumbers(value());
    } else if (option == "--only") {
      line.only.push_back(value());
    } else if (option == "--property") {
      line.properties.push_back(value());
    } else if (option == "--jobs") {
      line.jobs = std::max<std::uint64_t>(ToNumber(value()), 1);
    } else if (option == "--digests") {
      line.dump.digests = true;
    } else if (option == "--list") {
      line.list = true;
    } else {
      throw std::invalid_argument("there is no option " + option);
    }
  }
  if (line.out.empty() && !line.list) throw std::invalid_argument("--out is missing");
  return line;
}

std::string FileName(std::string_view subject) {
  std::string name(subject);
  std::ranges::replace(name, ':', '_');
  return name + ".txt";
}

void WriteFile(const std::filesystem::path& path, std::string_view text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path.string() + " can't be written");
}

// All properties about all subjects, shared out among workers. What is written depends on neither
// the workers nor their number: every property is put to a subject of its own.
class Dump {
 public:
  Dump(std::vector<NamedSubject> subjects, const CommandLine& line)
      : subjects_(std::move(subjects)), line_(line) {
    for (const std::string& property : PropertyNames()) {
      if (MatchesAny(line.properties, property)) stated_.push_back(property);
    }
    pages_.resize(subjects_.size());
    for (Page& page : pages_) {
      page.rows.resize(stated_.size());
      page.missing = stated_.size();
    }
  }

  void Run() {
    if (stated_.empty()) throw std::invalid_argument("there is no such property");
    std::vector<std::thread> workers;
    for (std::uint64_t n = 0; n < line_.jobs; ++n) workers.emplace_back([this] { Work(); });
    for (std::thread& worker : workers) worker.join();
    if (error_ != nullptr) std::rethrow_exception(error_);
  }

 private:
  struct Page {
    std::vector<std::string> rows;  // by property
    std::size_t missing = 0;
  };

  void Work() {
    try {
      const std::size_t all = subjects_.size() * stated_.size();
      for (std::size_t n = next_++; n < all; n = next_++) {
        DumpProperty(n / stated_.size(), n % stated_.size());
      }
    } catch (...) {  // handed on by Run
      const std::lock_guard lock(mutex_);
      error_ = std::current_exception();
      next_ = subjects_.size() * stated_.size();
    }
  }

  void DumpProperty(std::size_t subject, std::size_t property) {
    std::string rows = PropertyRows(subjects_[subject], stated_[property], line_.dump);
    const std::lock_guard lock(mutex_);
    Page& page = pages_[subject];
    page.rows[property] = std::move(rows);
    if (--page.missing != 0) return;
    WriteFile(std::filesystem::path(line_.out) / FileName(subjects_[subject].name),
              HeaderRow(line_.dump) + fmt::format("{}", fmt::join(page.rows, "")));
    page.rows.clear();
    fmt::print(stderr, "{} of {}: {}\n", ++written_, subjects_.size(), subjects_[subject].name);
  }

  std::vector<NamedSubject> subjects_;
  const CommandLine& line_;
  std::vector<std::string> stated_;
  std::vector<Page> pages_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;  // of all below and of the pages
  std::size_t written_ = 0;
  std::exception_ptr error_;
};

std::vector<NamedSubject> Chosen(const CommandLine& line) {
  std::vector<NamedSubject> chosen;
  std::set<std::string> files;
  for (NamedSubject& subject : AllSubjects()) {
    if (!files.insert(FileName(subject.name)).second) {
      throw std::logic_error("two subjects are called " + subject.name);
    }
    if (MatchesAny(line.only, subject.name)) chosen.push_back(std::move(subject));
  }
  if (chosen.empty()) throw std::invalid_argument("there is no such subject");
  return chosen;
}

int Run(const std::vector<std::string>& words) {
  try {
    const CommandLine line = Parse(words);
    std::vector<NamedSubject> chosen = Chosen(line);
    if (line.list) {
      for (const NamedSubject& subject : chosen) fmt::print("{}\n", subject.name);
      return 0;
    }
    std::filesystem::create_directories(line.out);
    Dump(std::move(chosen), line).Run();
    return 0;
  } catch (const std::invalid_argument& error) {
    fmt::print(stderr, "verdict_dump: {}\n{}", error.what(), kUsage);
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "verdict_dump: {}\n", error.what());
    return 3;
  }
}

}  // namespace
}  // namespace rasterproof::baseline

int main(int argc, char** argv) { return rasterproof::baseline::Run({argv + 1, argv + argc}); }
