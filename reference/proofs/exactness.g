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

# Differences, of which Kahan's sign needs no more.
sx = int<ne>(sx_); tx = int<ne>(tx_);

{
  |fx| <= 4096 /\ |fy| <= 4096 /\ |fe| <= 1b24 /\ |fc| <= 1b24 /\
  |ix| <= 46340 /\ |iy| <= 46340 /\
  |dx| <= 94906265 /\ |dy| <= 94906265 /\ |de| <= 1b53 /\ |dc| <= 1b53 /\
  |jx| <= 3037000499 /\ |jy| <= 3037000499 /\
  |ax| <= 2048 /\ |ay| <= 2048 /\ |bx| <= 2048 /\ |by| <= 2048 /\ |px| <= 2048 /\ |py| <= 2048 /\
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
  # differences
  f(sx) - sx in [0, 0] /\ d(tx) - tx in [0, 0]
}
