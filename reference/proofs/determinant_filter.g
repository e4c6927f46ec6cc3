# The sign filter of a 3x3 determinant: a term carries at most five roundings; of the bound the
# permanent carries at most five, its product with 8u one.
# Proves the number of kDeterminantErrorMultiplier (exact/filters.h), underflow apart.
# Run: gappa -Eprecision=240 determinant_filter.g

five = (1 + d1) * (1 + d2) * (1 + d3) * (1 + d4) * (1 + d5) - 1;
bound = 8b-53 * ((1 + e1) * (1 + e2) * (1 + e3) * (1 + e4) * (1 + e5) * (1 + e6));

{
  |d1| <= 1b-53 /\ |d2| <= 1b-53 /\ |d3| <= 1b-53 /\ |d4| <= 1b-53 /\ |d5| <= 1b-53 /\
  |e1| <= 1b-53 /\ |e2| <= 1b-53 /\ |e3| <= 1b-53 /\ |e4| <= 1b-53 /\ |e5| <= 1b-53 /\
  |e6| <= 1b-53
->
  |five| <= 81b-57 /\
  bound >= 127b-57
}
