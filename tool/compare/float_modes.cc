#include "tool/compare/float_modes.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>

#include "core/error.h"
#include "fmt/format.h"
#include "props/compare/float_modes.h"
#include "tool/interrupt.h"
#include "tool/subject_kinds.h"

namespace rasterproof::tool {
namespace {

// Where a mode is set, and what a user would have done to set it there.
struct Way {
  std::string_view name;
  bool is_of_host;  // by how the host of a library is started
  FloatModeOfHost::Where where = FloatModeOfHost::Where::kNowhere;
};
constexpr std::array kWays{
    Way{"call", false},
    Way{"load", true, FloatModeOfHost::Where::kFromTheStart},
    Way{"workers", true, FloatModeOfHost::Where::kInOtherThreads},
};

// Subjects of this program run in the mode; a library runs in a host.
Cell CompareInMode(const SubjectFactory& factory, Subject& usual, const props::Row& row,
                   FloatMode mode, const Way& way, const props::Limits& limits) {
  const auto cell_of = [&](Subject& subject, FloatMode option) {
    return props::CompareRow(row, {{props::ItselfInMode(subject, mode, option)}}, limits).front();
  };
  if (!way.is_of_host) return cell_of(usual, mode);
  if (!IsOutside(factory.name())) return {.excused = 1, .why = "it runs in no host"};
  if (mode == FloatMode::kTrapping) return {.excused = 1, .why = "a host does not start in it"};
  const std::unique_ptr<Subject> hosted = Kinds().in_host(factory.name(), {mode, way.where});
  hosted->JudgeAs(usual.Info());
  return cell_of(*hosted, FloatMode::kUsual);
}

}  // namespace

std::vector<FloatMode> ModesNamed(const std::vector<std::string>& names) {
  std::vector<FloatMode> modes;
  for (const std::string& name : names) {
    const std::optional<FloatMode> mode = FindFloatMode(name);
    if (!mode || *mode == FloatMode::kUsual) {
      throw InputError("option --mode", fmt::format("'{}' is no floating-point mode", name),
                       "give some of ftz, daz, up, down, zero, trap, with commas between");
    }
    if (!HasFloatMode(*mode)) {
      throw InputError("option --mode", fmt::format("this processor has no mode '{}'", name),
                       "leave it out");
    }
    modes.push_back(*mode);
  }
  return modes;
}

std::vector<Column> WaysOfModes(bool states_exact) {
  std::vector<Column> columns;
  for (const Way& way : kWays) {
    columns.push_back({.name = std::string(way.name),
                       .file = "",
                       .property = "EnvironmentKeepsCoverage",
                       .convicts = states_exact,
                       .is_saved = !way.is_of_host});
  }
  return columns;
}

std::vector<std::vector<Cell>> CompareModes(const SubjectFactory& subject,
                                            const std::vector<FloatMode>& modes,
                                            const ComparisonTable& table,
                                            const props::Limits& limits, Progress& progress) {
  progress.Stage(subject.name() + " in the usual mode");
  const std::unique_ptr<Subject> usual = subject.Make();
  if (!usual->Info().takes_float_modes) {
    throw InputError("subject " + subject.name(),
                     "it is a program, which sets its floating-point mode itself",
                     "give it as a plugin or a C++ type to call it in other modes");
  }
  const std::vector<props::UsualDrawing> drawings =
      props::DrawAsUsual(*usual, table.seed, table.cases, limits.stop);
  const props::Row row = props::RowOf(drawings);
  std::vector<std::vector<Cell>> cells(modes.size(), std::vector<Cell>(kWays.size()));
  for (std::size_t k = 0; k < modes.size(); ++k) {
    for (std::size_t w = 0; w < kWays.size() && !Interrupted(); ++w) {
      progress.Stage(
          fmt::format("{} in mode {}, {}", subject.name(), FloatModeName(modes[k]), kWays[w].name));
      cells[k][w] = CompareInMode(subject, *usual, row, modes[k], kWays[w], limits);
    }
  }
  return cells;
}

}  // namespace rasterproof::tool
