#include "subjects/mutants/mutants.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects {
namespace {

using mutants::Mutant;

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
  std::vector<Row> rows;
  const auto add = [&](std::vector<Mutant> table, std::string_view prefix, bool legal, bool late) {
    for (Mutant& planted : table) {
      MutantInfo info{std::string(prefix) + std::string(planted.name),
                      std::string(planted.change),
                      std::string(planted.source),
                      std::string(planted.causes),
                      legal,
                      late,
                      Parts(planted.killers)};
      rows.push_back({std::move(info), std::move(planted)});
    }
  };
  for (const auto table :
       {mutants::TieRuleMutants,   mutants::PositionMutants, mutants::SetUpMutants,
        mutants::TraversalMutants, mutants::TargetMutants,   mutants::SceneMutants,
        mutants::CrowdMutants,     mutants::RealMutants,     mutants::TransformMutants,
        mutants::ScanlineMutants,  mutants::MapMutants,      mutants::ShownValueMutants,
        mutants::ContractMutants,  mutants::FreeMutants,     mutants::SquareMutants,
        mutants::SetMutants,       mutants::GridMutants,     mutants::FacingMutants,
        mutants::FarMutants,       mutants::HistoryMutants,  mutants::SampleMutants,
        mutants::CentroidMutants,  mutants::FragmentMutants, mutants::WidthMutants,
        mutants::ModeMutants,      mutants::ListMutants,     mutants::ValueMutants,
        mutants::SlopeMutants}) {
    add(table(), "mutant:", false, false);
  }
  add(mutants::LateMutants(), "mutant:", false, true);
  add(mutants::LegalVariants(), "legal:", true, false);
  return rows;
}

const std::vector<Row>& Rows() {
  static const std::vector<Row> rows = MakeRows();
  return rows;
}

struct Maker {
  const MutantInfo& info;
  std::unique_ptr<Subject> operator()(const mutants::FixedStages& stages) const {
    return mutants::MakeFixedPoint(info.name, info.change, stages);
  }
  std::unique_ptr<Subject> operator()(const mutants::RealStages& stages) const {
    return mutants::MakeRealGeometry(info.name, info.change, stages);
  }
  std::unique_ptr<Subject> operator()(const mutants::ClipStages& stages) const {
    return mutants::MakeClipSpace(info.name, info.change, stages);
  }
  std::unique_ptr<Subject> operator()(const mutants::ValueStages& stages) const {
    return mutants::MakeShownValues(info.name, info.change, stages);
  }
  std::unique_ptr<Subject> operator()(const mutants::TransformStages& stages) const {
    return mutants::MakeOwnTransform(info.name, info.change, stages);
  }
  std::unique_ptr<Subject> operator()(const mutants::FreeStages& stages) const {
    return mutants::MakeFreeChoice(info.name, info.change, stages);
  }
  std::unique_ptr<Subject> operator()(const mutants::SquareStages& stages) const {
    return mutants::MakeSquares(info.name, info.change, stages);
  }
  std::unique_ptr<Subject> operator()(const mutants::ClippingStages& stages) const {
    return mutants::MakeClipping(info.name, info.change, stages);
  }
  std::unique_ptr<Subject> operator()(const mutants::ChannelStages& stages) const {
    return mutants::MakeValues(info.name, info.change, stages);
  }
  std::unique_ptr<Subject> operator()(const mutants::CentroidStages& stages) const {
    return mutants::MakeCentroids(info.name, info.change, stages);
  }
};

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
    std::unique_ptr<Subject> subject = std::visit(Maker{row.info}, row.planted.stages);
    SubjectInfo info = subject->Info();
    info.takes_float_modes = row.planted.takes_float_modes;
    subject->JudgeAs(std::move(info));
    return subject;
  }
  return nullptr;
}

}  // namespace rasterproof::subjects
