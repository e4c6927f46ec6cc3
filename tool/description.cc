#include "tool/description.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <istream>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/renamed.h"

namespace rasterproof::tool {
namespace {

using namespace std::string_literals;

template <class T, std::size_t n>
using Names = std::array<std::pair<std::string_view, T>, n>;

constexpr Names<CoverageKind, 5> kCoverages{{{"facing-counts", CoverageKind::kFacingCounts},
                                             {"counts", CoverageKind::kCounts},
                                             {"mask", CoverageKind::kMask},
                                             {"primitive-id", CoverageKind::kPrimitiveIds},
                                             {"fragments", CoverageKind::kFragments}}};
constexpr Names<bool, 2> kClocks{{{"processor", false}, {"elapsed", true}}};
constexpr Names<Precision, 2> kInputs{
    {{"float32", Precision::kFloat32}, {"float64", Precision::kFloat64}}};
constexpr Names<Visible, 2> kOrders{
    {{"last-drawn", Visible::kLastDrawn}, {"first-drawn", Visible::kFirstDrawn}}};
constexpr Names<BarycentricsOf, 3> kBarycentricsOf{{{"given", BarycentricsOf::kGiven},
                                                    {"snapped", BarycentricsOf::kSnapped},
                                                    {"either", BarycentricsOf::kEither}}};

constexpr Names<bool SubjectInfo::*, 11> kTakes{{{"window", &SubjectInfo::takes_window},
                                                 {"clip", &SubjectInfo::takes_clip},
                                                 {"culling", &SubjectInfo::takes_culling},
                                                 {"scissor", &SubjectInfo::takes_scissor},
                                                 {"tiles", &SubjectInfo::takes_tiles},
                                                 {"threads", &SubjectInfo::takes_threads},
                                                 {"batches", &SubjectInfo::takes_batches},
                                                 {"repeats", &SubjectInfo::takes_repeats},
                                                 {"same", &SubjectInfo::takes_same},
                                                 {"wants", &SubjectInfo::takes_wants},
                                                 {"npy", &SubjectInfo::takes_npy}}};

using Flag = bool& (*)(SubjectInfo&);
constexpr Names<Flag, 5> kShows{
    {{"edges", [](SubjectInfo& info) -> bool& { return info.edges.shows_values; }},
     {"steps", [](SubjectInfo& info) -> bool& { return info.edges.shows_steps; }},
     {"centroids", [](SubjectInfo& info) -> bool& { return info.fragments.shows_centroids; }},
     {"values", [](SubjectInfo& info) -> bool& { return info.fragments.shows_values; }},
     {"derivatives", [](SubjectInfo& info) -> bool& { return info.fragments.shows_derivatives; }}}};

template <class Table>
std::string NamesIn(const Table& table) {
  std::string names;
  for (const auto& entry : table) names += (names.empty() ? "" : ", ") + std::string(entry.first);
  return names;
}

template <class Table>
auto Chosen(const Table& table, std::string_view name, const std::string& place) {
  const auto found = std::ranges::find_if(table, [&](const auto& e) { return e.first == name; });
  if (found != table.end()) return found->second;
  throw InputError(place, fmt::format("'{}' is not known{}", name, io::RenamedText(name)),
                   "choose of: " + NamesIn(table));
}

template <class Table>
std::string_view NameOf(const Table& table, const typename Table::value_type::second_type& value) {
  return std::ranges::find_if(table, [&](const auto& e) { return e.second == value; })->first;
}

double ErrorOf(const std::string& value, const std::string& place) {
  double error = 0;
  const char* const end = value.data() + value.size();
  const auto [stop, problem] = std::from_chars(value.data(), end, error);
  if (problem == std::errc{} && stop == end && std::isfinite(error) && error > 0) return error;
  throw InputError(place, fmt::format("'{}' is not an error", value),
                   "give a positive number, or leave the line out");
}

double EdgeErrorOf(const std::string& value, const std::string& place) {
  if (value == "exact") return 0;
  try {
    return ErrorOf(value, place);
  } catch (const InputError&) {
    throw InputError(place, fmt::format("'{}' is not an error of edge values", value),
                     "give exact or a positive number, or leave the line out");
  }
}

// Reads "12.4 signed wrap", the words that follow "fixed".
FixedInput FixedInputFrom(std::istream& words, const std::string& place) {
  const auto refused = [&](const std::string& reason) {
    return InputError(place, reason,
                      fmt::format("write fixed N.M, N from 1 to {} and M from 0 to {}, then signed "
                                  "or unsigned, then wrap if it wraps",
                                  kMaxIntegerBits, kMaxSubpixelBits));
  };
  FixedInput fixed;
  char point = ' ';
  std::string sign;
  if (!(words >> fixed.integer_bits >> point >> fixed.fraction_bits) || point != '.' ||
      fixed.integer_bits < 1 || fixed.integer_bits > kMaxIntegerBits || fixed.fraction_bits < 0 ||
      fixed.fraction_bits > kMaxSubpixelBits) {
    throw refused("the fixed-point format is malformed");
  }
  if (!(words >> sign) || (sign != "signed" && sign != "unsigned")) {
    throw refused("the fixed-point format lacks its sign");
  }
  fixed.is_signed = sign == "signed";
  std::string wrap;
  fixed.wraps = static_cast<bool>(words >> wrap);
  if (fixed.wraps && wrap != "wrap") throw refused(fmt::format("'{}' is not known", wrap));
  if (words >> wrap) throw refused(fmt::format("unexpected word '{}'", wrap));
  return fixed;
}

void TakeInput(const std::string& value, const std::string& place,
               ProgramDescription& description) {
  std::istringstream words(value);
  std::string kind;
  words >> kind;
  if (kind == "fixed") {
    description.fixed = FixedInputFrom(words, place);
  } else {
    description.info.input = Chosen(kInputs, value, place);
  }
}

// The input and the profile are one contract, whichever of the two states it.
void JoinFixedInput(ProgramDescription& description, const std::string& place) {
  std::optional<FixedInput>& stated = description.info.profile.fixed;
  if (stated && description.fixed && *stated != *description.fixed) {
    throw InputError(place, "its input and its profile state different fixed-point formats",
                     "state one of them, or make them equal");
  }
  if (description.fixed) stated = description.fixed;
  description.info.profile.name = io::ProfileName(description.info.profile);
  if (stated && description.info.takes_clip) {
    throw InputError(place, "a fixed-point input cannot take clip space",
                     "leave clip out of takes");
  }
}

std::string InputText(const SubjectInfo& info) {
  if (!info.profile.fixed) return std::string(NameOf(kInputs, info.input));
  const FixedInput& fixed = *info.profile.fixed;
  return fmt::format("fixed {}.{} {}{}", fixed.integer_bits, fixed.fraction_bits,
                     fixed.is_signed ? "signed" : "unsigned", fixed.wraps ? " wrap" : "");
}

int ProtocolOf(const std::string& value, const std::string& place) {
  if (value == "1" || value == "2" || value == "3") return value.front() - '0';
  throw InputError(place,
                   fmt::format("this program does not speak version '{}' of the protocol", value),
                   "write under takes which of same, wants and npy the subject reads");
}

void TakeLine(const std::string& key, const std::string& value, const std::string& place,
              ProgramDescription& description) {
  SubjectInfo& info = description.info;
  if (key == "name") {
    info.name = value;
  } else if (key == "summary") {
    info.summary = value;
  } else if (key == "command") {
    description.command = value;
  } else if (key == "profile") {
    info.profile = io::ParseProfile(value, place + ": profile");
  } else if (key == "coverage") {
    info.coverage = Chosen(kCoverages, value, place);
  } else if (key == "input") {
    TakeInput(value, place, description);
  } else if (key == "visible") {
    info.fragments.visible = Chosen(kOrders, value, place);
  } else if (key == "barycentrics-of") {
    info.fragments.barycentrics_of = Chosen(kBarycentricsOf, value, place);
  } else if (key == "barycentric-error") {
    info.fragments.barycentric_error = ErrorOf(value, place);
  } else if (key == "depth-error") {
    info.fragments.depth_error = ErrorOf(value, place);
  } else if (key == "edge-error") {
    info.edges.value_error = EdgeErrorOf(value, place);
  } else if (key == "stepping-error") {
    info.edges.stepping_error = EdgeErrorOf(value, place);
  } else if (key == "clock") {
    info.draws_elsewhere = Chosen(kClocks, value, place);
  } else if (key == "protocol") {
    description.protocol = ProtocolOf(value, place);
  } else if (key == "shows") {
    std::istringstream words(value);
    for (std::string word; words >> word;) Chosen(kShows, word, place)(info) = true;
  } else if (key == "takes") {
    for (const auto& [name, member] : kTakes) info.*member = false;
    std::istringstream words(value);
    for (std::string word; words >> word;) info.*Chosen(kTakes, word, place) = true;
  } else {
    throw InputError(
        place, fmt::format("there is no key '{}'{}", key, io::RenamedText(key)),
        "use name, summary, command, input, coverage, visible, barycentrics-of, barycentric-error, "
        "depth-error, shows, edge-error, stepping-error, takes, clock or profile");
  }
}

// What is said of edge values that are not shown is a mistake as well.
void RequireEdgesItShows(const EdgeInfo& edges, const std::string& place) {
  if (edges.shows_steps && !edges.shows_values) {
    throw InputError(place, "it shows steps without edge values", "write: shows edges steps");
  }
  if ((edges.value_error && !edges.shows_values) || (edges.stepping_error && !edges.shows_steps)) {
    throw InputError(place, "it states an error of values that it does not show",
                     "add a line: shows edges steps");
  }
}

// What is said of primitive ids by a program that shows none is a mistake.
void RequireWhatItShows(const SubjectInfo& info, const std::string& place) {
  const FragmentInfo& properties = info.fragments;
  const FragmentInfo nothing;
  const bool says_barycentrics = properties.barycentrics_of != nothing.barycentrics_of ||
                                 properties.barycentric_error != 0 || properties.depth_error != 0;
  if (says_barycentrics && info.coverage != CoverageKind::kFragments) {
    throw InputError(place, "it describes barycentrics or depths but shows none",
                     "add a line: coverage fragments");
  }
  const bool shows_values = properties.shows_values || properties.shows_derivatives;
  if ((properties.shows_centroids || shows_values) &&
      (info.coverage != CoverageKind::kFragments || !info.takes_wants)) {
    throw InputError(place,
                     fmt::format("{} need fragments, and requests that want them",
                                 properties.shows_centroids ? "centroids" : "values"),
                     "add a line: coverage fragments, and the word wants under takes");
  }
  if (properties.shows_derivatives && !properties.shows_values) {
    throw InputError(place, "it shows derivatives without values",
                     "write: shows values derivatives");
  }
  if (properties.visible != nothing.visible && !ShowsPrimitiveIds(info)) {
    throw InputError(place, "it says which triangle is visible but does not show it",
                     "add a line: coverage primitive-id");
  }
}

}  // namespace

ProgramDescription PlainDescription() {
  ProgramDescription description;
  SubjectInfo& info = description.info;
  info.takes_culling = info.takes_scissor = info.takes_tiles = false;
  info.coverage = CoverageKind::kCounts;
  return description;
}

ProgramDescription ParseDescription(std::string_view text, const std::string& place) {
  ProgramDescription description = PlainDescription();
  std::istringstream lines{std::string(text)};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string::npos || line[begin] == '#') continue;
    const std::size_t space = std::min(line.find_first_of(" \t", begin), line.size());
    const std::size_t value = line.find_first_not_of(" \t", space);
    const std::size_t end = line.find_last_not_of(" \t\r") + 1;
    TakeLine(line.substr(begin, space - begin),
             value == std::string::npos ? "" : line.substr(value, end - value),
             fmt::format("{}: line {}", place, number), description);
  }
  SubjectInfo& info = description.info;
  info.takes_same = info.takes_same || description.protocol >= 2;
  info.takes_wants = info.takes_wants || description.protocol >= 2;
  info.takes_npy = info.takes_npy || description.protocol >= 3;
  RequireWhatItShows(info, place);
  RequireEdgesItShows(description.info.edges, place);
  if (!description.info.takes_window && !description.info.takes_clip) {
    throw InputError(place, "it takes neither window nor clip space", "name one under takes");
  }
  JoinFixedInput(description, place);
  return description;
}

