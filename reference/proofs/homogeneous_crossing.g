# Where a row crosses an edge of (x, y, w) vertices, guessed in double: -(ny y + nw) / nx - offset, in
# units of T / |nx| + 1, T = |ny y| + |nw|. The normals are off by 2u (Kahan); a term of the numerator
# carries that, its product and the sum. c = the exact quotient. Then nx, the quotient, the
# difference with the offset, and the caller's at +- error, an error of less than 17u.
# Proves the room of kHomogeneousCrossingErrorMultiplier = 16u (exact/homogeneous_crossing.h),
# computed with at most seven roundings of T / |nx| + 1, of its normals' 2u each, and one product.
# Run: gappa -Eprecision=240 homogeneous_crossing.g

numerator = (1 + n) * (1 + p) * (1 + s) - 1;    # of T
divided = (1 + d) / (1 + m) - 1;
moved = c * divided + numerator * (1 + divided);
guess = moved + s2 * (x + moved);
end = guess + s3 * (x + guess + error);
bound = 16b-53 * ((1 + n) * (1 + e1) * (1 + e2) * (1 + e3) * (1 + e4) * (1 + e5) / (1 + m));

{
  |c| <= 1 /\ |x| <= 1 /\ |error| <= 17b-53 /\
  |n| <= 1b-52 /\ |m| <= 1b-52 /\ |p| <= 1b-53 /\ |s| <= 1b-53 /\ |d| <= 1b-53 /\
  |s2| <= 1b-53 /\ |s3| <= 1b-53 /\
  |e1| <= 1b-53 /\ |e2| <= 1b-53 /\ |e3| <= 1b-53 /\ |e4| <= 1b-53 /\ |e5| <= 1b-53
->
  |guess| <= 9b-53 /\
  |end| <= 10b-53 /\
  bound >= 15b-53
}
