// Requests: written on this side, read on the other.
#include <algorithm>
#include <array>
#include <cstring>
#include <istream>
#include <limits>
#include <streambuf>
#include <utility>

#include "core/call_end.h"
#include "core/error.h"
#include "core/target_size.h"
#include "subjects/process/channels.h"
#include "subjects/process/npy.h"
#include "subjects/process/protocol.h"
#include "subjects/process/request_errors.h"
#include "subjects/process/text.h"

namespace rasterproof::subjects {
namespace {

constexpr std::size_t kMostListed = std::size_t{1} << 26;
constexpr int kMostSteps = 1 << 20;
constexpr int kMostRepeats = 1 << 20;
constexpr std::size_t kMostInABatch = std::size_t{1} << 16;
constexpr std::string_view kSame = "same";
constexpr std::string_view kAsArrays = "npy";

static_assert(sizeof(Vertex) == 4 * sizeof(double), "its bytes are its numbers'");

// Bit for bit: -0 is not 0, and a NaN is the same NaN.
bool HaveTheSameVertices(const Scene& a, const Scene& b) {
  if (&a == &b) return true;
  const std::size_t bytes = a.vertices.size() * sizeof(Vertex);
  return a.vertices.size() == b.vertices.size() &&
         (bytes == 0 || std::memcmp(a.vertices.data(), b.vertices.data(), bytes) == 0);
}

// The outputs that a job wants, as words of the line; nothing if it wants all that are shown.
std::string WantsText(Outputs wants, CoverageKind kind) {
  const Outputs answered = Answered(kind, wants);
  if (answered == Answered(kind, kEverything)) return "";
  if (!answered.primitive_ids) return " wants=coverage";
  std::string text = " wants=primitive-ids";
  if (answered.barycentrics) text += ",barycentrics";
  if (answered.depths) text += ",depths";
  if (answered.centroids) text += ",centroids";
  if (answered.values) text += ",values";
  if (answered.derivatives) text += ",derivatives";
  return text;
}

void AddOptions(TextWriter& text, const DrawOptions& options, const SubjectInfo& info) {
  if (options.cull != Cull::kNone) {
    text.Add(options.cull == Cull::kFront ? " cull=front" : " cull=back");
  }
  if (options.scissor) {
    const PixelRect& r = *options.scissor;
    char before = '=';
    text.Add(" scissor");
    for (const int side : {r.x0, r.y0, r.x1, r.y1}) {
      text.Add(std::exchange(before, ','));
      text.AddNumber(side);
    }
  }
  if (options.tile != 0 && info.takes_tiles) {
    text.Add(" tile=");
    text.AddNumber(options.tile);
  }
  if (options.threads > 1 && info.takes_threads) {
    text.Add(" threads=");
    text.AddNumber(options.threads);
  }
  if (options.float_mode != FloatMode::kUsual) {
    text.Add(" float=");
    text.Add(FloatModeName(options.float_mode));
  }
}

// Numbers separated by blanks, ending with a newline.
template <class Numbers>
void AddLine(TextWriter& text, const Numbers& numbers) {
  bool is_first = true;
  for (const auto x : numbers) {
    if (!std::exchange(is_first, false)) text.Add(' ');
    text.AddNumber(x);
  }
  text.Add('\n');
}

void AddVertices(TextWriter& text, const std::vector<Vertex>& vertices, bool as_array) {
  if (!as_array) {
    for (const Vertex& v : vertices) AddLine(text, std::array{v.x, v.y, v.z, v.w});
    return;
  }
  std::vector<double> numbers(4 * vertices.size());
  if (!vertices.empty())
    std::memcpy(numbers.data(), vertices.data(), numbers.size() * sizeof(double));
  text.Add(NpyOf(numbers, 4));
}

void AddTriangles(TextWriter& text, std::span<const Triangle> triangles, bool as_array) {
  if (!as_array) {
    for (const Triangle& t : triangles) AddLine(text, t);
    return;
  }
  std::vector<std::int32_t> numbers;
  numbers.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) numbers.insert(numbers.end(), t.begin(), t.end());
  text.Add(NpyOf(numbers, 3));
}

// What of a scene the request before has sent already.
struct Sent {
  bool vertices = false;
  bool channels = false;
};

void AddRequest(TextWriter& text, std::uint64_t id, const DrawJob& job, const SubjectInfo& info,
                Sent sent) {
  const Scene& scene = *job.scene;
  text.Add("draw ");
  text.AddNumber(id);
  for (const int n : {scene.width, scene.height, job.samples}) {
    text.Add(' ');
    text.AddNumber(n);
  }
  text.Add(scene.clip_space ? " clip " : " window ");
  if (sent.vertices) {
    text.Add(kSame);
  } else {
    text.AddNumber(scene.vertices.size());
  }
  text.Add(' ');
  text.AddNumber(job.Triangles().size());
  AddOptions(text, job.options, info);
  const Outputs requested = Requested(job, info);
  if (info.takes_wants) text.Add(WantsText(requested, info.coverage));
  if (requested.values) {
    text.Add(" channels=");
    text.Add(sent.channels ? kSame : std::to_string(scene.channels.size()));
  }
  if (job.repeats > 1 && info.takes_repeats) {
    text.Add(" repeats=");
    text.AddNumber(job.repeats);
  }
  if (info.takes_npy) {
    text.Add(' ');
    text.Add(kAsArrays);
  }
  text.Add('\n');
  if (!sent.vertices) AddVertices(text, scene.vertices, info.takes_npy);
  if (requested.values && !sent.channels) AddChannels(text, scene.channels, info.takes_npy);
  AddTriangles(text, job.Triangles(), info.takes_npy);
}

// The next word as a number.
template <class T>
T Number(WordReader& words, const std::string& where) {
  T value{};
  if (!words.Number(value)) Malformed(where, "a number, not " + std::string(words.Word()));
  return value;
}

template <class T>
T Number(std::string_view word, const std::string& where) {
  WordReader words(word);
  T value = Number<T>(words, where);
  if (!words.AtEnd()) Malformed(where, "a number, not " + std::string(word));
  return value;
}

// A line of exactly this many numbers. The place is composed only for errors: there are many lines.
template <class T, std::size_t n>
std::array<T, n> NumbersOf(const std::string& line, const char* what, std::size_t index,
                           std::uint64_t id) {
  WordReader words(line);
  std::array<T, n> numbers{};
  bool fits = true;
  for (T& number : numbers) fits = fits && words.Number(number);
  if (fits && words.AtEnd()) return numbers;
  const std::string where =
      "request " + std::to_string(id) + ", " + what + " " + std::to_string(index);
  const std::string word(words.Word());
  if (fits || word.empty()) Malformed(where, std::to_string(n) + " numbers");
  Malformed(where, "a number, not " + word);
}

PixelRect ParseRect(std::string_view text, const std::string& where) {
  std::array<int, 4> sides{};
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (k + 1 == sides.size())) {
      Malformed(where, "scissor=X0,Y0,X1,Y1");
    }
    sides[k] = Number<int>(text.substr(0, comma), where);
    text.remove_prefix(std::min(comma, text.size() - 1) + 1);
  }
  return {sides[0], sides[1], sides[2], sides[3]};
}