namespace {

std::string EdgeLines(const EdgeInfo& edges) {
  if (!edges.shows_values) return "";
  std::string text = edges.shows_steps ? "shows edges steps\n" : "shows edges\n";
  const auto add = [&](const char* key, const std::optional<double>& error) {
    if (error)
      text += *error == 0 ? fmt::format("{} exact\n", key) : fmt::format("{} {}\n", key, *error);
  };
  add("edge-error", edges.value_error);
  if (edges.shows_steps) add("stepping-error", edges.stepping_error);
  return text;
}

}  // namespace

std::string DescriptionText(const SubjectInfo& info, const std::string& profile) {
  std::string takes;
  for (const auto& [name, member] : kTakes) {
    if (info.*member) takes += " " + std::string(name);
  }
  std::string one_line = profile;
  std::ranges::replace(one_line, '\n', ' ');
  std::string text = fmt::format(
      "name {}\nsummary {}\ninput {}\ncoverage {}\ntakes{}\nprofile {}\n", info.name, info.summary,
      InputText(info), NameOf(kCoverages, info.coverage), takes, one_line);
  if (info.draws_elsewhere) text += "clock elapsed\n";
  text += EdgeLines(info.edges);
  if (!ShowsPrimitiveIds(info)) return text;
  const FragmentInfo& properties = info.fragments;
  text += fmt::format("visible {}\n", NameOf(kOrders, properties.visible));
  if (info.coverage != CoverageKind::kFragments) return text;
  text += fmt::format("barycentrics-of {}\n", NameOf(kBarycentricsOf, properties.barycentrics_of));
  if (properties.barycentric_error > 0)
    text += fmt::format("barycentric-error {}\n", properties.barycentric_error);
  if (properties.depth_error > 0) text += fmt::format("depth-error {}\n", properties.depth_error);
  const std::string shows = (properties.shows_centroids ? " centroids"s : ""s) +
                            (properties.shows_values ? " values" : "") +
                            (properties.shows_derivatives ? " derivatives" : "");
  if (!shows.empty()) text += fmt::format("shows{}\n", shows);
  return text;
}

}  // namespace rasterproof::tool
