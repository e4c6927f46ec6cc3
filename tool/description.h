// What a subject outside this program says of itself, as text: one `key value` a line.
#ifndef RASTERPROOF_TOOL_DESCRIPTION_H_
#define RASTERPROOF_TOOL_DESCRIPTION_H_

#include <optional>
#include <string>
#include <string_view>

#include "core/subject_info.h"

namespace rasterproof::tool {

/// Keys, all optional but for `command` in a file: name, summary, command (run by the shell), input
/// (float32, float64, or as "fixed 12.4 signed wrap": fixed point, signed or unsigned, wrap or
/// nothing), coverage (facing-counts, counts, mask, primitive-id or fragments), visible (last-drawn
/// or first-drawn), barycentrics-of (given, snapped or either), barycentric-error and depth-error
/// (absolute), shows (any of edges, steps, centroids, values, derivatives), edge-error and
/// stepping-error (exact, or as in EdgeInfo), takes (any of window, clip, culling, scissor, tiles,
/// threads, batches, repeats, same, wants, npy), clock (elapsed if another processor draws),
/// profile (a preset, or a profile file's JSON on the one line), protocol (as earlier versions had
/// it: 2 stands for takes same wants, 3 for npy too). Lines that begin with # are comments.
struct ProgramDescription {
  SubjectInfo info;
  std::string command;
  /// What the line `input` says; info.profile.fixed holds it, or what the profile says.
  std::optional<FixedInput> fixed;
  int protocol = 1;
};

/// Assumed for a program without a description: float32, window space, counts without facings,
/// no culling, scissor, tiles or threads, profile "real".
ProgramDescription PlainDescription();

/// Error:      InputError with place, line and remedy.
ProgramDescription ParseDescription(std::string_view text, const std::string& place);

/// The text that ParseDescription reads back; `profile` is a preset's name or JSON.
std::string DescriptionText(const SubjectInfo& info, const std::string& profile);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_DESCRIPTION_H_
