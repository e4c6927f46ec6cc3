#include "subjects/process/protocol.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <istream>
#include <memory>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "core/target_size.h"

namespace rasterproof::subjects {
namespace {

constexpr std::size_t kMostListed = std::size_t{1} << 26;
constexpr int kMostSteps = 1 << 20;
constexpr std::size_t kMostInABatch = std::size_t{1} << 16;

// Of the lines of a right answer. A double has 24 characters at most ("-2.2250738585072014e-308"),
// a count 10; the rest is for blanks and for programs that pad.
constexpr std::size_t kMostOfANumber = 64;
constexpr std::size_t kMostOfAHead = std::size_t{1} << 16;  // a reason may be a long text
constexpr std::size_t kNumbersOfAFragment = 5;              // the winner, its weights, its depth

constexpr std::size_t MostOfARow(std::size_t numbers) { return (numbers + 1) * kMostOfANumber; }

void AppendNumber(std::string& text, double x) {
  if (std::isnan(x)) {
    text += "nan";
    return;
  }
  if (std::isinf(x)) {
    text += x < 0 ? "-inf" : "inf";
    return;
  }
  std::array<char, 40> digits{};
  const int length = std::snprintf(digits.data(), digits.size(), "%.17g", x);
  text.append(digits.data(), static_cast<std::size_t>(length));
}

void AppendInteger(std::string& text, std::int64_t x) {
  std::array<char, 24> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr;
  text.append(digits.data(), end);
}

[[noreturn]] void Malformed(const std::string& where, const std::string& expected) {
  throw InputError("standard input: " + where, "not what a request looks like", "give " + expected);
}

// One word of a request line, converted whole.
template <class T>
T Number(const std::string& word, const std::string& where) {
  T value{};
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc{} || stop != end || word.empty())
    Malformed(where, "a number, not " + word);
  return value;
}

std::vector<std::string> Words(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

std::vector<std::string> RequireWords(std::istream& in, std::size_t n, const std::string& where) {
  std::string line;
  if (!std::getline(in, line)) Malformed(where, "as many lines as were announced");
  std::vector<std::string> words = Words(line);
  if (words.size() != n) Malformed(where, std::to_string(n) + " numbers");
  return words;
}

PixelRect ParseRect(const std::string& text, const std::string& where) {
  std::array<int, 4> sides{};
  std::istringstream in(text);
  for (int& side : sides) {
    std::string word;
    std::getline(in, word, ',');
    side = Number<int>(word, where);
  }
  return {sides[0], sides[1], sides[2], sides[3]};
}

void ParseOption(const std::string& word, const std::string& where, DrawOptions& options) {
  const std::size_t equals = word.find('=');
  const std::string key = word.substr(0, equals);
  const std::string value = equals == std::string::npos ? "" : word.substr(equals + 1);
  if (key == "cull" && (value == "front" || value == "back")) {
    options.cull = value == "front" ? Cull::kFront : Cull::kBack;
  } else if (key == "scissor") {
    options.scissor = ParseRect(value, where);
  } else if (key == "tile") {
    options.tile = Number<int>(value, where);
  } else if (key == "threads") {
    options.threads = Number<int>(value, where);
  } else {
    Malformed(where, "cull=, scissor=, tile= or threads=, not " + word);
  }
}

struct Announced {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
};

Announced ParseDrawLine(const std::vector<std::string>& words, DrawRequest& request, Scene& scene) {
  const std::string where = "draw line";
  if (words.size() < 8 || words[0] != "draw" || (words[5] != "window" && words[5] != "clip")) {
    Malformed(where, "draw ID WIDTH HEIGHT SAMPLES window|clip VERTICES TRIANGLES");
  }
  request.id = Number<std::uint64_t>(words[1], where);
  scene.width = Number<int>(words[2], where);
  scene.height = Number<int>(words[3], where);
  request.job.samples = Number<int>(words[4], where);
  scene.clip_space = words[5] == "clip";
  scene.precision = Precision::kFloat64;  // what it holds; a program narrows what it must
  const Announced announced{Number<std::size_t>(words[6], where),
                            Number<std::size_t>(words[7], where)};
  if (announced.vertices > kMostListed || announced.triangles > kMostListed) {
    Malformed(where, "at most 2^26 vertices and triangles");
  }
  for (std::size_t k = 8; k < words.size(); ++k) ParseOption(words[k], where, request.job.options);
  RequireTargetSize("standard input: " + where, scene.width, scene.height, request.job.samples);
  return announced;
}

DrawRequest ReadRequest(std::istream& in, const std::vector<std::string>& draw_line) {
  DrawRequest request;
  Scene scene;
  const Announced announced = ParseDrawLine(draw_line, request, scene);
  const std::string where = "request " + std::to_string(request.id);
  for (std::size_t n = 0; n < announced.vertices; ++n) {
    const std::string place = where + ", vertex " + std::to_string(n);
    const std::vector<std::string> words = RequireWords(in, 4, place);
    scene.vertices.push_back({Number<double>(words[0], place), Number<double>(words[1], place),
                              Number<double>(words[2], place), Number<double>(words[3], place)});
  }
  for (std::size_t n = 0; n < announced.triangles; ++n) {
    const std::string place = where + ", triangle " + std::to_string(n);
    const std::vector<std::string> words = RequireWords(in, 3, place);
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      triangle[k] = Number<std::int32_t>(words[k], place);
      if (triangle[k] < 0 || static_cast<std::size_t>(triangle[k]) >= announced.vertices) {
        Malformed(place, "indices of vertices");
      }
    }
    scene.triangles.push_back(triangle);
  }
  request.job.scene = std::make_shared<const Scene>(std::move(scene));
  return request;
}

// The words of the next line that has any; none at the end of the stream.
std::vector<std::string> NextWords(std::istream& in) {
  std::vector<std::string> words;
  for (std::string line; words.empty() && std::getline(in, line);) words = Words(line);
  return words;
}

std::string_view AnswerWord(CoverageKind kind) {
  if (kind == CoverageKind::kWinners) return "ids";
  return kind == CoverageKind::kFragments ? "fragments" : "counts";
}

// What follows `WORD ID` on the line if it begins so.
std::optional<std::string> AfterHead(std::string_view line, std::string_view word,
                                     std::uint64_t id) {
  const std::string head = std::string(word) + " " + std::to_string(id);
  if (!line.starts_with(head)) return std::nullopt;
  line.remove_prefix(head.size());
  if (line.empty()) return "";
  if (line.front() != ' ' && line.front() != '\r') return std::nullopt;
  return std::string(line.substr(1));
}

// Returns what follows the head of an answer's first line.
std::string RequireHead(const std::string& line, std::string_view word, std::uint64_t id,
                        const std::string& subject) {
  if (const auto reason = AfterHead(line, "fault", id)) throw SubjectFault(*reason);
  if (const auto reason = AfterHead(line, "refused", id)) {
    throw SubjectRefusal("subject " + subject, "it refused the scene: " + *reason,
                         "give it another one");
  }
  if (std::optional<std::string> rest = AfterHead(line, word, id)) return *std::move(rest);
  throw SubjectFault("it answered \"" + line.substr(0, 60) + "\", not \"" + std::string(word) +
                     " " + std::to_string(id) +
                     "\" (was a line left over from an earlier answer?)");
}

// The numbers of one line of an answer, and where it goes wrong.
class RowReader {
 public:
  explicit RowReader(std::string line) : line_(std::move(line)), at_(line_.data()) {}

