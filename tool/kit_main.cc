#include <utility>

#include "kit/main.h"
#include "tool/command_line.h"
#include "tool/subject_kinds.h"

namespace rasterproof::kit {

int Main(int argc, char** argv, const std::string& name,
         std::function<std::unique_ptr<Subject>()> make) {
  tool::RegisterOwn(name, std::move(make));
  return tool::RunCommandLine(argc, argv, name);
}

}  // namespace rasterproof::kit
