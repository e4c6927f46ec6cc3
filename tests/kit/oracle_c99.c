#include "kit/rasterproof_oracle.h"
#include "tests/kit/oracle_calls.inc"
#include "tests/kit/oracle_languages.h"

int rasterproof_oracle_calls_of_c99(void) { return calls(); }
