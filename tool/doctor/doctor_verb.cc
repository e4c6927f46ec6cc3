// rasterproof doctor: whether this machine and this build can be trusted to judge.
#include <string>

#include "exact/edge.h"
#include "exact/environment.h"
#include "fmt/format.h"
#include "io/output.h"
#include "lab/sweep/sweep_builds.h"
#include "tool/exit_status.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

int RunDoctor() {
  const exact::Environment environment = exact::InspectEnvironment();
  const auto yes = [](bool good) { return good ? "yes" : "NO"; };
  std::string text = fmt::format(
      "compiler                 {}\nflags                    {}\nrounds to nearest        {}\n"
      "keeps subnormals         {}\ncontraction is off       {}\nnot under valgrind       {}\n",
      environment.compiler, environment.flags, yes(environment.round_to_nearest),
      yes(environment.subnormals_kept), yes(environment.contraction_off),
      yes(!environment.under_valgrind));
  bool agree = true;
  if (environment.Honest()) {
    // Two triples on which plain double arithmetic says 0, by underflow and by overflow; the truth
    // is not 0.
    for (const double scale : {1e-200, 1e200}) {
      const Point2 a{0, 0};
      const Point2 b{scale, scale};
      const Point2 p{2 * scale, 3 * scale};
      const int fast = exact::EdgeSign(a, b, p, exact::Decider::kFast);
      agree = agree && fast != 0 && fast == exact::EdgeSign(a, b, p, exact::Decider::kIntegers) &&
              fast == exact::EdgeSign(a, b, p, exact::Decider::kCgal);
    }
  }
  text +=
      fmt::format("three deciders agree     {}\n", environment.Honest() ? yes(agree) : "not asked");
  text += lab::ToolsText();
  const std::string complaint = environment.Complaint();
  if (!complaint.empty()) text += complaint + "\n";
  io::WriteStandardOutput(text);
  if (!environment.Honest()) return kExitUsage;
  return agree ? kExitHolds : kExitFault;
}

Run AddDoctor(CLI::App* /*verb*/, const Invocation& /*call*/) { return RunDoctor; }

}  // namespace

extern constinit const Verb kDoctorVerb{"doctor", VerbGroup::kDevelopment, 40,
                                        "Check that this machine and build can be trusted to judge",
                                        AddDoctor};

}  // namespace rasterproof::tool