  template <class T>
  T Next(std::size_t read, std::size_t wanted) {
    SkipBlanks();
    T value{};
    const auto [stop, error] = std::from_chars(at_, End(), value);
    if (error != std::errc{} || (stop != End() && !IsBlank(*stop))) {
      throw SubjectFault("a row of its answer has " + std::to_string(read) + " samples, not " +
                         std::to_string(wanted) + ": \"" + line_.substr(0, 60) + "\"");
    }
    at_ = stop;
    return value;
  }
  void RequireEnd(std::size_t wanted) {
    SkipBlanks();
    if (at_ == End()) return;
    throw SubjectFault("a row of its answer has more than " + std::to_string(wanted) +
                       " samples: \"" + line_.substr(0, 60) + "\"");
  }

 private:
  static bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  const char* End() const { return line_.data() + line_.size(); }
  void SkipBlanks() {
    while (at_ != End() && IsBlank(*at_)) ++at_;
  }

  std::string line_;
  const char* at_;
};

// Reads HEIGHT rows; take(row, index, column, columns) reads one sample, of at most so many
// numbers, from the row.
template <class Take>
void ReadRows(const CoverageCounts& shape, std::size_t numbers, const NextLine& next_line,
              const Take& take) {
  const auto columns = shape.size() / static_cast<std::size_t>(shape.height);
  for (std::size_t at = 0; at < shape.size(); at += columns) {
    RowReader row(next_line(MostOfARow(columns * numbers)));
    for (std::size_t k = 0; k < columns; ++k) take(row, at + k, k, columns);
    row.RequireEnd(columns);
  }
}

void ReadCounts(Drawing& drawing, std::vector<std::uint32_t>& side, const NextLine& next_line) {
  ReadRows(drawing.counts, 1, next_line,
           [&](RowReader& row, std::size_t index, std::size_t column, std::size_t columns) {
             side[index] = row.Next<std::uint32_t>(column, columns);
           });
}

void RequireWinner(std::int32_t winner, std::size_t triangles) {
  if (winner >= kNoTriangle && winner < static_cast<std::int64_t>(triangles)) return;
  throw SubjectFault("it says that triangle " + std::to_string(winner) +
                     " won a sample, of a scene of " + std::to_string(triangles));
}

void ReadWinners(Drawing& drawing, std::size_t triangles, bool fragments,
                 const NextLine& next_line) {
  drawing.winners.resize(drawing.counts.size());
  if (fragments) {
    drawing.weights.resize(drawing.counts.size());
    drawing.depths.resize(drawing.counts.size());
  }
  ReadRows(drawing.counts, fragments ? kNumbersOfAFragment : 1, next_line,
           [&](RowReader& row, std::size_t index, std::size_t column, std::size_t columns) {
             const auto winner = row.Next<std::int32_t>(column, columns);
             RequireWinner(winner, triangles);
             drawing.winners[index] = winner;
             if (winner == kNoTriangle) return;
             drawing.counts.front[index] = 1;
             if (!fragments) return;
             for (double& weight : drawing.weights[index]) {
               weight = row.Next<double>(column, columns);
             }
             drawing.depths[index] = row.Next<double>(column, columns);
           });
}

}  // namespace

