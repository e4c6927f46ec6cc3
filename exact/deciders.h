// The signs that each backend decides. The two share no code with each other or with the fast path.
#ifndef RASTERPROOF_EXACT_DECIDERS_H_
#define RASTERPROOF_EXACT_DECIDERS_H_

#include "core/vertex.h"
#include "exact/signs.h"

namespace rasterproof::exact {

/// Sign of E(a, b; p).
///
/// Domain:     every finite double.
int IntegerEdgeSign(Point2 a, Point2 b, Point2 p);
int CgalEdgeSign(Point2 a, Point2 b, Point2 p);

/// Sign of the determinant with the given rows.
///
/// Domain:     every finite double.
int IntegerDeterminantSign(const Rows3& rows);
int CgalDeterminantSign(const Rows3& rows);

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_DECIDERS_H_
