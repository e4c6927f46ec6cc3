// io/output.h where there are no files.
#include "core/error.h"
#include "io/output.h"

namespace rasterproof::io {

bool IsThere(const std::string& /*path*/) { return false; }

std::string ReadFile(const std::string& path) {
  throw InputError(path, "can't be read: a module has no files", "give the text itself");
}

}  // namespace rasterproof::io
