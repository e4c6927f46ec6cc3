#include "report/case_code.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/case.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/vertex.h"
#include "fmt/format.h"
#include "fmt/ranges.h"

namespace rasterproof::report {
namespace {

// How one language writes it. In `target` stand a width and a height; where an array begins its
// type, its name, the name in the manner of constants, and the columns.
struct Syntax {
  std::string_view comment;
  std::string_view not_a_number;
  std::string_view infinity;
  std::string_view target;
  std::string_view begin;  // of an array
  std::string_view open;   // of a row
  std::string_view close;
  std::string_view end;
};

constexpr std::array<Syntax, 4> kSyntaxes{
    Syntax{"// ", "NAN", "INFINITY", "constexpr int kWidth = {};\nconstexpr int kHeight = {};\n",
           "constexpr {0} k{2}[][{3}] = {{\n", "{", "}", "};\n"},
    Syntax{"# ", "float(\"nan\")", "float(\"inf\")", "width, height = {}, {}\n", "{1} = [\n", "(",
           ")", "]\n"},
    Syntax{"// ", "NaN", "Infinity", "const width = {};\nconst height = {};\n",
           "const {1}: number[][] = [\n", "[", "]", "];\n"},
    Syntax{"// ", "", "", "", "", "", "", ""},
};

const Syntax& SyntaxOf(CodeLanguage language) {
  return kSyntaxes[static_cast<std::size_t>(language)];
}

// x and y; z where one is not 0; x, y, z and w in clip space.
std::size_t CoordinatesOf(const Scene& scene) {
  if (scene.clip_space) return 4;
  return std::ranges::any_of(scene.vertices, [](const Vertex& v) { return v.z != 0; }) ? 3 : 2;
}

std::vector<double> Coordinates(const Vertex& v, std::size_t count) {
  const std::array<double, 4> all{v.x, v.y, v.z, v.w};
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)};
}

class CaseWriter {
 public:
  CaseWriter(CodeLanguage language, const Case& c)
      : language_(language),
        syntax_(SyntaxOf(language)),
        scene_(c.scene),
        fixed_(CanBeGiven(c.scene, c.profile) ? c.profile.fixed : std::nullopt),
        coordinates_(CoordinatesOf(c.scene)) {}

  std::string Text(std::string_view notes) const {
    std::string text;
    while (!notes.empty()) {
      const std::size_t end = std::min(notes.find('\n'), notes.size());
      text += fmt::format("{}{}\n", syntax_.comment, notes.substr(0, end));
      notes.remove_prefix(std::min(end + 1, notes.size()));
    }
    text += fmt::format("{}{}\n", syntax_.comment, Meaning());
    return text + (language_ == CodeLanguage::kReadmemh ? Words() : Lists());
  }

 private:
  std::string Meaning() const {
    std::string text = scene_.clip_space   ? "vertices: x, y, z, w in clip space"
                       : coordinates_ == 3 ? "vertices: x, y, z in window space"
                                           : "vertices: x, y in window space";
    if (fixed_) {
      text += fmt::format(", in units of 1/{} pixel", std::int64_t{1} << fixed_->fraction_bits);
    } else if (!scene_.clip_space) {
      text += ", in pixels";
    }
    if (language_ == CodeLanguage::kReadmemh) {
      text += fmt::format("; words: width, height, vertices ({}), triangles ({}), {}, indices",
                          scene_.vertices.size(), scene_.triangles.size(),
                          fixed_     ? "coordinates as integers"
                          : IsWide() ? "coordinates as float64"
                                     : "coordinates as float32");
    }
    return text;
  }

  bool IsFloat64() const { return !fixed_ && scene_.precision == Precision::kFloat64; }
  // A fixed-point input that wraps is given integers beyond its own bits, too.
  bool IsWide() const {
    return IsFloat64() ||
           (fixed_ && std::ranges::any_of(scene_.vertices, [&](const Vertex& v) {
              return std::ranges::any_of(Coordinates(v, coordinates_), [&](double x) {
                const std::int64_t raw = fixed_->Raw(x);
                return raw != static_cast<std::int32_t>(raw);
              });
            }));
  }

