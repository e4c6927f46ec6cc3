#include "tool/verb_options.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/authority.h"
#include "tool/subject_kinds.h"
#include "tool/typed_number.h"
#include "tool/workers.h"

namespace rasterproof::tool {
namespace {

// Adds --plugin and --exec, two more ways to name subjects, and what those may cost.
void AddOutside(CLI::App* app, const std::function<void(const std::string&)>& add) {
  app->add_option_function<std::vector<std::string>>(
         "--plugin",
         [add](const std::vector<std::string>& paths) {
           for (const std::string& path : paths) add(std::string(kPluginPrefix) + path);
         },
         "Shared library with the interface of kit/rasterproof_plugin.h")
      ->allow_extra_args(false);
  app->add_option_function<std::vector<std::string>>(
         "--exec",
         [add](const std::vector<std::string>& commands) {
           for (const std::string& command : commands) add(std::string(kExecPrefix) + command);
         },
         "Program that answers requests on a pipe (docs/subjects.md)")
      ->allow_extra_args(false);
  app->add_option("--time-limit", OutsideLimits().seconds,
                  "Time limit in seconds for one answer of a plugin or program")
      ->check(Positive())
      ->capture_default_str();
  app->add_option_function<double>(
         "--memory-limit",
         [](double gibibytes) {
           OutsideLimits().bytes = static_cast<std::uint64_t>(gibibytes * 0x1p30);
         },
         "Limit of its address space in GiB (0: no limit)")
      ->check(CLI::NonNegativeNumber)
      ->default_str("4");
}

}  // namespace

CLI::Validator Positive() {
  const auto check = [](const std::string& text) {
    double number = 0;
    const bool is_positive = CLI::detail::lexical_cast(text, number) && number > 0;
    return is_positive ? std::string() : text + " is no number above 0";
  };
  return CLI::Validator(check, "POSITIVE");
}

void AddCount(CLI::App* app, const std::string& option, const std::string& help, int most,
              const std::function<void(int)>& take, int usual) {
  const auto parse = [=](const std::string& text) { take(ParseCount(option, text, most)); };
  app->add_option_function<std::string>(option, parse, help)
      ->type_name("COUNT")
      ->default_str(std::to_string(usual));
}

void AddJobs(CLI::App* app, int& jobs, const std::string& what) {
  jobs = DefaultJobs();
  AddCount(
      app, "--jobs", what + " at once (default: one per core)", kMostJobs,
      [&jobs](int count) { jobs = count; }, jobs);
}

void AddSubject(CLI::App* app, std::string& subject, const std::string& help) {
  app->add_option("--subject", subject, help)->capture_default_str();
  AddOutside(app, [&subject](const std::string& name) { subject = name; });
}

void AddSubjects(CLI::App* app, std::vector<std::string>& subjects, const std::string& own) {
  app->add_option("--subject", subjects, "Subjects")->default_str(own);
  AddOutside(app, [&subjects](const std::string& name) { subjects.push_back(name); });
}

void AddSeed(CLI::App* app, std::uint64_t& seed, const std::string& of) {
  app->add_option_function<std::string>(
         "--seed", [&seed](const std::string& text) { seed = ParseSeed(text); },
         "Seed of the " + of + ", or 'random' (and print it)")
      ->default_str("1");
}

void AddSeconds(CLI::App* app, props::CampaignOptions& campaign, const std::string& of) {
  app->add_option("--seconds", campaign.seconds, "Maximum seconds per " + of + " (0: no limit)")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

void AddCampaign(CLI::App* app, props::CampaignOptions& campaign, const std::string& of) {
  AddSeed(app, campaign.seed);
  app->add_option("--cases", campaign.cases, "Cases per " + of)
      ->check(Positive())
      ->capture_default_str();
  AddSeconds(app, campaign, of);
}

void AddListLength(CLI::App* app, std::size_t& length) {
  app->add_option_function<std::string>(
         "--list-length", [&length](const std::string& text) { length = ParseListLength(text); },
         "Triangles before the mesh in the longest list")
      ->type_name("COUNT")
      ->default_str("65537; for a program 257");
}

void AddFailOn(CLI::App* verb, FailOn& fail_on) {
  verb->add_option("--fail-on", fail_on, "Violations that fail: of what is stated, or of quality")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, FailOn>{{"stated", FailOn::kStated},
                                                                {"quality", FailOn::kQuality}})
              .description("{stated,quality}"))
      ->default_str("stated");
}

}  // namespace rasterproof::tool
