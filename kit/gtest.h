// The properties of your rasterizer as tests of GoogleTest, one each:
//
//     #include "kit/gtest.h"
//     struct Mine {
//       bool Draw(const rasterproof_scene& scene, const rasterproof_target& target);
//     };
//     RASTERPROOF_TEST(MyRasterizer, Mine, "vulkan", 200)
//
// Draw adds to target.front how many triangles cover each sample, as kit/rasterproof_plugin.h says,
// and returns false to refuse a scene. What else a plugin may state (coverage, input, what it
// takes) a `static void Describe(rasterproof_plugin& plugin)` sets. Mine is default-constructible,
// made once in a process and called by one thread.
//
// A test runs `rasterproof check` on the property; Mine draws in a process of its own, which is
// this test program begun again. A crash or a hang fails that test alone, and the text of a failure
// is the command's; the first one of a suite in a process tells causes, too. A property that does
// not apply to what Mine says of itself has no test, and one that no case exercised is skipped with
// the reason. Filters, shards and repeats are GoogleTest's. Seed and number of cases are fixed, so
// that a run is the same tomorrow; more options of `check` are taken from the environment variable
// RASTERPROOF_CHECK_OPTIONS ("--time-limit 1": what hangs costs ten times that once a test).
//
// "--known known.json" there is a list of known failures: they are skipped with owner and day, and
// those that pass say so. Its key "subject" is the suite's name.
//
// The command finds the suite in a file beside this test program, PROGRAM.SUITE.subject, as do the
// commands that failures name. Where none can be written there it is a temporary one, which stays
// after a failure.
//
// The command is the one in the environment variable RASTERPROOF_COMMAND, else the one that the
// macro of that name says (CMake's rasterproof::gtest does), else `rasterproof` in PATH.
//
// C++17, GoogleTest 1.10 or later, Linux. Nothing but GoogleTest is linked.
#ifndef RASTERPROOF_KIT_GTEST_H_
#define RASTERPROOF_KIT_GTEST_H_

#if __cplusplus < 201703L
#error "kit/gtest.h needs C++17: compile this file with -std=c++17 or a later standard"
#endif

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "kit/plugin_server.h"
#include "kit/rasterproof_plugin.h"

