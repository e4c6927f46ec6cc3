# (V_j x V_i) . p: a term carries its product, the difference, the product with p, two sums.
# Proves the number of kHomogeneousErrorMultiplier (reference/homogeneous.h).
# Run: gappa -Eprecision=240 homogeneous.g

f_five = (1 + f1) * (1 + f2) * (1 + f3) * (1 + f4) * (1 + f5) - 1;
d_five = (1 + d1) * (1 + d2) * (1 + d3) * (1 + d4) * (1 + d5) - 1;

{
  |f1| <= 1b-24 /\ |f2| <= 1b-24 /\ |f3| <= 1b-24 /\ |f4| <= 1b-24 /\ |f5| <= 1b-24 /\
  |d1| <= 1b-53 /\ |d2| <= 1b-53 /\ |d3| <= 1b-53 /\ |d4| <= 1b-53 /\ |d5| <= 1b-53
->
  # (5 + 11u) u
  |f_five| <= 83886091b-48 /\
  |d_five| <= 45035996273704971b-106
}
