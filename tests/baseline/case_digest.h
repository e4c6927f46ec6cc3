// Digests of cases and scenes, member by member: a new member of Profile or Scene belongs here too.
#ifndef RASTERPROOF_TESTS_BASELINE_CASE_DIGEST_H_
#define RASTERPROOF_TESTS_BASELINE_CASE_DIGEST_H_

#include <cstdint>

#include "core/case.h"
#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/scene.h"
#include "tests/baseline/digest.h"

namespace rasterproof::baseline {

void Add(const DrawOptions& options, Digest& digest);
/// The scene as it is written: vertices that nothing uses, and which ones are shared. Not its name.
void Add(const Scene& scene, Digest& digest);
/// What a rasterizer makes of it: the target, and the corners of every triangle in their order.
void AddDrawn(const Scene& scene, Digest& digest);
void Add(const CoverageCounts& counts, Digest& digest);

/// All of a case but its origin and the names of its scene and its profile.
std::uint64_t CaseDigest(const Case& c);

}  // namespace rasterproof::baseline

#endif  // RASTERPROOF_TESTS_BASELINE_CASE_DIGEST_H_
