# The kernel of clip space in float32: a corner relative to the first pixel of its box is a fused
# difference, a reciprocal and their product, off by `corner` of itself, of at most 9 or 65 pixels.
# That moves where a row crosses an edge of slope s by (1 + s) times as much; then comes what the
# guess from computed corners is off (kernel_crossing.g): guess of 14v (M + 1), and what is cut off.
# A corner's row: its difference from 1/2 rounds once more.
# Proves the numbers of library/kernels/clip_errors.h, v = 2^-24; `tiny`: what underflows.
# Run: gappa -Eprecision=240 clip_floats.g

corner = (1 + a) * (1 + b) * (1 + c) - 1;
slope = s * (1 + d1) * (1 + d2) / (1 + d3);
moves = 1 + slope;
small = (9 * corner + tiny) * moves + small_guess;
near = (65 * corner + tiny) * moves + near_guess;
row = 65 * corner + tiny + 65 * e;

# Larger triangles, in double: a corner's y / w by two roundings, and its difference; a guess at an
# edge's first row, and the steps from there on (kernel_steps.g).
row_in_double = 16385 * ((1 + u1) * (1 + u2) - 1) + 16385 * u3;
stepped = first + steps;

{
  |a| <= 1b-24 /\ |b| <= 1b-24 /\ |c| <= 1b-24 /\ |e| <= 1b-24 /\ |tiny| <= 1b-80 /\
  s in [-32, 32] /\ |d1| <= 1b-24 /\ |d2| <= 1b-24 /\ |d3| <= 1b-24 /\
  |small_guess| <= 1b-15 /\ |near_guess| <= 1b-14 /\
  |u1| <= 1b-53 /\ |u2| <= 1b-53 /\ |u3| <= 1b-53 /\ |first| <= 1b-14 /\ |steps| <= 1b-14
->
  |small| <= 11b-17 /\
  |near| <= 15b-15 /\
  |row| <= 17b-20 /\
  |row_in_double| <= 13b-41 /\
  |stepped| <= 1b-13
}
