// Refuses, when it is compiled, a build whose compiler may compute float and double otherwise than
// IEEE 754 says, operation by operation. What is exact here rests on each of them. (Contraction no
// macro tells of: the build's flags switch it off.)
#ifndef RASTERPROOF_CORE_OWN_PRECISION_H_
#define RASTERPROOF_CORE_OWN_PRECISION_H_

#include <cfloat>

#if FLT_EVAL_METHOD != 0
#error \
    "rasterproof: float and double are wider than they say, as on the 387; use -mfpmath=sse -msse2"
#endif

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
// The flags that undo it: reference/CMakeLists.txt.
#error \
    "rasterproof: -ffast-math, or a part of it, makes it inexact; compile without, or undo it after"
#endif

#endif  // RASTERPROOF_CORE_OWN_PRECISION_H_
