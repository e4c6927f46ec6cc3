// rasterproof doctor: its options.
#include "tool/doctor/cmd_doctor.h"
#include "tool/verb_options.h"

namespace rasterproof::tool {
namespace {

Run AddDoctor(CLI::App* /*verb*/, const Invocation& /*call*/) { return RunDoctor; }

}  // namespace

extern constinit const Verb kDoctorVerb{"doctor", VerbGroup::kDevelopment, 40,
                                        "Check that this machine and build can be trusted to judge",
                                        AddDoctor};

}  // namespace rasterproof::tool
