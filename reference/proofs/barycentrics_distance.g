# A barycentric times a height: the quotient by the area, the product with the area over the side, and
# the last product round once each; the area itself cancels.
# Proves the number of kEdgeDistanceErrorMultiplier (reference/barycentrics.h).
# Run: gappa -Eprecision=240 barycentrics_distance.g

f_three = (1 + f1) * (1 + f2) * (1 + f3) - 1;
d_three = (1 + d1) * (1 + d2) * (1 + d3) - 1;

{
  |f1| <= 1b-24 /\ |f2| <= 1b-24 /\ |f3| <= 1b-24 /\
  |d1| <= 1b-53 /\ |d2| <= 1b-53 /\ |d3| <= 1b-53
->
  # (3 + 4u) u
  |f_three| <= 50331652b-48 /\
  |d_three| <= 27021597764222980b-106
}
