// InputError: a usage or input error, with its place, the reason and the remedy.
#ifndef RASTERPROOF_CORE_ERROR_H_
#define RASTERPROOF_CORE_ERROR_H_

#include <stdexcept>
#include <string>

namespace rasterproof {

/// An error that the caller can mend: a file, an option, a full disk. The command exits with 2.
/// The message names the place ("scene.json: vertices[3][0]"), the reason and the remedy.
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& place, const std::string& reason, const std::string& remedy)
      : std::runtime_error(place + ": " + reason + "; " + remedy) {}
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_ERROR_H_