using NamedOutput = std::pair<std::string_view, bool Outputs::*>;
constexpr std::array<NamedOutput, 6> kOutputs{{{"primitive-ids", &Outputs::primitive_ids},
                                               {"barycentrics", &Outputs::barycentrics},
                                               {"depths", &Outputs::depths},
                                               {"centroids", &Outputs::centroids},
                                               {"values", &Outputs::values},
                                               {"derivatives", &Outputs::derivatives}}};

Outputs ParseWants(std::string_view text, const std::string& where) {
  Outputs wants = kCoverageAlone;
  if (text == "coverage") return wants;
  while (!text.empty()) {
    const std::string_view name = text.substr(0, text.find(','));
    const auto* const named = std::ranges::find(kOutputs, name, &NamedOutput::first);
    if (named == kOutputs.end()) {
      Malformed(where,
                "wants=coverage, or any of "
                "primitive-ids,barycentrics,depths,centroids,values,derivatives");
    }
    wants.primitive_ids = true;
    wants.*named->second = true;
    text.remove_prefix(std::min(name.size() + 1, text.size()));
  }
  return wants;
}

void ParseOption(std::string_view word, const std::string& where, DrawJob& job) {
  const std::size_t equals = word.find('=');
  const std::string_view key = word.substr(0, equals);
  const std::string_view value =
      equals == std::string_view::npos ? std::string_view() : word.substr(equals + 1);
  DrawOptions& options = job.options;
  if (key == "cull" && (value == "front" || value == "back")) {
    options.cull = value == "front" ? Cull::kFront : Cull::kBack;
  } else if (key == "scissor") {
    options.scissor = ParseRect(value, where);
  } else if (key == "tile") {
    options.tile = Number<int>(value, where);
  } else if (key == "threads") {
    options.threads = Number<int>(value, where);
  } else if (key == "float" && FindFloatMode(value)) {
    options.float_mode = *FindFloatMode(value);
  } else if (key == "wants" && !value.empty()) {
    job.wants = ParseWants(value, where);
  } else if (key == "repeats") {
    job.repeats = Number<int>(value, where);
    if (job.repeats < 1 || job.repeats > kMostRepeats) Malformed(where, "1 to 2^20 repeats");
  } else {
    Malformed(where, "cull=, scissor=, tile=, threads=, float=, wants= or repeats=, not " +
                         std::string(word));
  }
}

}  // namespace

