// rasterproof vectors: its options.
#include "tool/vectors/cmd_vectors.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

Run AddVectors(CLI::App* verb, const Invocation& /*call*/) {
  static GenerateOptions generate_options;
  static VerifyOptions verify_options;
  verb->require_subcommand(1);
  CLI::App* generate = verb->add_subcommand("generate", "Write cases drawn for a profile");
  generate->add_option("--profile", generate_options.profile, "Profile")->required();
  generate->add_option("--level", generate_options.level, "1: 500 cases, 2: 50,000")
      ->check(CLI::IsMember({1, 2}))
      ->capture_default_str();
  generate->add_option("--cases", generate_options.cases, "Cases, instead of the level's number")
      ->check(Positive());
  AddSeed(generate, generate_options.seed);
  CLI::Option* const world =
      generate->add_option("--world", generate_options.world,
                           "Instead of drawn cases, every triangle with so many bits before and "
                           "after the point of a coordinate (2.1; with a sign s2.1)");
  for (const char* of_drawn : {"--level", "--cases", "--seed"})
    world->excludes(generate->get_option(of_drawn));
  generate->add_flag("--yes", generate_options.yes, "Accept a world of any number of cases")
      ->needs(world);
  generate->add_flag("--values", generate_options.values,
                     "Also what channels hold at covered samples, and the floats that the "
                     "profile's error allows");
  generate->add_option("--format", generate_options.format, "Format of the files")
      ->check(CLI::IsMember({"jsonl", "c", "readmemh"}))
      ->capture_default_str();
  generate
      ->add_option("-o,--out", generate_options.output,
                   "File (- for standard output); for readmemh a folder")
      ->capture_default_str();
  CLI::App* verify = verb->add_subcommand(
      "verify", "Find answers that contradict every legal drawing; finding none proves nothing");
  verify->add_option("vectors", verify_options.vectors, "File of generate in the format jsonl")
      ->required();
  CLI::Option* const answers = verify->add_option(
      "answers", verify_options.answers, "Your rasterizer's answers (- for standard input)");
  AddSubject(verify, verify_options.subject, "Subject that draws, instead of a file of answers");
  for (const char* subject : {"--subject", "--plugin", "--exec"})
    answers->excludes(verify->get_option(subject));
  verify
      ->add_flag(
          "--alone", verify_options.alone,
          "Each answer comes from its own call: skip joint constraints, which are about one call")
      ->excludes(verify->get_option("--subject"));
  verify->add_option("--show", verify_options.shown, "Maximum contradictions to print")
      ->capture_default_str();
  return [generate] {
    return generate->parsed() ? RunGenerate(generate_options) : RunVerify(verify_options);
  };
}

}  // namespace

extern constinit const Verb kVectorsVerb{
    "vectors", VerbGroup::kCampaign, 70,
    "Write cases and their required coverage as files for your own test bench", AddVectors};

}  // namespace rasterproof::tool
