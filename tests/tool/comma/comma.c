/* The example plugin in a program whose locale writes 3,5: as a toolkit's start, or a test's main,
 * sets it. */
#include <locale.h>

#include "kit/examples/plugin.c"

__attribute__((constructor)) static void take_the_users_locale(void) { setlocale(LC_ALL, ""); }
