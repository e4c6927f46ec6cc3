#include "tool/certify/passport.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "core/authority.h"
#include "core/quoted.h"
#include "core/result.h"
#include "fmt/format.h"
#include "io/base64.h"
#include "io/case_file.h"
#include "io/json_document.h"
#include "io/output.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/failure.h"
#include "web/engine/open.h"
#include "web/engine/session.h"

namespace rasterproof::tool {
namespace {

using io::JsonKind;
using io::JsonValue;

constexpr std::string_view kSaveAgain = "save it from the page again";

std::string BytesOf(const JsonValue& value) {
  const std::optional<std::string> bytes = io::FromBase64(value.RequireString());
  if (!bytes) throw value.Error("is no base64", std::string(kSaveAgain));
  return *bytes;
}

void RequireThisVersion(const JsonValue& version) {
  if (version.RequireString() == RASTERPROOF_VERSION) return;
  throw version.Error(fmt::format("was {}, this is {}, and each draws cases of its own",
                                  Quoted(version.text()), RASTERPROOF_VERSION),
                      "judge it by the version that made it");
}

// What the page says it asked is what its engine was asked.
void RequireSameAsked(const JsonValue& root, const JsonValue& opened) {
  const std::optional<JsonValue> asked = root.Find("asked");
  if (!asked) return;
  for (const std::string_view key : {"seed", "cases"}) {
    const auto said = asked->Find(key);
    const auto was = opened.Find(key);
    if (said && (!was || !said->IsSameAs(*was)))
      throw said->Error("is not that of the cases", std::string(kSaveAgain));
  }
}

void RequireFollows(const JsonValue& said, const JsonValue& derived) {
  if (!said.IsSameAs(derived))
    throw said.Error("does not follow from the answers that it rests on", std::string(kSaveAgain));
}

std::string_view OutcomeOf(int status) {
  if (status == kExitHolds) return "holds";
  return status == kExitViolated ? "violated" : "inconclusive";
}

// How many triangles the drawer lost in long calls while it proved itself.
std::int64_t LostByDrawer(const JsonValue& root) {
  std::int64_t lost = 0;
  const std::optional<JsonValue> proof = root.Find("proof");
  if (!proof || proof->kind() == JsonKind::kNull) return lost;
  for (const JsonValue& check : proof->Get("checks").RequireArray()) {
    const std::optional<JsonValue> of_check = check.Find("lost");
    if (of_check) lost += of_check->RequireInteger(0, std::numeric_limits<std::int32_t>::max());
  }
  return lost;
}

int TellJudged(const web::Session& session, int status, std::int64_t lost) {
  std::string text;
  std::uint64_t cases = 0;
  std::size_t properties = 0;
  for (const PropertyResult& result : session.Results()) {
    cases += result.cases;
    if (result.cases != 0) ++properties;
    if (!result.counterexample) continue;
    const Counterexample& failure = *result.counterexample;
    text += FailureLine(session.info(), result.property, failure.value, failure.verdict) + "\n";
  }
  text += fmt::format(
      "{}: {} under {}: {} properties, {} cases. This follows from the recorded answers; that the "
      "device gave them is taken on trust.\n",
      session.info().name, OutcomeOf(status), io::ProfileName(session.info().profile), properties,
      cases);
  if (lost > 0 && status == kExitInconclusive)
    text += fmt::format("{} triangles were lost while the drawer proved itself.\n", lost);
  io::WriteStandardOutput(text);
  return status;
}

}  // namespace

int RunPassport(const std::string& path) {
  RequireHonestEnvironment();
  const io::JsonDocument document(io::ReadFile(path), path);
  const JsonValue root = document.root();
  root.Get("rasterproof_passport").RequireInteger(1, 1);
  const std::optional<JsonValue> result = root.Find("result");
  if (!result || result->kind() == JsonKind::kNull) {
    io::WriteStandardOutput(
        fmt::format("inconclusive: {}\n", Quoted(root.Get("reason").RequireString())));
    return kExitInconclusive;
  }
  RequireThisVersion(result->Get("version"));
  RequireSameAsked(root, result->Get("opened"));
  web::Session session(web::OpenedFrom(result->Get("opened")));
  const JsonValue saved = root.Get("saved");
  session.Load(BytesOf(saved));
  if (!session.IsDone())
    throw saved.Error("does not answer what the cases of this seed ask", std::string(kSaveAgain));
  const io::JsonDocument derived(session.Result(), "the derived verdict");
  const JsonValue status = derived.root().Get("status");
  RequireFollows(result->Get("status"), status);
  RequireFollows(result->Get("subjects"), derived.root().Get("subjects"));
  const std::int64_t lost = LostByDrawer(root);
  int worst = static_cast<int>(status.RequireInteger(0, kExitInconclusive));
  if (worst == kExitHolds && lost > 0) worst = kExitInconclusive;
  const JsonValue outcome = root.Get("outcome");
  if (outcome.RequireString() != OutcomeOf(worst))
    throw outcome.Error("does not follow from the answers that it rests on",
                        std::string(kSaveAgain));
  return TellJudged(session, worst, lost);
}

}  // namespace rasterproof::tool
