# The sign filter of the direct form: l and r carry three roundings each, so the exact difference is
# within `three` (|l| + |r|) of l - r. Where |fl(l - r)| > fl(multiplier fl(|l| + |r|)), |l - r| is at
# least `least` (|l| + |r|), which is more.
# Proves the numbers of kFilterErrorMultiplier (library/exact_sign.h) and kEdgeErrorMultiplier
# (exact/filters.h), underflow apart. Run: gappa -Eprecision=240 edge_filter.g

three = 1 / ((1 + d1) * (1 + d2) * (1 + d3)) - 1;
least = multiplier * (1 + sum) * (1 + product) / (1 + difference);

{
  |d1| <= 1b-53 /\ |d2| <= 1b-53 /\ |d3| <= 1b-53 /\
  |sum| <= 1b-53 /\ |product| <= 1b-53 /\ |difference| <= 1b-53 /\
  # (3 + 16u) u
  multiplier >= 27021597764222992b-106 /\ multiplier <= 1b-51
->
  # (3 + 6.5u) u
  |three| <= 54043195528445965b-107 /\
  least >= 54043195528445965b-107
}
