#include <string.h>

#include "library/rasterproof_rasterize.h"
#include "tests/library/rasterize_calls.inc"
#include "tests/library/rasterize_languages.h"

int rasterproof_calls_of_cxx11() { return calls(); }
