// Which sources this program was built from.
#ifndef RASTERPROOF_TOOL_COMMIT_H_
#define RASTERPROOF_TOOL_COMMIT_H_

namespace rasterproof::tool {

/// The commit that was checked out, with "+" behind it if files differed; "unknown" outside of a
/// repository. Written by cmake/commit.cmake in every build.
extern const char* const kCommit;

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_COMMIT_H_
