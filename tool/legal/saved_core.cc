#include "tool/legal/saved_core.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/call_end.h"
#include "core/drawing.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "tool/case_choice.h"
#include "tool/interrupt.h"
#include "tool/legal/cmd_legal.h"

namespace rasterproof::tool {
namespace {

// The scene with the triangles of the core alone.
Scene CoreScene(const Scene& scene, const legal::Core& core) {
  std::vector<std::size_t> triangles;
  for (const legal::Requirement& seen : core.requirements)
    triangles.insert(triangles.end(), seen.triangles.begin(), seen.triangles.end());
  std::ranges::sort(triangles);
  const auto repeated = std::ranges::unique(triangles);
  triangles.erase(repeated.begin(), repeated.end());
  Scene part = scene;
  part.triangles.clear();
  for (const std::size_t t : triangles) part.triangles.push_back(scene.triangles[t]);
  return part;
}

bool IsNotLegal(Subject& subject, const JudgedScene& judged) {
  try {
    const Judgement judgement = JudgeDrawing(judged, DrawInOneCall(subject, judged.scene));
    return judgement.verdict.legality == legal::Legality::kNotLegal;
  } catch (const SubjectStop&) {
    if (Interrupted()) throw;
    return false;
  }
}

io::CaseDrawing NumbersOf(const OneCall& drawn) {
  io::CaseDrawing saved;
  if (!drawn.has_counts) {
    saved.shows = io::DrawingShows::kIds;
    saved.visible = drawn.any_is_visible ? "any" : drawn.last_is_visible ? "last" : "first";
    for (const std::int32_t id : drawn.drawing.primitive_ids)
      saved.numbers.push_back(id == kNoPrimitive ? 0 : static_cast<std::uint32_t>(id) + 1);
    if (drawn.has_facings)
      saved.fronts.assign(drawn.visible_front.begin(), drawn.visible_front.end());
    return saved;
  }
  const CoverageCounts& counts = drawn.drawing.counts;
  if (drawn.is_mask) saved.shows = io::DrawingShows::kMask;
  for (std::size_t s = 0; s < counts.size(); ++s) saved.numbers.push_back(counts.Count(s));
  if (drawn.has_facings) saved.fronts = counts.front;
  return saved;
}

}  // namespace

std::string SaveCore(const LegalOptions& options, const JudgedScene& judged, const OneCall& drawn,
                     const legal::Core& core, Subject* subject) {
  io::CaseFile file;
  file.value.scene = judged.scene;
  file.value.profile = judged.profile;
  file.value.origin = "core of " + options.scene.path;
  file.subject = options.subject;
  file.property = "OneLegalModelExplainsTheMesh";
  // What is assumed is no word of the profile's: the command assumes it again.
  if (options.transform_error) file.value.profile.freedom.transform_error.reset();
  CaseChoice again;
  again.path = options.save;
  again.subject = options.subject;
  again.profile = options.profile;
  if (subject != nullptr) {
    JudgedScene part{CoreScene(judged.scene, core), judged.profile};
    if (IsNotLegal(*subject, part)) file.value.scene = std::move(part.scene);
  } else {
    file.subject = "exact";  // explain shows what the canonical model has there
    file.property.clear();
    file.value.origin += (options.image.empty() ? "" : " as " + options.image + " shows it") +
                         "; " + CoreText(core, judged.scene, judged.profile.pattern.samples());
    file.drawing = NumbersOf(drawn);
    again.profile.clear();  // the case states it
  }
  io::WriteFile(options.save, io::CaseToJson(file));
  std::string command = CommandFor("legal", again);
  if (options.transform_error)
    command += fmt::format(" --assume-transform-error {}", *options.transform_error);
  return command;
}

}  // namespace rasterproof::tool