namespace rasterproof::kit {

/// What a suite checks.
struct Suite {
  std::string name;
  std::string profile;  ///< a preset's name or the text of a profile file
  unsigned long long cases = 0;
  rasterproof_plugin plugin = {};
};

namespace gtest_internal {

inline constexpr const char* kServe = "RASTERPROOF_GTEST_SERVE";
inline constexpr int kNothingJudged = 4;  // the command's exit status

inline std::string Quoted(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

inline std::string Command() {
  if (const char* named = std::getenv("RASTERPROOF_COMMAND")) return named;
#ifdef RASTERPROOF_COMMAND
  return RASTERPROOF_COMMAND;
#else
  return "rasterproof";
#endif
}

struct Ended {
  int status = -1;
  std::string output;
};

inline Ended ShellOutput(const std::string& line) {
  Ended ended;
  std::FILE* const pipe = popen(line.c_str(), "r");
  if (pipe == nullptr) return ended;
  char bytes[4096];
  for (std::size_t n; (n = std::fread(bytes, 1, sizeof bytes, pipe)) != 0;)
    ended.output.append(bytes, n);
  const int status = pclose(pipe);
  ended.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return ended;
}

// Names of the properties that apply to the subject; empty if there is no such command. Where it
// can't read the description it lists all, and each test tells why.
inline std::vector<std::string> PropertyNames(const std::string& subject) {
  std::vector<std::string> names;
  const std::string list = Quoted(Command()) + " list properties";
  const std::string those = " --subject " + Quoted(subject) + " 2>/dev/null";
  const Ended listed = ShellOutput(list + those + " || " + list + " 2>/dev/null");
  std::size_t begin = 0;
  while (listed.status == 0 && begin < listed.output.size()) {
    const std::size_t end = listed.output.find('\n', begin);
    const std::string line = listed.output.substr(begin, end - begin);
    const std::size_t bracket = line.find(" (");
    if (line.size() > 2 && line[0] == ' ' && std::isupper(static_cast<unsigned char>(line[2])) &&
        bracket != std::string::npos) {
      names.push_back(line.substr(2, bracket - 2));
    }
    begin = end == std::string::npos ? listed.output.size() : end + 1;
  }
  return names;
}

inline std::string ThisProgram() {
  char self[4096] = {};
  const ssize_t size = readlink("/proc/self/exe", self, sizeof self - 1);
  return std::string(self, size < 0 ? 0 : static_cast<std::size_t>(size));
}

// A suite's description as a file.
class DescriptionFile {
 public:
  DescriptionFile(const std::string& suite, const std::string& text) {
    const std::string beside = ThisProgram() + "." + suite + ".subject";
    // Renamed when it is whole: tests of the suite may run at once.
    if (Write(beside + "XXXXXX", 0, text) && std::rename(path_.c_str(), beside.c_str()) == 0) {
      path_ = beside;
      is_kept_ = true;
      return;
    }
    Remove();
    Write(::testing::TempDir() + "rasterproofXXXXXX.subject", 8, text);
  }
  DescriptionFile(const DescriptionFile&) = delete;
  DescriptionFile& operator=(const DescriptionFile&) = delete;
  ~DescriptionFile() {
    if (!is_kept_) Remove();
  }
  void Keep() { is_kept_ = true; }
  const std::string& path() const { return path_; }
  bool is_written() const { return is_written_; }

 private:
  bool Write(const std::string& pattern, int ending, const std::string& text) {
    path_ = pattern;
    const int file = mkstemps(path_.data(), ending);
    is_made_ = file >= 0;
    std::FILE* const out = file < 0 ? nullptr : fdopen(file, "w");
    if (out == nullptr) return false;
    is_written_ = std::fputs(text.c_str(), out) >= 0;
    is_written_ = std::fclose(out) == 0 && is_written_;
    return is_written_;
  }
  void Remove() {
    if (is_made_) std::remove(path_.c_str());
  }

  std::string path_;
  bool is_made_ = false;
  bool is_written_ = false;
  bool is_kept_ = false;
};

inline std::string DescriptionOf(const Suite& suite) {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* const out = open_memstream(&text, &size);
  rasterproof_describe(&suite.plugin, out);
  std::fclose(out);
  std::string description(text, size);
  std::free(text);
  // Answers go to descriptor 3: what GoogleTest and the rasterizer print is none.
  description += "command sh -c '" + std::string(kServe) +
                 "=\"$1\" exec \"$0\" --gtest_filter=\"$1.Serve\" 3>&1 >/dev/null' " +
                 Quoted(ThisProgram()) + " " + suite.name + "\n";
  return description;
}

// The command's last line that begins with one of the words and names the description, or nothing.
// What the rasterizer prints begins otherwise.
inline std::string LineOf(const std::string& output, const std::string& description,
                          const std::vector<std::string>& words) {
  std::string found;
  std::size_t begin = 0;
  while (begin < output.size()) {
    const std::size_t end = std::min(output.find('\n', begin), output.size());
    const std::string line = output.substr(begin, end - begin);
    const bool is_one = std::any_of(words.begin(), words.end(), [&](const std::string& word) {
      return line.rfind(word + " ", 0) == 0;
    });
    if (is_one && line.find(" " + description + " ") != std::string::npos) found = line;
    begin = end + 1;
  }
  return found;
}

class PropertyTest : public ::testing::Test {
 public:
  PropertyTest(const Suite& suite, std::string property)
      : suite_(suite), property_(std::move(property)) {}

  void TestBody() override {
    DescriptionFile description(suite_.name, DescriptionOf(suite_));
    ASSERT_TRUE(description.is_written())
        << "rasterproof: " << description.path() << " can't be written; set TEST_TMPDIR";
    const char* const more = std::getenv("RASTERPROOF_CHECK_OPTIONS");
    static std::vector<std::string> have_told_causes;  // suites
    const bool is_told =
        std::count(have_told_causes.begin(), have_told_causes.end(), suite_.name) != 0;
    const Ended ended = ShellOutput(
        Quoted(Command()) + " check --subject " + Quoted(description.path()) + " --property " +
        property_ + " --cases " + std::to_string(suite_.cases) + " --jobs 1 " +
        (is_told ? "--no-cause " : "") + (more == nullptr ? "" : more) + " 2>&1");
    if (ended.status == 0) {
      const std::string known = LineOf(ended.output, description.path(), {"known"});
      if (!known.empty()) GTEST_SKIP() << known;
      const std::string passes = LineOf(ended.output, description.path(), {"passes"});
      if (!passes.empty()) std::printf("%s\n", passes.c_str());
      return;
    }
    const std::string why =
        LineOf(ended.output, description.path(), {"not applicable", "not exercised"});
    if (ended.status == kNothingJudged && !why.empty()) GTEST_SKIP() << why;
    description.Keep();  // the command to type again names it
    ADD_FAILURE() << ended.output
                  << (is_told ? "causes: see the suite's first failure, or run this one alone\n"
                              : "");
    have_told_causes.push_back(suite_.name);
  }

 private:
  const Suite& suite_;
  std::string property_;
};

class ServeTest : public ::testing::Test {
 public:
  explicit ServeTest(const Suite& suite) : suite_(suite) {}
  void TestBody() override {
    std::FILE* const out = fdopen(3, "w");
    ASSERT_NE(out, nullptr) << "rasterproof: " << kServe << " is for the suite's own use; unset it";
    rasterproof_serve(&suite_.plugin, stdin, out);
  }

 private:
  const Suite& suite_;
};

class NoCommandTest : public ::testing::Test {
 public:
  void TestBody() override {
    FAIL() << "rasterproof: the command " << Command() << " can't be run; set RASTERPROOF_COMMAND "
           << "to its path";
  }
};

template <class Type, class = void>
struct Describes : std::false_type {};
template <class Type>
struct Describes<Type, std::void_t<decltype(Type::Describe(std::declval<rasterproof_plugin&>()))>>
    : std::true_type {};

template <class Type>
rasterproof_plugin PluginOf(const char* name, const char* profile) {
  rasterproof_plugin plugin{};
  plugin.version = RASTERPROOF_PLUGIN_VERSION;
  plugin.size = sizeof plugin;
  plugin.name = name;
  plugin.coverage = RASTERPROOF_COUNTS;
  plugin.edge_error = -1;
  plugin.stepping_error = -1;
  plugin.open = []() -> void* { return new Type(); };
  plugin.draw = [](void* state, const rasterproof_scene* scene,
                   const rasterproof_target* target) -> std::int32_t {
    return static_cast<Type*>(state)->Draw(*scene, *target) ? 0 : 1;
  };
  plugin.close = [](void* state) { delete static_cast<Type*>(state); };
  if constexpr (Describes<Type>::value) Type::Describe(plugin);
  plugin.profile = profile;
  return plugin;
}

}  // namespace gtest_internal

/// Registers a test of each property that applies. The suite lives as long as the program.
///
/// Returns:    the number of tests.
inline int RegisterTests(const Suite& suite, const char* file, int line) {
  using ::testing::RegisterTest;
  const auto add = [&](const std::string& name, auto make) {
    RegisterTest(suite.name.c_str(), name.c_str(), nullptr, nullptr, file, line, std::move(make));
  };
  if (const char* served = std::getenv(gtest_internal::kServe)) {
    if (suite.name != served) return 0;
    add("Serve", [&suite]() -> ::testing::Test* { return new gtest_internal::ServeTest(suite); });
    return 1;
  }
  const gtest_internal::DescriptionFile description(suite.name,
                                                    gtest_internal::DescriptionOf(suite));
  const std::vector<std::string> names = gtest_internal::PropertyNames(description.path());
  for (const std::string& name : names) {
    add(name, [&suite, name]() -> ::testing::Test* {
      return new gtest_internal::PropertyTest(suite, name);
    });
  }
  if (!names.empty()) return static_cast<int>(names.size());
  add("TheCommandRuns", []() -> ::testing::Test* { return new gtest_internal::NoCommandTest(); });
  return 1;
}

}  // namespace rasterproof::kit

/// Tests Type by every property, each on `cases` generated cases, as a suite of that name.
/// `profile` is what the rasterizer states: a preset's name ("real", "vulkan", "gl-canonical") or
/// the text of a profile file.
#define RASTERPROOF_TEST(SuiteName, Type, profile, cases)                       \
  static const ::rasterproof::kit::Suite rasterproof_suite_##SuiteName{         \
      #SuiteName, profile, cases,                                               \
      ::rasterproof::kit::gtest_internal::PluginOf<Type>(#SuiteName, profile)}; \
  [[maybe_unused]] static const int rasterproof_tests_##SuiteName =             \
      ::rasterproof::kit::RegisterTests(rasterproof_suite_##SuiteName, __FILE__, __LINE__);

#endif  // RASTERPROOF_KIT_GTEST_H_
