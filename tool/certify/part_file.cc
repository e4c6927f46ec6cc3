#include "tool/certify/part_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

#include "core/counters.h"
#include "core/error.h"
#include "core/hash_text.h"
#include "core/quoted.h"
#include "core/result.h"
#include "core/scene.h"
#include "core/verdict.h"
#include "core/witness.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/json_document.h"
#include "io/json_writer.h"
#include "io/number_text.h"
#include "io/output.h"

namespace rasterproof::tool {
namespace {

using io::JsonValue;
using io::JsonWriter;

constexpr int kPartVersion = 6;

constexpr std::array<std::pair<End, std::string_view>, 4> kEnds{
    {{End::kAllRun, "all run"},
     {End::kNotApplicable, "not applicable"},
     {End::kFailed, "failed"},
     {End::kInconclusive, "inconclusive"}}};
constexpr std::array<Outcome, 3> kFoundOutcomes{Outcome::kViolated, Outcome::kInconclusive,
                                                Outcome::kHolds};

// Writing.

void WriteSums(JsonWriter& json, const PropertyResult& sums) {
  json.Members(kCaseCounters, sums);
  json.Key("worst_ratio").Exact(sums.worst_ratio);
  json.Key("why_not").Text(sums.why_not);
  json.Key("why_refused").Text(sums.why_refused);
  json.Key("grids").BeginArray();
  for (const GridsOnTarget& grids : sums.grids) {
    json.BeginObject();
    json.Key("width").Integer(static_cast<std::uint64_t>(grids.width));
    json.Key("height").Integer(static_cast<std::uint64_t>(grids.height));
    json.Key("samples").Integer(static_cast<std::uint64_t>(grids.samples));
    json.Key("clip_space").Integer(std::uint64_t{grids.clip_space});
    json.Key("cases").Integer(grids.cases);
    json.Key("left").Integer(grids.left.set());
    json.EndObject();
  }
  json.EndArray();
  json.Key("domains").BeginArray();
  for (const DomainCounts& domain : sums.domains) {
    json.BeginObject();
    json.Key("drawn").Integer(domain.drawn);
    json.Members(kNearEdgeCounters, domain.near_edge);
    json.EndObject();
  }
  json.EndArray();
  json.Key("draws").BeginObject().Members(kDrawsJudged, sums.draws).EndObject();
  json.Key("places").BeginArray();
  for (const PlaceCounts& counts : sums.places) {
    json.BeginObject();
    json.Members(kPlaceCounters, counts);
    json.EndObject();
  }
  json.EndArray();
}

// Of a NaN its sign is written too: a witness shows it.
struct PartWriter {
  JsonWriter& json;

