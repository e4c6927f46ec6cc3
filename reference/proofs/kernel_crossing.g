# Where a row crosses an edge, guessed in float32 by the exact kernel: x = a + q, a the corner's x plus
# offset and q = (y - Y) dx / dy, in units of M + 1, M = max |x| over the edge's ends: |a| <= 1,
# |q| <= 2, |x| <= 1. Of q the three differences, the quotient and the product round once each (r3:
# of dy; the product not at all where it is fused), then a and the sum. Y may be either end's.
# Proves the room of kNearCrossingError, 14u (65 + 1) < 2^-14, and of kSmallCrossingError, 2^-15 for
# 14u (9 + 1) and what is cut off below 2^-16 (library/kernels/crossing_errors.h). That of kCrossingError, in double, is
# row_crossing.g's: 13u (2^26 + 1) < 2^-22.
# Run: gappa -Eprecision=240 kernel_crossing.g

five = (1 + r1) * (1 + r2) * (1 + r4) * (1 + r5) / (1 + r3) - 1;
moved = a * s1 + q * five;
guess = moved + s2 * (x + moved);
near = 66 * guess;
small = 10 * guess + cut;

{
  |a| <= 1 /\ |q| <= 2 /\ |x| <= 1 /\
  |r1| <= 1b-24 /\ |r2| <= 1b-24 /\ |r3| <= 1b-24 /\ |r4| <= 1b-24 /\ |r5| <= 1b-24 /\
  |s1| <= 1b-24 /\ |s2| <= 1b-24 /\
  cut in [-1b-16, 0]
->
  |guess| <= 14b-24 /\
  |near| <= 1b-14 /\
  |small| <= 1b-15
}
