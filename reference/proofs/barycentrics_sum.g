# Barycentrics over the sum of three edge values of one sign: the two sums leave s = (sum e_i)(1 + t),
# 1 + t a convex combination of (1 + 1)(1 + 2) and (1 + 2); the quotients average to 1 / (1 + t)
# times a convex combination of their own roundings (1 + 3).
# Proves the number of kNormalizedSumErrorMultiplier (reference/barycentrics.h).
# Run: gappa -Eprecision=240 barycentrics_sum.g

f_sum = (1 + f3) / ((1 + f1) * (1 + f2)) - 1;
d_sum = (1 + d3) / ((1 + d1) * (1 + d2)) - 1;

{
  |f1| <= 1b-24 /\ |f2| <= 1b-24 /\ |f3| <= 1b-24 /\
  |d1| <= 1b-53 /\ |d2| <= 1b-53 /\ |d3| <= 1b-53
->
  # (3 + 8u) u
  |f_sum| <= 50331656b-48 /\
  |d_sum| <= 27021597764222984b-106
}
