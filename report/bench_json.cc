#include "report/bench_json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/quoted.h"
#include "core/scene.h"
#include "io/json_document.h"
#include "io/json_members.h"
#include "io/json_writer.h"
#include "io/output.h"
#include "io/scene_file.h"
#include "io/scene_json.h"
#include "report/bench_decision.h"
#include "report/bench_members.h"
#include "report/claims.h"

namespace rasterproof::report {
namespace {

using io::JsonValue;

constexpr int kVersion = 3;

constexpr std::array<std::pair<BenchClock, std::string_view>, 3> kClocks{
    {{BenchClock::kThread, "processor"},
     {BenchClock::kProgram, "program"},
     {BenchClock::kWall, "elapsed"}}};

template <class T>
concept HasItems = requires(T& value) { ItemsOf(value); };

template <class T>
constexpr bool kIsOnOneLine =
    std::same_as<T, BenchRow> || std::same_as<T, BenchErrors> || std::same_as<T, BenchLeftOut> ||
    std::same_as<T, BenchCurve> || std::same_as<T, BenchCliff> || std::same_as<T, ValueBenchRow> ||
    std::same_as<T, ValueBenchLimit>;

// Visits the members of an object and writes them.
class BenchWriter {
 public:
  BenchWriter(io::JsonWriter& json, const BenchResult& result) : json_(json), result_(result) {}

  template <class T>
  void operator()(std::string_view key, T&& value) {
    json_.Key(key);
    Write(value);
  }
  template <class T>
  void operator()(std::string_view key, std::optional<T>& value) {
    if (value) (*this)(key, *value);
  }
  template <class T>
  void operator()(std::string_view key, std::vector<T>& list) {
    Each(key, list, [](T& item) -> T& { return item; });
  }
  void Each(std::string_view key, auto& list, auto as) {
    json_.Key(key).BeginArray();
    for (auto& item : list) Write(as(item));
    json_.EndArray();
  }
  void Index(std::string_view key, std::uint32_t index, auto list, std::string_view) {
    json_.Key(key).Text((result_.*list)[index].name);
  }
  void Method(std::uint32_t index) {
    const BenchMethod& method = result_.methods[index];
    json_.Key("method").Text(method.name);
    json_.Key("target").Text(method.target);
    json_.Key("sink").Text(method.sink);
  }
  bool Has(std::string_view, bool is_there) const { return is_there; }
  void Version(std::string_view key) { json_.Key(key).Integer(kVersion); }
  void Decisions(std::string_view key);
  void Claims(std::string_view key);
  const BenchResult& result() const { return result_; }

  template <class T>
  void Write(T& object) {
    kIsOnOneLine<T> ? json_.BeginObjectLine() : json_.BeginObject();
    Members(*this, object);
    json_.EndObject();
  }

 private:
  void Write(HasItems auto& value) { Write(ItemsOf(value)); }
  template <class... Item>
  void Write(std::tuple<Item...> items) {
    json_.BeginArrayLine();
    std::apply([&](auto&... item) { (Write(item), ...); }, items);
    json_.EndArray();
  }
  void Write(std::string& text) { json_.Text(text); }
  void Write(bool value) { json_.Bool(value); }
  void Write(int pixel) { json_.Integer(pixel); }
  void Write(std::uint64_t count) { json_.Integer(count); }
  void Write(double number) { json_.Shortest(number); }
  void Write(Rounded rounded) { json_.Rounded(rounded.number); }
  void Write(Exact exact) { json_.Exact(exact.number); }
  void Write(AsText text) { json_.Text(std::to_string(text.number)); }
  void Write(TargetSide side) { json_.Integer(side.pixels); }
  void Write(BenchClock clock) { json_.Text(io::NameOf<BenchClock>(clock, kClocks)); }
  void Write(Scene& scene) {
    std::string text = io::SceneToJson(scene);
    std::erase(text, '\n');
    json_.Value(text);
  }
  void WriteDecision(std::uint32_t family, Need need);