std::string RequestsText(std::uint64_t first_id, std::span<const DrawJob> jobs,
                         const SubjectInfo& info) {
  TextWriter text;
  const Scene* before = nullptr;
  const Scene* channels = nullptr;  // whose were sent last, beside these vertices
  for (const DrawJob& job : jobs) {
    Sent sent;
    sent.vertices =
        info.takes_same && before != nullptr && HaveTheSameVertices(*before, *job.scene);
    if (!sent.vertices) channels = nullptr;
    sent.channels = channels != nullptr && HaveTheSameChannels(*channels, *job.scene);
    AddRequest(text, first_id++, job, info, sent);
    before = job.scene.get();
    if (Requested(job, info).values) channels = before;
  }
  return text.Take();
}

std::string BatchText(std::size_t n) { return "batch " + std::to_string(n) + "\n"; }

std::string RequestsText(std::span<const EdgeRequest> requests) {
  TextWriter text;
  for (const EdgeRequest& request : requests) {
    text.Add(request.step ? "steps " : "edge ");
    text.AddNumber(request.id);
    for (const Point2& at : {request.a, request.b, request.p}) {
      for (const double x : {at.x, at.y}) {
        text.Add(' ');
        text.AddNumber(x);
      }
    }
    if (const std::optional<Step>& step = request.step) {
      text.Add(step->along_y ? " y " : " x ");
      text.Add(step->sign < 0 ? "-1 " : "+1 ");
      AddLine(text, std::array{step->length, request.steps});
    } else {
      text.Add('\n');
    }
  }
  return text.Take();
}

// Whether there is a line that has any words; it is then line_.
bool RequestReader::Peek() {
  while (!has_line_) {
    if (!std::getline(in_, line_)) return false;
    has_line_ = !WordReader(line_).AtEnd();
  }
  return true;
}

// As Peek(), and the line is read.
bool RequestReader::NextLine() {
  const bool has_line = Peek();
  has_line_ = false;
  return has_line;
}

