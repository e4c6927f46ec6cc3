// The pictures of the report page: real scenes as they are, and what the naive methods made of
// them.
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/error.h"
#include "core/result.h"
#include "fmt/format.h"
#include "io/image.h"
#include "props/run/failure_view.h"
#include "reference/method.h"
#include "reference/rasterize.h"
#include "report/picture.h"
#include "report/play_link.h"
#include "tool/certify/certify.h"
#include "tool/failure.h"
#include "tool/file_names.h"
#include "tool/resolve.h"

namespace rasterproof::tool {
namespace {

constexpr int kWidestPicture = 1024;  // a page should load at once
constexpr std::size_t kMostFailures = 12;
constexpr std::size_t kMostEdgeValues = 6;

void PictureRender(const MeasuredScene& measured, std::vector<report::Picture>& pictures) {
  const reference::Method* method = reference::FindMethod("spans-exact");
  if (!measured.real() || measured.scene().width > kWidestPicture ||
      !Takes(method->info, measured.scene())) {
    return;
  }
  const FragmentBuffers fragments =
      reference::RasterizeFragments(measured.scene(), *method, {}, {.barycentrics = true});
  const std::string file = FileNameOf(measured.name()) + ".png";
  pictures.push_back(
      {measured.name() + ": barycentrics of the nearest triangle",
       fmt::format("{} --mode barycentrics --png {}", measured.CommandOf("coverage"), file), "",
       true, "scenes/" + file, io::EncodePng(report::PaintBarycentrics(fragments))});
}

// The measurement on the scene by which the subject is violated; nullptr if it is not.
const SceneResult* WrongOn(const report::Certificate& certificate, const std::string& scene) {
  for (const SceneResult& result : certificate.measured) {
    if (result.scene == scene && result.difference.wrong != 0 &&
        report::IsJudged(certificate, result)) {
      return &result;
    }
  }
  return nullptr;
}

// The case, explained; nothing if it can't be.
std::optional<report::Picture> Explained(const report::Certificate& certificate, const Case& c,
                                         Verdict verdict, const std::string& replay,
                                         const std::string& file) {
  const std::string& name = certificate.subject.name;
  try {
    if (!HoldsWhatWasSeen(verdict, c)) See(*MakeSubject(name), c, verdict);
    report::Explanation explanation = Explain(certificate.subject, c, verdict, "");
    explanation.headline.clear();  // the page shows it above the picture, the command below it
    if (explanation.edge_values.size() > kMostEdgeValues) {
      explanation.edge_values.resize(kMostEdgeValues);
      explanation.edge_values.emplace_back("the command below tells the others");
    }
    return report::Picture{verdict.message,
                           replay,
                           name,
                           false,
                           certificate.folder + "/" + file + ".svg",
                           report::ExplanationToSvg(explanation),
                           report::PlayFragment(props::AsDrawn(c, verdict), name)};
  } catch (const InputError&) {
    // It drew the scene before and refuses it now: the certificate remains valid, and the page has
    // one picture less.
    return std::nullopt;
  } catch (const SubjectStop&) {
    return std::nullopt;  // or it was interrupted
  }
}

// The first place at which the subject differs from the model on the scene; nothing if it doesn't.
std::optional<report::Picture> PictureOf(const report::Certificate& certificate,
                                         const MeasuredScene& measured) {
  const SceneResult* result = WrongOn(certificate, measured.name());
  if (result == nullptr) return std::nullopt;
  const std::string& name = certificate.subject.name;
  Case c;
  c.scene = measured.scene();
  c.profile = certificate.subject.profile;
  const CoverageDifference& difference = result->difference;
  Verdict verdict;
  verdict.message = fmt::format("{} on {}: {} of {} samples wrong, {} missing, {} unexpected", name,
                                measured.name(), difference.wrong, difference.samples,
                                difference.missing, difference.unexpected);
  return Explained(certificate, c, verdict, measured.CommandThatShows(name),
                   FileNameOf(measured.name()));
}

// The first counterexample that has a place to show.
std::optional<report::Picture> PictureOfCase(const report::Certificate& certificate) {
  for (const PropertyResult& result : certificate.tested) {
    if (result.outcome != Outcome::kViolated || !result.counterexample) continue;
    Verdict verdict = result.counterexample->verdict;
    const std::optional<Witness>& witness = verdict.witness;
    if (!verdict.compared && !(witness && (witness->x >= 0 || witness->triangle >= 0))) {
      continue;  // a breakdown
    }
    verdict.message =
        fmt::format("{}: {}: {}", certificate.subject.name, NameOf(result), verdict.message);
    std::optional<report::Picture> picture =
        Explained(certificate, result.counterexample->value, verdict,
                  report::ReplayCommand(certificate, result), result.property);
    if (picture) return picture;
  }
  return std::nullopt;
}

}  // namespace

std::vector<report::Picture> TakePictures(MeasuredScenes& scenes,
                                          const std::vector<report::Certificate>& certificates,
                                          Progress& progress) {
  std::vector<report::Picture> pictures;
  for (const std::unique_ptr<MeasuredScene>& measured : scenes) {
    progress.Stage("drawing " + measured->name());
    PictureRender(*measured, pictures);
  }
  // Every violated subject shows a shrunken case. One failure of each scene goes to the page of all
  // subjects, by the first subject that has none there yet: it then tells of many subjects rather
  // than of one many times. Whoever is not among them has a case there if there is room.
  std::vector<std::string> shown;
  for (const std::unique_ptr<MeasuredScene>& measured : scenes) {
    if (shown.size() == kMostFailures) break;
    progress.Stage("explaining " + measured->name());
    for (const report::Certificate& certificate : certificates) {
      const std::string& name = certificate.subject.name;
      if (std::ranges::find(shown, name) != shown.end()) continue;
      std::optional<report::Picture> picture = PictureOf(certificate, *measured);
      if (!picture) continue;
      picture->is_on_front = true;
      pictures.push_back(std::move(*picture));
      shown.push_back(name);
      break;
    }
  }
  progress.Stage("explaining counterexamples");
  for (const report::Certificate& certificate : certificates) {
    std::optional<report::Picture> picture = PictureOfCase(certificate);
    if (!picture) continue;
    picture->is_on_front = shown.size() < kMostFailures;
    if (picture->is_on_front) shown.push_back(certificate.subject.name);
    pictures.push_back(std::move(*picture));
  }
  return pictures;
}

}  // namespace rasterproof::tool
