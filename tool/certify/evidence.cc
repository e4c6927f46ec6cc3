#include "tool/certify/evidence.h"

#include <array>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "fmt/format.h"
#include "io/json_document.h"
#include "io/output.h"
#include "props/run/not_asked.h"
#include "tool/shared_files.h"

namespace rasterproof::tool {
namespace {

// Of every script: "edge_direct.g 0123... edge_kahan.g 4567...", as the build found them.
constexpr std::string_view kHashes = RASTERPROOF_PROOF_HASHES;

// Empty if this program was built without the script.
std::string HashOf(const std::string& script) {
  std::istringstream words{std::string(kHashes)};
  std::string name;
  std::string hash;
  while (words >> name >> hash) {
    if (name == script) return hash;
  }
  return "";
}

// What the tests wrote of a script that they ran.
struct Record {
  std::string sha256;
  std::string gappa;
  std::string date;
};

std::optional<Record> ReadRecord(const std::string& script) {
  constexpr std::array<std::string_view, 5> kKeys{"rasterproof_proof", "script", "sha256", "gappa",
                                                  "date"};
  const std::optional<std::string> path =
      FindShared("proofs/" + script.substr(0, script.rfind('.')) + ".json");
  if (!path) return std::nullopt;
  try {
    const std::string text = io::ReadFile(*path);
    const io::JsonDocument document(text, *path);
    const io::JsonValue root = document.root();
    root.RequireObject(kKeys);
    root.Get("rasterproof_proof").RequireInteger(1, 1);  // the version
    if (root.Get("script").RequireString() != script) return std::nullopt;
    return Record{std::string(root.Get("sha256").RequireString()),
                  std::string(root.Get("gappa").RequireString()),
                  std::string(root.Get("date").RequireString())};
  } catch (const InputError&) {  // what can't be read records nothing
    return std::nullopt;
  }
}

std::string WhereProved(const std::string& script) {
  const std::string hash = HashOf(script);
  const std::string named = fmt::format("reference/proofs/{}, sha256 {}", script, hash);
  const std::optional<Record> record = ReadRecord(script);
  if (hash.empty() || !record || record->sha256 != hash) {
    return named + ": not run for this source";
  }
  return fmt::format("{}: run by this build's tests, Gappa {}, {}", named, record->gappa,
                     record->date);
}

}  // namespace

std::vector<report::Evidence> ProvedOf(const SubjectInfo& info) {
  std::vector<report::Evidence> proved;
  for (const Proof& proof : info.proofs) {
    proved.push_back({proof.statement, WhereProved(proof.script)});
  }
  return proved;
}

std::vector<report::Evidence> UnaskedOf(const SubjectInfo& info,
                                        std::span<const props::Shows> outputs,
                                        std::span<const PropertyResult> results) {
  std::vector<report::Evidence> unasked;
  for (const props::NotAskedOf& one : props::NotAsked(info, outputs, results)) {
    unasked.push_back({one.what, one.why});
  }
  return unasked;
}

}  // namespace rasterproof::tool