std::vector<DrawRequest> RequestReader::NextCall() {
  std::vector<DrawRequest> requests;
  if (!Peek()) return requests;
  std::size_t n = 1;
  WordReader words(line_);
  if (words.Word() == "batch") {
    const std::string where = "batch line";
    n = Number<std::size_t>(words, where);
    if (!words.AtEnd()) Malformed(where, "batch N");
    if (n < 1 || n > kMostInABatch) Malformed(where, "1 to 2^16 requests");
    has_line_ = false;
  }
  while (requests.size() < n) requests.push_back(NextRequest());
  return requests;
}

DrawRequest RequestReader::NextRequest() {
  const std::string where = "draw line";
  const auto wrong = [&] {
    Malformed(where, "draw ID WIDTH HEIGHT SAMPLES window|clip VERTICES TRIANGLES");
  };
  if (!NextLine()) wrong();
  WordReader words(line_);
  if (words.Word() != "draw") wrong();
  DrawRequest request;
  Scene target;
  request.id = Number<std::uint64_t>(words, where);
  target.width = Number<int>(words, where);
  target.height = Number<int>(words, where);
  request.job.samples = Number<int>(words, where);
  const std::string_view space = words.Word();
  if (space != "window" && space != "clip") wrong();
  target.clip_space = space == "clip";
  target.precision = Precision::kFloat64;  // what it holds; a program narrows what it must
  const std::string_view vertices = words.Word();
  Lists lists{request.id};
  if (vertices != kSame) lists.vertices = Number<std::size_t>(vertices, where);
  const auto triangles = Number<std::size_t>(words, where);
  if (lists.vertices.value_or(0) > kMostListed || triangles > kMostListed) {
    Malformed(where, "at most 2^26 vertices and triangles");
  }
  ReadOptions(words, where, request.job, lists);
  RequireTargetSize("standard input: " + where, target.width, target.height, request.job.samples);
  last_ = SceneFor(std::move(target), lists);
  request.job.scene = last_;
  request.job.triangles = NextTriangles(triangles, lists);
  return request;
}

void RequestReader::ReadOptions(WordReader& words, const std::string& where, DrawJob& job,
                                Lists& lists) {
  constexpr std::string_view kChannels = "channels=";
  bool has_channels = false;
  while (!words.AtEnd()) {
    const std::string_view word = words.Word();
    if (word == kAsArrays) {
      lists.as_arrays = true;
    } else if (word.starts_with(kChannels)) {
      const std::string_view count = word.substr(kChannels.size());
      has_channels = true;
      lists.channels =
          count == kSame ? std::nullopt : std::optional(Number<std::size_t>(count, where));
      if (lists.channels && (*lists.channels < 1 || *lists.channels > kMostChannels))
        Malformed(where, "1 to " + std::to_string(kMostChannels) + " channels");
    } else {
      ParseOption(word, where, job);
    }
  }
  if (job.wants.values != has_channels || (job.wants.derivatives && !job.wants.values))
    Malformed(where, "channels=N and values among wants=..., or neither of them");
}

// The next bytes of the stream, read piece by piece: a head may say more than follows.
std::string_view RequestReader::NextBytesOf(std::size_t count) {
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  bytes_.clear();
  while (bytes_.size() < count) {
    const std::size_t begin = bytes_.size();
    const std::size_t size = std::min(kPiece, count - begin);
    bytes_.resize(begin + size);
    in_.read(bytes_.data() + begin, static_cast<std::streamsize>(size));
    if (static_cast<std::size_t>(in_.gcount()) == size) continue;
    throw InputError("standard input", "it ends within an array",
                     "give as many bytes as the array's head says");
  }
  return bytes_;
}

