# Barycentrics over the sum of three edge values of one sign, scaled so that the computed sum s is in
# [1, 2): r = e0 + e1 + a and s = r + e2 + b with roundings a and b, v = 1 / s, q_i = e_i v. The sum of
# the rounded q_i less 1 is -(a + b) v and the roundings of the q_i.
# few:  r < 1, so |a| <= u / 2; each quotient rounds by u of itself.
# many: r >= 1, one quotient is at least 1/2: half ulps h0 and h1. q_2 is k (1 - v (1 + b)), k in [0, 1],
#       for e2 <= s - 1 - b. The error is affine in v, and here are both ends of [1/2, 1].
# half: r >= 1 and q_0, q_1 >= 1/2. One of them is 1/2 and exact, and e2 <= 2u (docs/mathematics.md, 9).
# Proves the number of kNormalizedSumErrorMultiplier (reference/barycentrics.h).
# Run: gappa -Eprecision=240 barycentrics_sum.g

f_few = (1 - (fa / 2 + fb) * fv) * fd - (fa / 2 + fb) * fv;
f_many_1 = h0 * 1b-25 + h1 * 1b-26 - (fa + fb) - fk * fb * fd;
f_many_2 = h0 * 1b-25 + h1 * 1b-26 - (fa + fb) / 2 + fk * ((1 - fb) / 2) * fd;
f_half = h0 * 1b-25 + fe2 * fv * fd - (fa + fb) * fv;

d_few = (1 - (da / 2 + db) * dv) * dd - (da / 2 + db) * dv;
d_many_1 = h0 * 1b-54 + h1 * 1b-55 - (da + db) - dk * db * dd;
d_many_2 = h0 * 1b-54 + h1 * 1b-55 - (da + db) / 2 + dk * ((1 - db) / 2) * dd;
d_half = h0 * 1b-54 + de2 * dv * dd - (da + db) * dv;

{
  |h0| <= 1 /\ |h1| <= 1 /\
  |fa| <= 1b-24 /\ |fb| <= 1b-24 /\ |fd| <= 1b-24 /\
  fv in [0.5, 1] /\ fk in [0, 1] /\ fe2 in [0, 1b-23] /\
  |da| <= 1b-53 /\ |db| <= 1b-53 /\ |dd| <= 1b-53 /\
  dv in [0.5, 1] /\ dk in [0, 1] /\ de2 in [0, 1b-52]
->
  # (11/4 + 4u) u
  |f_few| <= 46137348b-48 /\
  |f_many_1| <= 46137348b-48 /\
  |f_many_2| <= 46137348b-48 /\
  |f_half| <= 46137348b-48 /\
  |d_few| <= 24769797950537732b-106 /\
  |d_many_1| <= 24769797950537732b-106 /\
  |d_many_2| <= 24769797950537732b-106 /\
  |d_half| <= 24769797950537732b-106
}
