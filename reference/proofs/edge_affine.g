# A p.x + B p.y + C: a term carries at most four roundings (A, the product, two sums), a product
# of the constant three (the product, the difference, one sum). Fused, it is the other way round.
# Proves the numbers of kAffineLineErrorMultiplier, kAffineConstantErrorMultiplier and of the fused
# pair (reference/bounds.h). Run: gappa -Eprecision=240 edge_affine.g

f_three = (1 + f1) * (1 + f2) * (1 + f3) - 1;
f_four = (1 + f1) * (1 + f2) * (1 + f3) * (1 + f4) - 1;
d_three = (1 + d1) * (1 + d2) * (1 + d3) - 1;
d_four = (1 + d1) * (1 + d2) * (1 + d3) * (1 + d4) - 1;

{
  |f1| <= 1b-24 /\ |f2| <= 1b-24 /\ |f3| <= 1b-24 /\ |f4| <= 1b-24 /\
  |d1| <= 1b-53 /\ |d2| <= 1b-53 /\ |d3| <= 1b-53 /\ |d4| <= 1b-53
->
  # (3 + 4u) u
  |f_three| <= 50331652b-48 /\
  |d_three| <= 27021597764222980b-106 /\
  # (4 + 7u) u
  |f_four| <= 67108871b-48 /\
  |d_four| <= 36028797018963975b-106
}