  std::string Number(double x) const {
    if (fixed_) return fmt::format("{}", fixed_->Raw(x));
    if (std::isnan(x)) return std::string(syntax_.not_a_number);
    const std::string_view sign = std::signbit(x) ? "-" : "";
    if (std::isinf(x)) return fmt::format("{}{}", sign, syntax_.infinity);
    if (language_ != CodeLanguage::kCpp) {
      const std::string text = fmt::format("{}", x);
      const bool is_integer = text.find_first_of(".e") == text.npos;
      return is_integer && language_ == CodeLanguage::kPython ? text + ".0" : text;
    }
    return fmt::format("{:a}{}", x, IsFloat64() ? "" : "F");
  }

  std::string Lists() const {
    std::vector<CodeRow> vertices;
    for (const Vertex& v : scene_.vertices) {
      CodeRow& row = vertices.emplace_back();
      for (const double x : Coordinates(v, coordinates_)) row.push_back(Number(x));
    }
    std::vector<CodeRow> triangles;
    for (const Triangle& t : scene_.triangles) {
      triangles.push_back({std::to_string(t[0]), std::to_string(t[1]), std::to_string(t[2])});
    }
    const std::string_view type = fixed_        ? (IsWide() ? "std::int64_t" : "std::int32_t")
                                  : IsFloat64() ? "double"
                                                : "float";
    return fmt::format(fmt::runtime(syntax_.target), scene_.width, scene_.height) +
           ArrayAsCode(language_, "vertices", type, coordinates_, vertices) +
           ArrayAsCode(language_, "triangles", "int", 3, triangles);
  }

  std::string Word(std::int64_t value) const {
    const auto bits = static_cast<std::uint64_t>(value);
    return IsWide() ? fmt::format("{:016x}", bits)
                    : fmt::format("{:08x}", static_cast<std::uint32_t>(bits));
  }
  std::string CoordinateWord(double x) const {
    if (fixed_) return Word(fixed_->Raw(x));
    if (IsFloat64()) return fmt::format("{:016x}", std::bit_cast<std::uint64_t>(x));
    return fmt::format("{:08x}", std::bit_cast<std::uint32_t>(static_cast<float>(x)));
  }
  std::string Words() const {
    std::string text = fmt::format("{} {}\n{} {}\n", Word(scene_.width), Word(scene_.height),
                                   Word(static_cast<std::int64_t>(scene_.vertices.size())),
                                   Word(static_cast<std::int64_t>(scene_.triangles.size())));
    for (const Vertex& v : scene_.vertices) {
      std::vector<std::string> words;
      for (const double x : Coordinates(v, coordinates_)) words.push_back(CoordinateWord(x));
      text += fmt::format("{}\n", fmt::join(words, " "));
    }
    for (const Triangle& t : scene_.triangles) {
      text += fmt::format("{} {} {}\n", Word(t[0]), Word(t[1]), Word(t[2]));
    }
    return text;
  }

  CodeLanguage language_;
  const Syntax& syntax_;
  const Scene& scene_;
  std::optional<FixedInput> fixed_;
  std::size_t coordinates_;
};

}  // namespace

std::optional<CodeLanguage> CodeLanguageNamed(std::string_view name) {
  const auto found = std::ranges::find(kCodeLanguages, name);
  if (found == kCodeLanguages.end()) return std::nullopt;
  return static_cast<CodeLanguage>(found - kCodeLanguages.begin());
}

std::string_view CommentOf(CodeLanguage language) { return SyntaxOf(language).comment; }

std::string ArrayAsCode(CodeLanguage language, std::string_view name, std::string_view type,
                        std::size_t columns, const std::vector<CodeRow>& rows) {
  const Syntax& syntax = SyntaxOf(language);
  std::string constant(name);
  constant.front() = static_cast<char>(constant.front() - 'a' + 'A');
  std::string text = fmt::format(fmt::runtime(syntax.begin), type, name, constant, columns);
  for (const CodeRow& row : rows) {
    text += fmt::format("    {}{}{},\n", syntax.open, fmt::join(row, ", "), syntax.close);
  }
  return text + std::string(syntax.end);
}

std::string CaseCode(CodeLanguage language, const Case& c, std::string_view notes) {
  return CaseWriter(language, c).Text(notes);
}

}  // namespace rasterproof::report
