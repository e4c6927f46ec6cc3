# The library's correctly rounded values (library/kernels/value_errors.h): a line whose products
# carry 10 roundings over its reach, which carries as many; a quotient by an estimate r of 14 bits,
# h = 1 - d r, and n / d = n r / (1 - h); n / d over the quotient, n and d off by 2^-41 each.
# Proves kLineError, kQuotientError and kQuickDoubt.
# Run: gappa -Eprecision=240 library_nearest.g

line = ((1 + d1) * (1 + d2) * (1 + d3) * (1 + d4) * (1 + d5) * (1 + d6) * (1 + d7) * (1 + d8) *
    (1 + d9) * (1 + d10) - 1) / ((1 + e1) * (1 + e2) * (1 + e3) * (1 + e4) * (1 + e5) * (1 + e6) *
    (1 + e7) * (1 + e8) * (1 + e9) * (1 + e10));
g = h * (1 + d1);
t = (g + g * g) * (1 + d2);
core = (1 + t) * (1 - h) - 1;
quotient = (1 + core) * (1 + d3) * (1 + d4) - 1;
exact = 1 + n;
shown = (1 + d) * (1 + q);
told = (exact - shown) / shown;

{
  |d1| <= 1b-53 /\ |d2| <= 1b-53 /\ |d3| <= 1b-53 /\ |d4| <= 1b-53 /\ |d5| <= 1b-53 /\
  |d6| <= 1b-53 /\ |d7| <= 1b-53 /\ |d8| <= 1b-53 /\ |d9| <= 1b-53 /\ |d10| <= 1b-53 /\
  |e1| <= 1b-53 /\ |e2| <= 1b-53 /\ |e3| <= 1b-53 /\ |e4| <= 1b-53 /\ |e5| <= 1b-53 /\
  |e6| <= 1b-53 /\ |e7| <= 1b-53 /\ |e8| <= 1b-53 /\ |e9| <= 1b-53 /\ |e10| <= 1b-53 /\
  |h| <= 1b-14 /\ |n| <= 1b-41 /\ |d| <= 1b-41 /\ |q| <= 1b-41
->
  # kLineError
  |line| <= 11b-53 /\
  # kQuotientError
  |quotient| <= 1b-41 /\
  # kQuickDoubt - 2
  |told| <= 16382b-53
}

# g - h = h d1, and (1 + h + h^2) (1 - h) = 1 - h^3.
core -> h * d1 * (1 + g + h) * (1 - h) + (g + g * g) * d2 * (1 - h) - h * h * h;
exact - shown -> (n - d) - q * (1 + d);
