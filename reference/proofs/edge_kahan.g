# Kahan's difference of products on four rounded differences a, b, c, d; w = fl(cd) = cd (1 - ew),
# f = (ab - w)(1 + e1), the result (f - (cd - w))(1 + e2), D = ab - cd:
#   result - D = (e1 + e2 + e1 e2) D + (e1 ew + e1 e2 ew) cd.
# Proves the numbers of kKahanEdgeErrorMultiplier and kKahanEdgeRelError (reference/bounds.h).
# Run: gappa -Eprecision=240 edge_kahan.g

f_sum = (1 + f_a) * (1 + f_b) - 1;                       # D - E, of S
f_relative = f_e1 + f_e2 + f_e1 * f_e2;              # of D
f_cd = (f_e1 * f_ew + f_e1 * f_e2 * f_ew) * ((1 + f_a) * (1 + f_b));  # of S
f_all = f_sum + f_relative * f_sum + f_cd;           # of S, with D = E + sum S

d_sum = (1 + d_a) * (1 + d_b) - 1;                       # D - E, of S
d_relative = d_e1 + d_e2 + d_e1 * d_e2;              # of D
d_cd = (d_e1 * d_ew + d_e1 * d_e2 * d_ew) * ((1 + d_a) * (1 + d_b));  # of S
d_all = d_sum + d_relative * d_sum + d_cd;           # of S, with D = E + sum S

{
  |f_e1| <= 1b-24 /\ |f_e2| <= 1b-24 /\ |f_ew| <= 1b-24 /\
  |f_a| <= 1b-24 /\ |f_b| <= 1b-24 /\
  |d_e1| <= 1b-53 /\ |d_e2| <= 1b-53 /\ |d_ew| <= 1b-53 /\
  |d_a| <= 1b-53 /\ |d_b| <= 1b-53
->
  # (2 + u) u
  |f_relative| <= 33554433b-48 /\
  |d_relative| <= 18014398509481985b-106 /\
  # (2 + 7u) u
  |f_all| <= 33554439b-48 /\
  |d_all| <= 18014398509481991b-106
}