  io::JsonWriter& json_;
  const BenchResult& result_;
};

void BenchWriter::WriteDecision(std::uint32_t family, Need need) {
  const std::optional<Decision> decision = Decide(result_, family, need);
  if (!decision) return;
  json_.BeginObjectLine();
  json_.Key("family").Text(result_.families[family].name);
  json_.Key("need").Text(NeedName(need));
  Method(decision->row->method);
  json_.Key("nanoseconds_a_triangle").Rounded(NanosecondsATriangle(result_, *decision->row));
  json_.Key("ratio_to_fastest").Rounded(decision->ratio);
  json_.Key("tied_with_fastest").Bool(decision->is_tied_with_fastest);
  json_.Key("tied").BeginArrayLine();
  for (const BenchRow* row : decision->tied) json_.Text(FullName(result_.methods[row->method]));
  json_.EndArray();
  json_.EndObject();
}

// Conclusions from the rows, for programs to read. The reader ignores them: they follow again.
void BenchWriter::Decisions(std::string_view key) {
  json_.Key(key).BeginArray();
  for (std::uint32_t family = 0; family < result_.families.size(); ++family) {
    for (const Need need : kNeeds) WriteDecision(family, need);
  }
  json_.EndArray();
}

void BenchWriter::Claims(std::string_view key) {
  json_.Key(key).BeginArray();
  for (const Claim& claim : report::Claims()) {
    const ClaimFigure figure = FigureOf(claim, result_);
    json_.BeginObject();
    json_.Key("id").Text(claim.id);
    json_.Key("about").Text(claim.about);
    json_.Key("differ_in").Text(DifferenceText(claim));
    json_.Key("like_for_like").Bool(claim.differs.has_value());
    json_.Key("sink").Text(claim.a.sink);
    json_.Key("a").Text(figure.a);
    json_.Key("b").Text(figure.b);
    json_.Key("times").Text(figure.times);
    json_.Key("a_wrong").Text(figure.a_wrong);
    json_.Key("b_wrong").Text(figure.b_wrong);
    json_.Key("sentence").Text(figure.sentence);
    json_.Key("families").BeginArray();
    for (const ClaimCell& cell : figure.cells) {
      json_.BeginObjectLine();
      json_.Key("family").Text(result_.families[cell.family].name);
      if (cell.ratio) {
        Interval ratio = *cell.ratio;
        json_.Key("ratio");
        Write(ratio);
      }
      json_.Key("overlap").Bool(cell.Overlaps());
      json_.EndObject();
    }
    json_.EndArray();
    json_.EndObject();
  }
  json_.EndArray();
}

// Visits the members of an object and reads them. Without an object it lists their keys instead,
// those included that may be missing.
class BenchReader {
 public:
  BenchReader(std::optional<JsonValue> object, BenchResult& result)
      : object_(object), result_(result) {}

  template <class T>
  void operator()(std::string_view key, T&& value) {
    if (const auto found = Get(key)) Read(*found, value);
  }
  template <class T>
  void operator()(std::string_view key, std::optional<T>& value) {
    if (!object_ || object_->Find(key)) (*this)(key, value.emplace());
  }
  template <class T>
  void operator()(std::string_view key, std::vector<T>& list) {
    Each(key, list, [](T& item) -> T& { return item; });
  }
  void Each(std::string_view key, auto& list, auto as) {
    const auto found = Get(key);
    if (!found) return;
    for (const JsonValue item : found->RequireArray()) Read(item, as(list.emplace_back()));
  }
  void Index(std::string_view key, std::uint32_t& index, auto list, std::string_view what);
  void Method(std::uint32_t& index);
  bool Has(std::string_view key, bool& is_there) const {
    return is_there = !object_ || object_->Find(key);
  }
  void Version(std::string_view key) { Get(key); }
  void Decisions(std::string_view key) {
    if (!object_) Get(key);
  }
  void Claims(std::string_view key) { Decisions(key); }
  const BenchResult& result() const { return result_; }

  template <class T>
  void Read(const JsonValue& value, T& object) {
    static const std::vector<std::string_view> keys = KeysOf<T>();
    value.RequireObject(keys);
    BenchReader visit(value, result_);
    Members(visit, object);
  }

 private:
  template <class T>
  static std::vector<std::string_view> KeysOf() {
    BenchResult one_of_each;
    one_of_each.methods.resize(1);
    one_of_each.parameters.resize(1);
    one_of_each.value_families.resize(1);
    BenchReader visit(std::nullopt, one_of_each);
    T object;
    Members(visit, object);
    return visit.keys_;
  }
  std::optional<JsonValue> Get(std::string_view key) {
    if (object_) return object_->Get(key);
    keys_.push_back(key);
    return std::nullopt;
  }