  void operator()(const std::string& words) const { json.Text(words); }
  void operator()(std::int64_t integer) const { json.Integer(integer); }
  void operator()(FacingCounts counts) const {
    json.BeginObjectLine().Key("front").Integer(counts.front);
    json.Key("back").Integer(counts.back).EndObject();
  }
  void operator()(CountSet counts) const {
    json.BeginObjectLine().Key("counts").BeginArray();
    for (int n = 0; n < 64; ++n) {
      if ((counts.bits >> n & 1U) != 0) json.Integer(n);
    }
    json.EndArray().EndObject();
  }
  void operator()(double number) const {
    json.BeginObjectLine().Key("double").Text(HexText(number)).EndObject();
  }
  void operator()(const RationalText& rational) const {
    json.BeginObjectLine().Key("rational").Text(rational.text).EndObject();
  }
};

void WriteValue(JsonWriter& json, std::string_view key, const WitnessValue& value) {
  json.Key(key).BeginArray();
  for (const WitnessPart& part : value) std::visit(PartWriter{json}, part);
  json.EndArray();
}

void WriteWitness(JsonWriter& json, const Witness& witness) {
  json.Key("witness").BeginObject();
  json.Key("triangle").Integer(witness.triangle).Key("edge").Integer(witness.edge);
  json.Key("x").Integer(witness.x).Key("y").Integer(witness.y);
  json.Key("sample").Integer(witness.sample);
  WriteValue(json, "observed", witness.observed);
  WriteValue(json, "expected", witness.expected);
  json.EndObject();
}

void WriteFound(JsonWriter& json, const std::string& property, const Counterexample& found) {
  json.Key("found").BeginObject();
  json.Key("as_case").Text(found.failing_case);
  json.Key("outcome").Text(OutcomeName(found.outcome));
  json.Key("message").Text(found.message);
  json.Key("case").Text(io::CaseToJson({found.value, "", property, found.verdict.drawn}));
  json.Key("said_outcome").Text(OutcomeName(found.verdict.outcome));
  json.Key("said").Text(found.verdict.message);
  if (found.verdict.witness) WriteWitness(json, *found.verdict.witness);
  json.EndObject();
}

void WriteTest(JsonWriter& json, const PropertyResult& result) {
  json.BeginObject();
  json.Key("property").Text(result.property);
  json.Key("world").Text(result.world);
  for (const auto& [end, name] : kEnds) {
    if (end == result.end) json.Key("end").Text(name);
  }
  json.Key("why").Text(result.why);
  json.Key("seconds").Exact(result.seconds);
  WriteSums(json, result);
  json.Key("oracle_tiers").BeginObject().Members(kTiers, result.tiers).EndObject();
  if (result.counterexample) WriteFound(json, result.property, *result.counterexample);
  json.EndObject();
}

// Reading.

std::string TextOf(const JsonValue& value) { return std::string(value.RequireString()); }

template <class T>
T IntegerOf(const JsonValue& value) {
  using Limits = std::numeric_limits<T>;
  constexpr std::int64_t kMost = sizeof(T) == 8 ? std::numeric_limits<std::int64_t>::max()
                                                : static_cast<std::int64_t>(Limits::max());
  constexpr std::int64_t kLeast = static_cast<std::int64_t>(Limits::min());
  return static_cast<T>(value.RequireInteger(kLeast, kMost));
}

double ExactOf(const JsonValue& value) {
  const io::NumberFromText number = io::ExactNumber(value.RequireString(), Precision::kFloat64);
  if (!number.fault.empty()) {
    throw value.Error(std::string(number.fault), std::string(number.remedy));
  }
  return number.value;
}

template <class T, std::size_t kCount>
void Read(const Counters<T, kCount>& counters, const JsonValue& object, T& to) {
  for (const auto& [name, counter] : counters) {
    to.*counter = IntegerOf<std::uint64_t>(object.Get(name));
  }
}

void ReadSums(const JsonValue& object, PropertyResult& sums) {
  Read(kCaseCounters, object, sums);
  sums.worst_ratio = ExactOf(object.Get("worst_ratio"));
  sums.why_not = TextOf(object.Get("why_not"));
  sums.why_refused = TextOf(object.Get("why_refused"));
  for (const JsonValue grids : object.Get("grids").RequireArray()) {
    sums.grids.push_back({.width = IntegerOf<int>(grids.Get("width")),
                          .height = IntegerOf<int>(grids.Get("height")),
                          .samples = IntegerOf<int>(grids.Get("samples")),
                          .clip_space = grids.Get("clip_space").RequireInteger(0, 1) == 1,
                          .cases = IntegerOf<std::uint64_t>(grids.Get("cases")),
                          .left = GridsLeft(IntegerOf<std::uint64_t>(grids.Get("left")))});
  }
  for (const JsonValue domain : object.Get("domains").RequireArray()) {
    DomainCounts& counts = sums.domains.emplace_back();
    counts.drawn = IntegerOf<std::uint64_t>(domain.Get("drawn"));
    Read(kNearEdgeCounters, domain, counts.near_edge);
  }
  Read(kDrawsJudged, object.Get("draws"), sums.draws);
  const JsonValue places = object.Get("places");
  if (places.RequireArray().size() != sums.places.size()) {
    throw places.Error("has the wrong number of entries", "run the part again");
  }
  auto counts = sums.places.begin();
  for (const JsonValue place : places.RequireArray()) Read(kPlaceCounters, place, *counts++);
}

Outcome OutcomeOf(const JsonValue& value) {
  for (const Outcome outcome : kFoundOutcomes) {
    if (OutcomeName(outcome) == value.RequireString()) return outcome;
  }
  throw value.Error("is not an outcome", "run the part again");
}

double DoubleOf(const JsonValue& value) {
  if (value.RequireString() == "-nan") return -std::numeric_limits<double>::quiet_NaN();
  return ExactOf(value);
}

RationalText RationalOf(const JsonValue& value) {
  std::string text = TextOf(value);
  const std::size_t first = text.starts_with('-') ? 1 : 0;
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto is_digits = [](std::string_view digits) {
    return !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
  };
  const std::string_view view = text;
  if (is_digits(view.substr(first, slash - first)) &&
      (slash == text.size() || is_digits(view.substr(slash + 1)))) {
    return {std::move(text)};
  }
  throw value.Error(Quoted(text, 40) + " is not a rational number", "run the part again");
}

WitnessPart PartOf(const JsonValue& value) {
  if (value.kind() == io::JsonKind::kString) return TextOf(value);
  if (value.kind() == io::JsonKind::kNumber) return IntegerOf<std::int64_t>(value);
  if (value.kind() == io::JsonKind::kObject) {
    if (value.Find("front")) {
      return FacingCounts{IntegerOf<std::uint32_t>(value.Get("front")),
                          IntegerOf<std::uint32_t>(value.Get("back"))};
    }
    if (const std::optional<JsonValue> number = value.Find("double")) return DoubleOf(*number);
    if (const std::optional<JsonValue> number = value.Find("rational")) return RationalOf(*number);
    if (const std::optional<JsonValue> counts = value.Find("counts")) {
      CountSet set;
      for (const JsonValue n : counts->RequireArray())
        set.bits |= std::uint64_t{1} << n.RequireInteger(0, 63);
      return set;
    }
  }
  throw value.Error("is not a value of a witness", "run the part again");
}

WitnessValue ValueOf(const JsonValue& list) {
  WitnessValue value;
  for (const JsonValue part : list.RequireArray()) value.push_back(PartOf(part));
  return value;
}

Counterexample FoundOf(const JsonValue& object) {
  Counterexample found;
  found.failing_case = TextOf(object.Get("as_case"));
  found.outcome = OutcomeOf(object.Get("outcome"));
  found.message = TextOf(object.Get("message"));
  const JsonValue file = object.Get("case");
  io::CaseFile parsed = io::ParseCase(file.RequireString(), file.Place());
  found.value = std::move(parsed.value);
  found.verdict.drawn = std::move(parsed.drawn);
  found.verdict.outcome = OutcomeOf(object.Get("said_outcome"));
  found.verdict.message = TextOf(object.Get("said"));
  if (const std::optional<JsonValue> there = object.Find("witness")) {
    Witness& witness = found.verdict.witness.emplace();
    witness.triangle = IntegerOf<int>(there->Get("triangle"));
    witness.edge = IntegerOf<int>(there->Get("edge"));
    witness.x = IntegerOf<int>(there->Get("x"));
    witness.y = IntegerOf<int>(there->Get("y"));
    witness.sample = IntegerOf<int>(there->Get("sample"));
    witness.observed = ValueOf(there->Get("observed"));
    witness.expected = ValueOf(there->Get("expected"));
  }
  return found;
}

End EndOf(const JsonValue& value) {
  for (const auto& [end, name] : kEnds) {
    if (name == value.RequireString()) return end;
  }
  throw value.Error("is not the way a test ends", "run the part again");
}

PropertyResult TestOf(const JsonValue& object) {
  PropertyResult result;
  result.property = TextOf(object.Get("property"));
  result.world = TextOf(object.Get("world"));
  result.end = EndOf(object.Get("end"));
  result.why = TextOf(object.Get("why"));
  result.seconds = ExactOf(object.Get("seconds"));
  ReadSums(object, result);
  Read(kTiers, object.Get("oracle_tiers"), result.tiers);
  if (result.end == End::kFailed) result.counterexample = FoundOf(object.Get("found"));
  return result;
}

void RequirePart(const JsonValue& root) {
  const std::optional<JsonValue> version =
      root.kind() == io::JsonKind::kObject ? root.Find("rasterproof_part") : std::nullopt;
  if (!version) {
    throw root.Error("is not a part of a campaign",
                     "give files that 'rasterproof certify --shard I/N' wrote");
  }
  if (version->text() == std::to_string(kPartVersion)) return;
  throw version->Error("version " + std::string(version->text()) + " is unknown",
                       "run the part again with this program");
}

std::uint64_t SeedOf(const JsonValue& value) {
  const std::string text = TextOf(value);
  std::uint64_t seed = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, seed);
  if (error == std::errc() && at == end && std::to_string(seed) == text) return seed;
  throw value.Error("is not a seed from 0 to 2^64 - 1", "run the part again");
}

// Reads the range first: later checks compute with it.
void ReadRange(const JsonValue& root, SubjectPart& part) {
  const auto integer = [&](std::string_view key, std::uint64_t least, std::uint64_t most) {
    return static_cast<std::uint64_t>(root.Get(key).RequireInteger(
        static_cast<std::int64_t>(least), static_cast<std::int64_t>(most)));
  };
  if (root.Find("shard")) {
    const std::uint64_t count = integer("shards", 1, kMostShards);
    part.shard = Shard{integer("shard", 1, count), count};
    part.cases = integer("cases", 1, kMostCases);
  } else if (root.Find("shards") || root.Find("cases")) {
    throw root.Error("gives \"shards\" or \"cases\" without \"shard\"", "run the part again");
  }
  const std::uint64_t first = integer("first", 0, kMostCases);
  part.range = {first, integer("end", part.shard ? first : first + 1, kMostCases)};
}

}  // namespace

