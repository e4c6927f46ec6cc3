/* A plugin's source as a program that answers the requests of docs/subjects.md (version 1) on a
 * pipe, for processors that only an emulator runs:
 *
 *     aarch64-linux-gnu-gcc -O2 -I. kit/plugin_driver.c kit/examples/plugin.c -o mine -lm
 *     qemu-aarch64 -L /usr/aarch64-linux-gnu ./mine --describe > mine.subject
 *
 * `--describe` prints the lines of a description but `command`. kit/plugin_server.h says what of a
 * plugin is asked for.
 */
#include <stdio.h>
#include <string.h>

#include "kit/plugin_server.h"
#include "kit/rasterproof_plugin.h"

int main(int argc, char** argv) {
  static rasterproof_plugin plugin; /* what an older description lacks is zero */
  const rasterproof_plugin* const described = rasterproof_plugin_describe();
  if (described == NULL || described->version != RASTERPROOF_PLUGIN_VERSION ||
      described->draw == NULL || described->coverage > RASTERPROOF_FRAGMENTS) {
    fputs("plugin_driver: the description has no draw, or is of another version\n", stderr);
    return 2;
  }
  memcpy(&plugin, described, described->size < sizeof plugin ? described->size : sizeof plugin);
  if (argc > 1 && strcmp(argv[1], "--describe") == 0) {
    rasterproof_describe(&plugin, stdout);
    return 0;
  }
  rasterproof_serve(&plugin, stdin, stdout);
  return 0;
}
