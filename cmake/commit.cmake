# Writes OUTPUT, which defines rasterproof::tool::kCommit, if the commit of SOURCES changed.
set(commit unknown)
execute_process(COMMAND git -C ${SOURCES} rev-parse --short=12 HEAD OUTPUT_VARIABLE found
  RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT failed)
  set(commit ${found})
  execute_process(COMMAND git -C ${SOURCES} diff --quiet HEAD RESULT_VARIABLE differs ERROR_QUIET)
  if(differs)
    string(APPEND commit "+")
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[
#include "tool/commit.h"

namespace rasterproof::tool {
const char* const kCommit = "@commit@";
}  // namespace rasterproof::tool
]] @ONLY)
