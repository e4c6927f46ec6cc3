# (1 - l0) - l1 inside a triangle: both differences lie in [0, 1].
# Proves kOneMinusSumError (reference/barycentrics.h). Run: gappa -Eprecision=240 barycentrics_one_minus.g

@f = float<ieee_32, ne>;
@d = float<ieee_64, ne>;

f0 = f(f0_); f1 = f(f1_);
f_left = f(1 - f0);
f_before = f_left - f1;
f2 = f(f_before);
f_sum = f2 - (1 - f0 - f1);

d0 = d(d0_); d1 = d(d1_);
d_left = d(1 - d0);
d_before = d_left - d1;
d2 = d(d_before);
d_sum = d2 - (1 - d0 - d1);

{
  f0 in [0, 1] /\ f1 in [0, 1] /\ f_before in [0, 1] /\
  d0 in [0, 1] /\ d1 in [0, 1] /\ d_before in [0, 1]
->
  |f_sum| <= 1b-24 /\
  |d_sum| <= 1b-53
}

# What the two roundings leave is split off.
f_sum -> (f2 - f_before) + (f_left - (1 - f0));
d_sum -> (d2 - d_before) + (d_left - (1 - d0));
