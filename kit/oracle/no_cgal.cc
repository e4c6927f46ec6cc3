// The decider by CGAL, where there is no CGAL: nothing that this library exports asks for it.
#include <stdexcept>

#include "core/vertex.h"
#include "exact/deciders.h"

namespace rasterproof::exact {

int CgalEdgeSign(Point2 /*a*/, Point2 /*b*/, Point2 /*p*/) {
  throw std::logic_error("this library is built without CGAL");
}

int CgalDeterminantSign(const Rows3& /*rows*/) {
  throw std::logic_error("this library is built without CGAL");
}

}  // namespace rasterproof::exact
