#include <string.h>

#include "kit/rasterproof_rasterize.h"
#include "tests/kit/rasterize_calls.inc"
#include "tests/kit/rasterize_languages.h"

int rasterproof_calls_of_c99(void) { return calls(); }
