# The kernel of clip space in double: N = V_j x V_i is off by one rounding in each component. A fused
# product only rounds less.
# Proves the numbers of library/kernels/clip_errors.h, u = 2^-53.
# Run: gappa -Eprecision=240 clip_kernel.g

# A term of N . (x, y, w): its component, product and two sums; and at least what the sum of sizes is.
dot = (1 + n) * (1 + p) * (1 + s1) * (1 + s2) - 1;
sizes = (1 + n) * (1 + p) * (1 + s3) * (1 + s4);
dot_room = 5b-53 * sizes * (1 + s5);

# The near plane's sum: such a value, the corner's factor, a product and two sums.
near = (1 + n) * (1 + p) * (1 + s1) * (1 + s2) * (1 + r) * (1 + q) * (1 + s6) * (1 + s7) - 1;
near_sizes = (1 + n) * (1 + p) * (1 + s3) * (1 + s4) * (1 + r) * (1 + q) * (1 + s8) * (1 + s9);
near_room = 10b-53 * near_sizes * (1 + s5);

# A guess s y + (f + (1/2 + error)): the quotients s = -ny / nx and f = -nw / nx by a reciprocal;
# then a product and the sum of f, with one sum more of both. sigma, phi: the exact terms, in units
# of the exact |s| y + |f| + 1, which is computed by three roundings of the quotients.
quotient = (1 + n) * (1 + d) * (1 + p) / (1 + m);
by_slope = quotient * (1 + p2) * (1 + c3) - 1;
by_from = quotient * (1 + c2) * (1 + c3) - 1;
by_half = (1 + c1) * (1 + c2) * (1 + c3) - 1;
off = sigma * by_slope + phi * by_from + (0.5 + error) * by_half;
crossing_room = 1b-49 * quotient * (1 + e1) * (1 + e2) * (1 + e3);

# The near plane's crossing: a coefficient is such a sum of a component, the corner's factor, a
# product and two sums. It moves the crossing by as much of what the coefficients' sizes reach, over
# the exact first one: off by kappa of the computed one, for the error is less than 2^-10.
near_coefficient = (1 + n) * (1 + r) * (1 + q) * (1 + s6) * (1 + s7) - 1;
near_moved = near_coefficient / (1 + kappa);
near_crossing_room = 8b-53 * (1 + n) * (1 + r) * (1 + q) * (1 + s3) * (1 + s4) * (1 + s5)
  * (1 + s8) * (1 + p) * (1 + d) * (1 + p2) * (1 + e1) * (1 + e2) * (1 + e3);

# The depth: a coefficient, and its product and two sums; D is off by delta of itself.
depth = (1 + n) * (1 + p) * (1 + s1) * (1 + s2) * (1 + d) * (1 + p2) * (1 + s3) * (1 + s4) - 1;
depth_off = depth / (1 + delta);

{
  |n| <= 1b-53 /\ |m| <= 1b-53 /\ |p| <= 1b-53 /\ |d| <= 1b-53 /\ |p2| <= 1b-53 /\
  |s1| <= 1b-53 /\ |s2| <= 1b-53 /\ |s3| <= 1b-53 /\ |s4| <= 1b-53 /\
  |c1| <= 1b-53 /\ |c2| <= 1b-53 /\ |c3| <= 1b-53 /\
  |e1| <= 1b-53 /\ |e2| <= 1b-53 /\ |e3| <= 1b-53 /\
  |r| <= 1b-53 /\ |q| <= 1b-53 /\ |s5| <= 1b-53 /\ |s6| <= 1b-53 /\ |s7| <= 1b-53 /\
  |s8| <= 1b-53 /\ |s9| <= 1b-53 /\ |delta| <= 1b-24 /\ |kappa| <= 1b-10 /\
  |sigma| <= 1 /\ |phi| <= 1 /\ error in [0, 1b-10]
->
  |dot| <= 4199b-63 /\
  dot_room >= 39b-56 /\
  |off| <= 237b-57 /\
  crossing_room >= 127b-56 /\
  |near| <= 8295b-63 /\
  near_room >= 79b-56 /\
  |near_coefficient| <= 5131b-63 /\
  |near_moved| <= 5140b-63 /\
  near_crossing_room >= 8180b-63 /\
  |depth| <= 8295b-63 /\
  |depth_off| <= 8296b-63
}
