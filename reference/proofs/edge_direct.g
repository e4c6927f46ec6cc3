# The direct form: a product of two rounded differences, rounded, and the last subtraction.
# Proves the numbers of kDirectEdgeErrorMultiplier and kDirectFmaEdgeErrorMultiplier
# (reference/bounds.h). Run: gappa -Eprecision=240 edge_direct.g

@f = float<ieee_32, ne>;
@d = float<ieee_64, ne>;

# Float32 coordinates on a lattice of 2^-74: a product of differences is a multiple of 2^-148.
fp = f(fp_); fa = f(fa_); fb = f(fb_); fc = f(fc_);
f_product f= (fp - fa) * (fb - fc);
f_exact = (fp - fa) * (fb - fc);

# Float64 coordinates on a lattice of 2^-537.
dp = d(dp_); da = d(da_); db = d(db_); dc = d(dc_);
d_product d= (dp - da) * (db - dc);
d_exact = (dp - da) * (db - dc);

# The last rounding: (E + r S)(1 + e) - E - e E = r (1 + e) S.
f_last = f_r * (1 + f_e);
d_last = d_r * (1 + d_e);

{
  @FIX(fp, -74) /\ @FIX(fa, -74) /\ @FIX(fb, -74) /\ @FIX(fc, -74) /\
  @FIX(dp, -537) /\ @FIX(da, -537) /\ @FIX(db, -537) /\ @FIX(dc, -537) /\
  |f_r| <= 50331652b-48 /\ |f_e| <= 1b-24 /\
  |d_r| <= 27021597764222980b-106 /\ |d_e| <= 1b-53
->
  # (3 + 4u) u
  |f_product -/ f_exact| <= 50331652b-48 /\
  |d_product -/ d_exact| <= 27021597764222980b-106 /\
  # (3 + 8u) u
  |f_last| <= 50331656b-48 /\
  |d_last| <= 27021597764222984b-106
}