std::string RequestText(std::uint64_t id, const DrawJob& job) {
  const Scene& scene = *job.scene;
  const DrawOptions& options = job.options;
  std::string text = "draw " + std::to_string(id);
  for (const int n : {scene.width, scene.height, job.samples}) {
    text += ' ';
    AppendInteger(text, n);
  }
  text += scene.clip_space ? " clip " : " window ";
  text += std::to_string(scene.vertices.size()) + ' ' + std::to_string(job.Triangles().size());
  if (options.cull != Cull::kNone) {
    text += options.cull == Cull::kFront ? " cull=front" : " cull=back";
  }
  if (options.scissor) {
    const PixelRect& r = *options.scissor;
    text += " scissor=" + std::to_string(r.x0) + ',' + std::to_string(r.y0) + ',' +
            std::to_string(r.x1) + ',' + std::to_string(r.y1);
  }
  if (options.tile != 0) text += " tile=" + std::to_string(options.tile);
  if (options.threads > 1) text += " threads=" + std::to_string(options.threads);
  text += '\n';
  for (const Vertex& v : scene.vertices) {
    for (const double x : {v.x, v.y, v.z, v.w}) {
      AppendNumber(text, x);
      text += ' ';
    }
    text.back() = '\n';
  }
  for (const Triangle& t : job.Triangles()) {
    for (const std::int32_t index : t) {
      AppendInteger(text, index);
      text += ' ';
    }
    text.back() = '\n';
  }
  return text;
}

std::string BatchText(std::size_t n) { return "batch " + std::to_string(n) + "\n"; }

std::vector<DrawRequest> ReadCall(std::istream& in) {
  std::vector<std::string> words = NextWords(in);
  std::vector<DrawRequest> requests;
  if (words.empty()) return requests;
  std::size_t n = 1;
  if (words[0] == "batch") {
    if (words.size() != 2) Malformed("batch line", "batch N");
    n = Number<std::size_t>(words[1], "batch line");
    if (n < 1 || n > kMostInABatch) Malformed("batch line", "1 to 2^16 requests");
    words = NextWords(in);
  }
  for (;; words = NextWords(in)) {
    requests.push_back(ReadRequest(in, words));
    if (requests.size() == n) return requests;
  }
}

