// Which sources this program was built from.
#ifndef RASTERPROOF_TOOL_COMMIT_H_
#define RASTERPROOF_TOOL_COMMIT_H_

namespace rasterproof::tool {

/// The commit that was checked out, followed by "+" if files differed; "unknown" outside of a
/// repository. cmake/commit.cmake writes it in every build.
extern const char* const kCommit;

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_COMMIT_H_
