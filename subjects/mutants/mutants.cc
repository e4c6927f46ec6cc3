#include "subjects/mutants/mutants.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects {
namespace mutants {

extern const MutantTable* const kAllMutantTables[];
extern const std::size_t kNumberOfMutantTables;

}  // namespace mutants

namespace {

using mutants::Mutant;
using mutants::MutantKind;
using mutants::MutantTable;

struct Row {
  MutantInfo info;
  Mutant planted;
};

std::vector<std::string> Parts(std::string_view words) {
  std::vector<std::string> parts;
  while (!words.empty()) {
    const std::size_t end = std::min(words.find('|'), words.size());
    parts.emplace_back(words.substr(0, end));
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return parts;
}

std::vector<Row> MakeRows() {
  std::vector<const MutantTable*> tables(
      mutants::kAllMutantTables, mutants::kAllMutantTables + mutants::kNumberOfMutantTables);
  std::ranges::sort(tables, {}, [](const MutantTable* t) { return std::pair(t->kind, t->place); });
  std::vector<Row> rows;
  for (const MutantTable* table : tables) {
    const bool legal = table->kind == MutantKind::kLegal;
    for (Mutant& planted : table->rows()) {
      MutantInfo info{(legal ? "legal:" : "mutant:") + std::string(planted.name),
                      std::string(planted.change),
                      std::string(planted.source),
                      std::string(planted.causes),
                      legal,
                      table->kind == MutantKind::kLate,
                      Parts(planted.killers)};
      rows.push_back({std::move(info), std::move(planted)});
    }
  }
  return rows;
}

const std::vector<Row>& Rows() {
  static const std::vector<Row> rows = MakeRows();
  return rows;
}

}  // namespace

const std::vector<MutantInfo>& Mutants() {
  static const std::vector<MutantInfo> infos = [] {
    std::vector<MutantInfo> all;
    for (const Row& row : Rows()) all.push_back(row.info);
    return all;
  }();
  return infos;
}

bool IsMutant(std::string_view name) {
  return std::ranges::find(Mutants(), name, &MutantInfo::name) != Mutants().end();
}

std::unique_ptr<Subject> MakeMutant(std::string_view name) {
  for (const Row& row : Rows()) {
    if (row.info.name != name) continue;
    std::unique_ptr<Subject> subject = std::visit(
        [&](const auto& stages) { return mutants::Make(row.info.name, row.info.change, stages); },
        row.planted.stages);
    SubjectInfo info = subject->Info();
    info.takes_float_modes = row.planted.takes_float_modes;
    subject->JudgeAs(std::move(info));
    return subject;
  }
  return nullptr;
}

}  // namespace rasterproof::subjects
