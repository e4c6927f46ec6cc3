// No overflow in the fixed-point methods, for all coordinates within a bound at once: their very
// form and walk, run with numbers that stand for ranges. The bound is the largest there is.
#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>

#include "reference/edge_walks.h"
#include "reference/integer_form.h"
#include "tests/reference/ranged.h"

namespace rasterproof::reference {
namespace {

using testing::Ranged;

/// The form with any sample of the box for the centre of column 0 and row 1.
template <int kBits, int kSubpixels>
class AnySampleForm : public IntegerForm<Ranged<kBits>, kSubpixels> {
 public:
  using IntegerForm<Ranged<kBits>, kSubpixels>::IntegerForm;
  static Ranged<kBits> Centre(int n) { return n == 0 ? x : y; }
  inline static Ranged<kBits> x{0}, y{0};
};

/// An edge and a sample: each coordinate is any of a range, which may be one number.
template <int kBits, int kSubpixels>
struct Inputs {
  using Number = Ranged<kBits>;
  using Form = AnySampleForm<kBits, kSubpixels>;
  PointOf<Number> a, b, p;

  static Inputs Within(std::int64_t bound) {
    Number::Begin();
    const auto any = [&] { return Number::Variable(-bound, bound); };
    const auto point = [&] { return PointOf<Number>{any(), any()}; };
    return {point(), point(), point()};
  }
  /// The edge on the left of the box, and a sample on its right.
  static Inputs Widest(std::int64_t bound) {
    Number::Begin();
    return {{-bound, -bound}, {-bound, bound}, {bound, bound}};
  }

  /// Does what a row does: the value of its first sample, and one step, which may lead out of the
  /// box. Whether an operation overflowed, for an edge as it is given or reversed.
  bool Overflows() const {
    for (const bool reversed : {false, true}) {
      const Form form(a, b, reversed);
      Form::x = p.x;
      Form::y = p.y;
      auto row = RowWalk<Form>(form, 0, 0).RowStart(1);
      row.Next();
      const Number stepped = row.Value(1);
      const Number direct = form.At(p.x + Form::kOne, p.y);
      EXPECT_TRUE(stepped == direct) << "a step along x is no difference of two values";
      EXPECT_TRUE(form.At(p.x, p.y) + form.StepY() == form.At(p.x, p.y + Form::kOne));
    }
    return Number::HasOverflowed();
  }
};

/// The largest bound on coordinates, in steps of the grid, up to which nothing overflows.
template <int kBits, int kSubpixels>
std::int64_t LargestBound() {
  std::int64_t holds = 1;
  std::int64_t fails = std::int64_t{1} << (kBits / 2);
  while (fails - holds > 1) {
    const std::int64_t middle = holds + (fails - holds) / 2;
    (Inputs<kBits, kSubpixels>::Within(middle).Overflows() ? fails : holds) = middle;
  }
  return holds;
}

template <class I, int kSubpixels>
void ExpectLargest(std::int64_t bound) {
  constexpr int kBits = 8 * sizeof(I);
  using Case = Inputs<kBits, kSubpixels>;
  EXPECT_EQ((LargestBound<kBits, kSubpixels>()), bound);
  EXPECT_FALSE(Case::Widest(bound).Overflows());
  EXPECT_TRUE(Case::Widest(bound + 1).Overflows()) << "one input beyond the bound overflows";
  const double declared = kIntegerCoordinateLimit<I> * IntegerForm<I, kSubpixels>::kOne;
  EXPECT_LE(declared, static_cast<double>(bound));
}

TEST(IntegerRanges, Int32OverflowsFrom23167StepsOn) { ExpectLargest<std::int32_t, 4>(23166); }
TEST(IntegerRanges, Int64OverflowsFrom1518500186StepsOn) {
  ExpectLargest<std::int64_t, 8>(1'518'500'185);
}

TEST(IntegerRanges, RefusesWhatIsNoPolynomialOfFirstDegree) {
  Ranged<32>::Begin();
  const auto x = Ranged<32>::Variable(-1, 1);
  EXPECT_THROW(x * x, std::domain_error);
  EXPECT_TRUE((x + 1) * 2 - x == x + 2);
}

}  // namespace
}  // namespace rasterproof::reference