namespace {

void WriteContent(JsonWriter& json, const SubjectPart& part) {
  json.Key("rasterproof_part").Integer(kPartVersion);
  json.Key("tool_version").Text(part.tool_version);
  json.Key("environment").BeginArray();
  for (const auto& [name, value] : part.environment) json.Text(name).Text(value);
  json.EndArray();
  json.Key("subject").Text(part.subject);
  json.Key("stated").Text(part.stated);
  json.Key("options").Text(part.options);
  json.Key("worlds").BeginArray();
  for (const std::string& world : part.worlds) json.Text(world);
  json.EndArray();
  json.Key("seed").Text(std::to_string(part.seed));
  json.Key("first").Integer(part.range.first);
  json.Key("end").Integer(part.range.end);
  if (part.shard) {
    json.Key("shard").Integer(part.shard->number);
    json.Key("shards").Integer(part.shard->count);
  }
  if (part.cases) json.Key("cases").Integer(*part.cases);
  json.Key("tests").BeginArray();
  for (const PropertyResult& test : part.tests) WriteTest(json, test);
  json.EndArray();
}

}  // namespace

std::string DigestOf(const SubjectPart& part) {
  JsonWriter json;
  json.BeginObject();
  WriteContent(json, part);
  json.EndObject();
  return HashText(json.Finish());
}