  void Read(const JsonValue& value, HasItems auto& object) { Read(value, ItemsOf(object)); }
  template <class... Item>
  void Read(const JsonValue& value, std::tuple<Item...> items) {
    const auto all = value.RequireArray();
    if (all.size() != sizeof...(Item)) {
      throw value.Error("has " + std::to_string(all.size()) + " items",
                        "write " + std::to_string(sizeof...(Item)) + " of them");
    }
    auto next = all.begin();
    std::apply([&](auto&... item) { ((Read(*next, item), ++next), ...); }, items);
  }
  // Methods are compared by their intervals: one that is apart from itself would beat itself.
  void Read(const JsonValue& value, Interval& interval) {
    Read(value, ItemsOf(interval));
    if (interval.low > interval.median || interval.median > interval.high) {
      throw value.Error("is no interval", "write the lower end, the median, the upper end");
    }
  }
  void Read(const JsonValue& value, std::string& text) { text = value.RequireString(); }
  void Read(const JsonValue& value, bool& is) { is = io::Boolean(value); }
  void Read(const JsonValue& value, int& pixel) {
    pixel = io::Integer(value, INT32_MIN, INT32_MAX);
  }
  void Read(const JsonValue& value, std::uint64_t& count) {
    count = static_cast<std::uint64_t>(value.RequireInteger(0, INT64_MAX));
  }
  void Read(const JsonValue& value, double& number) {
    number = io::CoordinateFromJson(value, Precision::kFloat64);
  }
  void Read(const JsonValue& value, Rounded rounded) { Read(value, rounded.number); }
  void Read(const JsonValue& value, Exact exact) { Read(value, exact.number); }
  void Read(const JsonValue& value, AsText text);
  void Read(const JsonValue& value, TargetSide side) {
    side.pixels = io::Integer(value, 1, kMaxTargetSide);
  }
  void Read(const JsonValue& value, BenchClock& clock) {
    clock = io::FromName<BenchClock>(value, kClocks);
  }
  void Read(const JsonValue& value, Scene& scene) { scene = io::SceneFromJson(value); }

  std::optional<JsonValue> object_;
  BenchResult& result_;
  std::vector<std::string_view> keys_;
};

void BenchReader::Index(std::string_view key, std::uint32_t& index, auto list,
                        std::string_view what) {
  const auto name = Get(key);
  if (!name) return;
  const std::string_view text = name->RequireString();
  const auto& named = result_.*list;
  const auto found = std::ranges::find_if(named, [&](const auto& one) { return one.name == text; });
  if (found == named.end()) {
    throw name->Error(Quoted(text) + " is no " + std::string(what) + " of this file",
                      "write the name of one that it lists");
  }
  index = static_cast<std::uint32_t>(found - named.begin());
}

void BenchReader::Method(std::uint32_t& index) {
  BenchMethod named;
  (*this)("method", named.name);
  (*this)("target", named.target);
  (*this)("sink", named.sink);
  if (!object_) return;
  const auto found = std::ranges::find_if(result_.methods, [&](const BenchMethod& method) {
    return method.name == named.name && method.target == named.target && method.sink == named.sink;
  });
  if (found == result_.methods.end()) {
    throw object_->Get("method").Error(
        Quoted(named.name) + " by " + Quoted(named.target) + " into " + Quoted(named.sink) +
            " is not a method of this file",
        "write \"method\", \"target\" and \"sink\" of one that it lists");
  }
  index = static_cast<std::uint32_t>(found - result_.methods.begin());
}

void BenchReader::Read(const JsonValue& value, AsText text) {
  const std::string_view digits = value.RequireString();
  const char* const past = digits.data() + digits.size();
  const auto [end, fault] = std::from_chars(digits.data(), past, text.number);
  if (fault == std::errc() && end == past) return;
  throw value.Error(Quoted(digits) + " is no seed", "write an integer below 2^64 as a string");
}

void RequireVersion(const JsonValue& root) {
  if (root.kind() == io::JsonKind::kObject && !root.Find("rasterproof_bench")) {
    throw root.Error("is not a bench file: the key \"rasterproof_bench\" is missing",
                     "give a file that rasterproof bench --json wrote");
  }
  const JsonValue version = root.Get("rasterproof_bench");
  if (version.RequireInteger(0, INT32_MAX) != kVersion) {
    throw version.Error(
        "version " + std::string(version.text()) + " is unknown",
        "this program reads version 3: measure again with rasterproof bench --json");
  }
}

}  // namespace

std::string BenchToJson(const BenchResult& result) {
  io::JsonWriter json;
  BenchResult visited = result;  // as readers set what they visit
  BenchWriter(json, result).Write(visited);
  std::string text = json.Finish();
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos; ++at) {
    text.replace(at, 1, "\\u003c");
  }
  return text;
}

BenchResult ParseBench(std::string_view text, const std::string& place) {
  const io::JsonDocument document(text, place);
  // Keys differ from version to version, so that the version is asked for first.
  RequireVersion(document.root());
  BenchResult result;
  BenchReader(document.root(), result).Read(document.root(), result);
  return result;
}

BenchResult ReadBench(const std::string& path) {
  return ParseBench(io::ReadFile(path), path == "-" ? "standard input" : path);
}

BenchResult AsRecorded(const BenchResult& result) {
  return ParseBench(BenchToJson(result), "the record of this run");
}

}  // namespace rasterproof::report
