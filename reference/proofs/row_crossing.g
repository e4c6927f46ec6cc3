# Where a row crosses an edge, guessed in double: x = a + q, a = X - offset and q = (y - Y) dx / dy, in
# units of M + 1, M = max |x| over the edge's ends: |a| <= 1, |q| <= 2, |x| <= 1. Of q the three
# differences, the quotient and the product round once each (r3: of dy), then a and the sum; then
# the caller's at +- error, an error of less than 17u. `guess` is how far the guess is off, `end` how
# far an end has moved inwards at most.
# Proves the room of kCrossingErrorMultiplier = 16u (exact/row_edge.h), computed with two roundings,
# and of kCrossingError (library/row_crossing.h): 13u (2^28 + 1) < 2^-21.
# Run: gappa -Eprecision=240 row_crossing.g

five = (1 + r1) * (1 + r2) * (1 + r4) * (1 + r5) / (1 + r3) - 1;
moved = a * s1 + q * five;
guess = moved + s2 * (x + moved);
end = guess + s3 * (x + guess + error);
bound = 16b-53 * ((1 + e1) * (1 + e2));

{
  |a| <= 1 /\ |q| <= 2 /\ |x| <= 1 /\ |error| <= 17b-53 /\
  |r1| <= 1b-53 /\ |r2| <= 1b-53 /\ |r3| <= 1b-53 /\ |r4| <= 1b-53 /\ |r5| <= 1b-53 /\
  |s1| <= 1b-53 /\ |s2| <= 1b-53 /\ |s3| <= 1b-53 /\ |e1| <= 1b-53 /\ |e2| <= 1b-53
->
  |guess| <= 13b-53 /\
  |end| <= 14b-53 /\
  bound >= 15b-53
}