std::string AnswerText(std::uint64_t id, const Drawing& drawing, CoverageKind kind) {
  std::string text(AnswerWord(kind));
  text += ' ' + std::to_string(id) + '\n';
  const CoverageCounts& counts = drawing.counts;
  const auto columns = counts.size() / static_cast<std::size_t>(counts.height);
  const auto append = [&](const auto& values, const auto& more) {
    for (std::size_t k = 0; k < counts.size(); ++k) {
      AppendInteger(text, values[k]);
      more(k);
      text += (k + 1) % columns == 0 ? '\n' : ' ';
    }
  };
  const auto nothing = [](std::size_t) {};
  switch (kind) {
    case CoverageKind::kFacingCounts:
      append(counts.front, nothing);
      append(counts.back, nothing);
      break;
    case CoverageKind::kCounts:
    case CoverageKind::kMask:
      append(counts.front, nothing);
      break;
    case CoverageKind::kWinners:
      append(drawing.winners, nothing);
      break;
    case CoverageKind::kFragments:
      append(drawing.winners, [&](std::size_t k) {
        if (drawing.winners[k] == kNoTriangle) return;
        const std::array<double, 3>& weights = drawing.weights[k];
        for (const double x : {weights[0], weights[1], weights[2], drawing.depths[k]}) {
          text += ' ';
          AppendNumber(text, x);
        }
      });
      break;
  }
  return text;
}

Drawing ReadAnswer(std::uint64_t id, const DrawJob& job, const SubjectInfo& info,
                   const NextLine& next_line) {
  RequireHead(next_line(kMostOfAHead), AnswerWord(info.coverage), id, info.name);
  Drawing drawing;
  drawing.counts = CoverageCounts(job.scene->width, job.scene->height, job.samples);
  if (ShowsWinners(info)) {
    ReadWinners(drawing, job.Triangles().size(), info.coverage == CoverageKind::kFragments,
                next_line);
    return drawing;
  }
  ReadCounts(drawing, drawing.counts.front, next_line);
  if (info.coverage == CoverageKind::kFacingCounts) {
    ReadCounts(drawing, drawing.counts.back, next_line);
  }
  return drawing;
}

std::string RequestText(const EdgeRequest& request) {
  std::string text = (request.step ? "walk " : "edge ") + std::to_string(request.id);
  for (const Point2& at : {request.a, request.b, request.p}) {
    for (const double x : {at.x, at.y}) {
      text += ' ';
      AppendNumber(text, x);
    }
  }
  if (const std::optional<Step>& step = request.step) {
    text += step->along_y ? " y " : " x ";
    text += step->sign < 0 ? "-1 " : "+1 ";
    text += std::to_string(step->length) + ' ' + std::to_string(request.steps);
  }
  return text + '\n';
}

std::optional<EdgeRequest> ReadEdgeRequest(std::istream& in) {
  in >> std::ws;
  if (const int next = in.peek(); next != 'e' && next != 'w') return std::nullopt;
  const std::vector<std::string> words = NextWords(in);
  const std::string where = "edge or walk line";
  const bool walks = words[0] == "walk";
  if ((!walks && words[0] != "edge") || words.size() != (walks ? 12U : 8U)) {
    Malformed(where, "edge ID AX AY BX BY PX PY, or walk with x|y +1|-1 LENGTH STEPS behind");
  }
  const auto number = [&](std::size_t k) { return Number<double>(words[k], where); };
  EdgeRequest request{Number<std::uint64_t>(words[1], where),
                      {number(2), number(3)},
                      {number(4), number(5)},
                      {number(6), number(7)},
                      std::nullopt,
                      0};
  if (!walks) return request;
  if ((words[8] != "x" && words[8] != "y") || (words[9] != "+1" && words[9] != "-1")) {
    Malformed(where, "a walk along x or y, by +1 or -1");
  }
  request.step = Step{words[8] == "y", words[9] == "-1" ? -1 : +1, Number<int>(words[10], where)};
  request.steps = Number<int>(words[11], where);
  if (request.steps < 0 || request.steps > kMostSteps || request.step->length < 1) {
    Malformed(where, "a length of 1 or more, and 0 to 2^20 steps");
  }
  return request;
}

std::string ValuesText(std::uint64_t id, std::span<const double> values) {
  std::string text = "values " + std::to_string(id);
  for (const double value : values) {
    text += ' ';
    AppendNumber(text, value);
  }
  return text + '\n';
}

std::vector<double> ReadValues(const EdgeRequest& request, const std::string& subject,
                               const NextLine& next_line) {
  const std::size_t most = kMostOfAHead + MostOfARow(request.Values());
  RowReader row(RequireHead(next_line(most), "values", request.id, subject));
  std::vector<double> values(request.Values());
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = row.Next<double>(k, values.size());
  row.RequireEnd(values.size());
  return values;
}

}  // namespace rasterproof::subjects