std::string PartToJson(const SubjectPart& part) {
  JsonWriter json;
  json.BeginObject();
  WriteContent(json, part);
  json.Key("digest").Text(DigestOf(part));
  json.EndObject();
  return json.Finish();
}

SubjectPart ReadPart(const std::string& path) {
  const io::JsonDocument document(io::ReadFile(path), path);
  const JsonValue root = document.root();
  RequirePart(root);
  SubjectPart part;
  part.file = path;
  part.tool_version = TextOf(root.Get("tool_version"));
  std::optional<std::string> name;
  for (const JsonValue word : root.Get("environment").RequireArray()) {
    if (name) {
      part.environment[*std::exchange(name, std::nullopt)] = TextOf(word);
    } else {
      name = TextOf(word);
    }
  }
  if (name) throw root.Get("environment").Error("its last name has no value", "run the part again");
  part.subject = TextOf(root.Get("subject"));
  part.stated = TextOf(root.Get("stated"));
  part.options = TextOf(root.Get("options"));
  for (const JsonValue world : root.Get("worlds").RequireArray()) {
    part.worlds.push_back(TextOf(world));
  }
  part.seed = SeedOf(root.Get("seed"));
  ReadRange(root, part);
  for (const JsonValue test : root.Get("tests").RequireArray()) part.tests.push_back(TestOf(test));
  part.digest = TextOf(root.Get("digest"));
  return part;
}

}  // namespace rasterproof::tool
