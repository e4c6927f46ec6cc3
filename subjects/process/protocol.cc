#include "subjects/process/protocol.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <istream>
#include <limits>
#include <sstream>
#include <system_error>
#include <vector>

#include "core/error.h"
#include "core/subject.h"

namespace rasterproof::subjects {
namespace {

constexpr std::size_t kMostListed = std::size_t{1} << 26;

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

Announced ParseDrawLine(const std::vector<std::string>& words, DrawRequest& request) {
  const std::string where = "draw line";
  if (words.size() < 8 || words[0] != "draw" || (words[5] != "window" && words[5] != "clip")) {
    Malformed(where, "draw ID WIDTH HEIGHT SAMPLES window|clip VERTICES TRIANGLES");
  }
  request.id = Number<std::uint64_t>(words[1], where);
  request.scene.width = Number<int>(words[2], where);
  request.scene.height = Number<int>(words[3], where);
  request.samples = Number<int>(words[4], where);
  request.scene.clip_space = words[5] == "clip";
  request.scene.precision = Precision::kFloat64;  // what it holds; a program narrows what it must
  const Announced announced{Number<std::size_t>(words[6], where),
                            Number<std::size_t>(words[7], where)};
  if (announced.vertices > kMostListed || announced.triangles > kMostListed) {
    Malformed(where, "at most 2^26 vertices and triangles");
  }
  for (std::size_t k = 8; k < words.size(); ++k) ParseOption(words[k], where, request.options);
  const Scene& s = request.scene;
  if (s.width < 1 || s.height < 1 || s.width > kMaxTargetSide || s.height > kMaxTargetSide ||
      request.samples < 1 || request.samples > kMaxSamplesPerPixel ||
      std::int64_t{s.width} * s.height * request.samples > kMaxTargetSamples) {
    Malformed(where, "sides of 1 to 65536 and at most 2^28 samples");
  }
  return announced;
}

}  // namespace

std::string RequestText(const DrawRequest& request) {
  const Scene& scene = request.scene;
  const DrawOptions& options = request.options;
  std::string text = "draw " + std::to_string(request.id);
  for (const int n : {scene.width, scene.height, request.samples}) {
    text += ' ';
    AppendInteger(text, n);
  }
  text += scene.clip_space ? " clip " : " window ";
  text += std::to_string(scene.vertices.size()) + ' ' + std::to_string(scene.triangles.size());
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
  for (const Triangle& t : scene.triangles) {
    for (const std::int32_t index : t) {
      AppendInteger(text, index);
      text += ' ';
    }
    text.back() = '\n';
  }
  return text;
}

std::optional<DrawRequest> ReadRequest(std::istream& in) {
  std::string line;
  do {
    if (!std::getline(in, line)) return std::nullopt;
  } while (line.empty());
  DrawRequest request;
  const Announced announced = ParseDrawLine(Words(line), request);
  const std::string where = "request " + std::to_string(request.id);
  for (std::size_t n = 0; n < announced.vertices; ++n) {
    const std::string place = where + ", vertex " + std::to_string(n);
    const std::vector<std::string> words = RequireWords(in, 4, place);
    request.scene.vertices.push_back(
        {Number<double>(words[0], place), Number<double>(words[1], place),
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
    request.scene.triangles.push_back(triangle);
  }
  return request;
}

std::string CountsText(std::uint64_t id, const CoverageCounts& counts, bool facings) {
  std::string text = "counts " + std::to_string(id) + "\n";
  const auto row_length =
      static_cast<std::size_t>(counts.width) * static_cast<std::size_t>(counts.samples);
  const auto append = [&](const std::vector<std::uint32_t>& side) {
    for (std::size_t k = 0; k < side.size(); ++k) {
      AppendInteger(text, side[k]);
      text += (k + 1) % row_length == 0 ? '\n' : ' ';
    }
  };
  append(counts.front);
  if (facings) append(counts.back);
  return text;
}

AnswerHead ParseAnswerHead(std::string_view line, std::uint64_t id) {
  const std::string number = " " + std::to_string(id);
  const auto is = [&](std::string_view word) {
    const std::string head = std::string(word) + number;
    return line.starts_with(head) && (line.size() == head.size() || line[head.size()] == ' ');
  };
  const auto rest = [&](std::size_t word) {
    return std::string(line.substr(std::min(line.size(), word + number.size() + 1)));
  };
  if (is("counts")) return {AnswerKind::kCounts, ""};
  if (is("refused")) return {AnswerKind::kRefused, rest(7)};
  if (is("fault")) return {AnswerKind::kFault, rest(5)};
  throw SubjectFault("it answered \"" + std::string(line.substr(0, 60)) + "\", not \"counts" +
                     number + "\"");
}

void ParseCountsRow(std::string_view line, std::size_t n, std::uint32_t* row) {
  const char* at = line.data();
  const char* const end = line.data() + line.size();
  const auto skip_blanks = [&] {
    while (at != end && (*at == ' ' || *at == '\t' || *at == '\r')) ++at;
  };
  for (std::size_t k = 0; k < n; ++k) {
    skip_blanks();
    const auto [stop, error] = std::from_chars(at, end, row[k]);
    if (error != std::errc{}) {
      throw SubjectFault("a row of its counts has " + std::to_string(k) + " numbers, not " +
                         std::to_string(n) + ": \"" + std::string(line.substr(0, 60)) + "\"");
    }
    at = stop;
  }
  skip_blanks();
  if (at != end) {
    throw SubjectFault("a row of its counts has more than " + std::to_string(n) + " numbers: \"" +
                       std::string(line.substr(0, 60)) + "\"");
  }
}

}  // namespace rasterproof::subjects
