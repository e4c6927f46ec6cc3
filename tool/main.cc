// The command rasterproof.
#include "tool/command_line.h"

int main(int argc, char** argv) {
  return rasterproof::tool::RunCommandLine(argc, argv, "spans-exact");
}