std::vector<Vertex> RequestReader::NextVertices(std::size_t count, const Lists& lists) {
  std::vector<Vertex> vertices;
  if (lists.as_arrays) {
    const std::vector<double> numbers = OfArray(lists.id, "vertices", [&] {
      return ReadNpyDoubles(count, 4, [&](std::size_t n) { return NextBytesOf(n); });
    });
    vertices.reserve(count);
    for (std::size_t n = 0; n < numbers.size(); n += 4)
      vertices.push_back({numbers[n], numbers[n + 1], numbers[n + 2], numbers[n + 3]});
    return vertices;
  }
  for (std::size_t n = 0; n < count; ++n) {
    if (!std::getline(in_, line_)) line_.clear();
    const auto [x, y, z, w] = NumbersOf<double, 4>(line_, "vertex", n, lists.id);
    vertices.push_back({x, y, z, w});
  }
  return vertices;
}

std::vector<Triangle> RequestReader::NextTriangles(std::size_t count, const Lists& lists) {
  const std::size_t vertices = last_->vertices.size();
  std::vector<std::int64_t> numbers;
  if (lists.as_arrays) {
    const std::vector<std::vector<std::size_t>> shapes{{count, 3}};
    numbers = OfArray(lists.id, "triangles", [&] {
      return ReadNpyIntegers(shapes, [&](std::size_t n) { return NextBytesOf(n); });
    });
  }
  std::vector<Triangle> triangles;
  for (std::size_t n = 0; n < count; ++n) {
    Triangle& triangle = triangles.emplace_back();
    if (lists.as_arrays) {
      for (std::size_t k = 0; k < 3; ++k)
        triangle[k] = static_cast<std::int32_t>(std::clamp<std::int64_t>(
            numbers[3 * n + k], -1, std::numeric_limits<std::int32_t>::max()));
    } else {
      if (!std::getline(in_, line_)) line_.clear();
      triangle = NumbersOf<std::int32_t, 3>(line_, "triangle", n, lists.id);
    }
    for (const std::int32_t index : triangle) {
      if (index >= 0 && static_cast<std::size_t>(index) < vertices) continue;
      Malformed("request " + std::to_string(lists.id) + ", triangle " + std::to_string(n),
                "indices of its " + std::to_string(vertices) + " vertices");
    }
  }
  return triangles;
}

bool RequestReader::HasMore() {
  std::streambuf& at_hand = *in_.rdbuf();
  constexpr std::string_view kBlank = " \t\r\n";
  const auto is_blank = [&] {
    return at_hand.in_avail() > 0 &&
           kBlank.find(static_cast<char>(at_hand.sgetc())) != std::string_view::npos;
  };
  while (!has_line_ && is_blank()) at_hand.sbumpc();
  return has_line_ || at_hand.in_avail() > 0;
}

std::optional<EdgeRequest> RequestReader::NextEdgeRequest() {
  if (!Peek()) return std::nullopt;
  WordReader words(line_);
  const std::string_view word = words.Word();
  const bool steps = word == "steps";
  if (!steps && word != "edge") return std::nullopt;
  has_line_ = false;
  const std::string where = "edge or steps line";
  EdgeRequest request;
  request.id = Number<std::uint64_t>(words, where);
  for (Point2* const at : {&request.a, &request.b, &request.p}) {
    at->x = Number<double>(words, where);
    at->y = Number<double>(words, where);
  }
  if (steps) {
    const std::string_view axis = words.Word();
    const std::string_view sign = words.Word();
    if ((axis != "x" && axis != "y") || (sign != "+1" && sign != "-1")) {
      Malformed(where, "a stepping along x or y, by +1 or -1");
    }
    request.step = Step{axis == "y", sign == "-1" ? -1 : +1, Number<int>(words, where)};
    request.steps = Number<int>(words, where);
    if (request.steps < 0 || request.steps > kMostSteps || request.step->length < 1) {
      Malformed(where, "a length of 1 or more, and 0 to 2^20 steps");
    }
  }
  if (!words.AtEnd()) {
    Malformed(where, "edge ID AX AY BX BY PX PY, or steps followed by x|y +1|-1 LENGTH STEPS");
  }
  return request;
}

}  // namespace rasterproof::subjects
