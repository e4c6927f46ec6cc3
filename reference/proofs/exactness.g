# Direct forms of exactness.h, and the two integers that a plan chooses from (reference/plan.cc): in
# lattice units every coordinate is an integer, and with box sides up to the limits below the differences, the products and E itself
# (at most the box's area in size) are exact. Each limit is the largest integer whose square fits.
# Run: gappa -Eprecision=240 exactness.g

@f = float<ieee_32, ne>;
@d = float<ieee_64, ne>;

fx = int<ne>(fx_); fy = int<ne>(fy_); fe = int<ne>(fe_); fc = int<ne>(fc_);
dx = int<ne>(dx_); dy = int<ne>(dy_); de = int<ne>(de_); dc = int<ne>(dc_);
f_product = f(fx * fy) - fx * fy;
d_product = d(dx * dy) - dx * dy;

# The affine form of coordinates up to 2048: A p.x + B p.y + C, each operation on integers.
ax = int<ne>(ax_); ay = int<ne>(ay_); bx = int<ne>(bx_); by = int<ne>(by_);
px = int<ne>(px_); py = int<ne>(py_);
line_x = (by - ay) * px; line_y = (ax - bx) * py;
cross_a = bx * ay; cross_b = ax * by;

# The homogeneous form of whole x, y, w and p: N = V_j x V_i, n_x p.x + n_y p.y + n_w p.w. Components
# of N are differences of two products; all are bounded alike, so one of each kind stands for them.
ha = int<ne>(ha_); hb = int<ne>(hb_); hc = int<ne>(hc_); hd = int<ne>(hd_);
hp = int<ne>(hp_); hq = int<ne>(hq_); he = int<ne>(he_);
ga = int<ne>(ga_); gb = int<ne>(gb_); gc = int<ne>(gc_); gd = int<ne>(gd_);
gp = int<ne>(gp_); gq = int<ne>(gq_); ge = int<ne>(ge_);
h_minor = ha * hb - hc * hd; h_other = ha * hc - hb * hd;
g_minor = ga * gb - gc * gd; g_other = ga * gc - gb * gd;
h_sum = h_minor * hp + h_other * hq;
g_sum = g_minor * gp + g_other * gq;

# Differences, of which Kahan's sign needs no more.
sx = int<ne>(sx_); tx = int<ne>(tx_);

{
  |fx| <= 4096 /\ |fy| <= 4096 /\ |fe| <= 1b24 /\ |fc| <= 1b24 /\
  |ix| <= 46340 /\ |iy| <= 46340 /\
  |dx| <= 94906265 /\ |dy| <= 94906265 /\ |de| <= 1b53 /\ |dc| <= 1b53 /\
  |jx| <= 3037000499 /\ |jy| <= 3037000499 /\
  |ax| <= 2048 /\ |ay| <= 2048 /\ |bx| <= 2048 /\ |by| <= 2048 /\ |px| <= 2048 /\ |py| <= 2048 /\
  |ha| <= 161 /\ |hb| <= 161 /\ |hc| <= 161 /\ |hd| <= 161 /\ |hp| <= 161 /\ |hq| <= 161 /\
  |he| <= 16693124 /\
  |ga| <= 1b17 /\ |gb| <= 1b17 /\ |gc| <= 1b17 /\ |gd| <= 1b17 /\ |gp| <= 1b17 /\ |gq| <= 1b17 /\
  |ge| <= 1b53 /\
  |sx| <= 1b24 /\ |tx| <= 1b53
->
  # float32 direct: 4096^2 = 2^24
  f_product in [0, 0] /\ f(fe) - fe in [0, 0] /\ f(fc) - fc in [0, 0] /\
  # int32 direct: 46340^2 <= 2^31 - 1
  |ix * iy| <= 2147483647 /\
  # float64 direct: 94906265^2 <= 2^53
  d_product in [0, 0] /\ d(de) - de in [0, 0] /\ d(dc) - dc in [0, 0] /\
  # int64 direct: 3037000499^2 <= 2^63 - 2^10
  |jx * jy| <= 9223372036854774784 /\
  # float32 affine: but for the last sum, which is E
  f(by - ay) - (by - ay) in [0, 0] /\ f(line_x) - line_x in [0, 0] /\
  f(line_x + line_y) - (line_x + line_y) in [0, 0] /\
  f(cross_a) - cross_a in [0, 0] /\ f(cross_a - cross_b) - (cross_a - cross_b) in [0, 0] /\
  # homogeneous, float32 (161) and float64 (2^17): but for the last sum, a determinant of at most 4 N^3
  f(ha * hb) - ha * hb in [0, 0] /\ f(h_minor) - h_minor in [0, 0] /\
  f(h_minor * hp) - h_minor * hp in [0, 0] /\ f(h_sum) - h_sum in [0, 0] /\ f(he) - he in [0, 0] /\
  d(ga * gb) - ga * gb in [0, 0] /\ d(g_minor) - g_minor in [0, 0] /\
  d(g_minor * gp) - g_minor * gp in [0, 0] /\ d(g_sum) - g_sum in [0, 0] /\ d(ge) - ge in [0, 0] /\
  # differences
  f(sx) - sx in [0, 0] /\ d(tx) - tx in [0, 0]
}
