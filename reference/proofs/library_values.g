# The library's values: n/d with at most 4 roundings in each product of n and of d, and the quotient
# rounded last, as value_methods.g has k of them; e1 and e2: what planes found in double are off.
# Proves kValueConditions (library/rasterize.h).
# Run: gappa -Eprecision=240 library_values.g

f_n = ((1 + f1) * (1 + f2) * (1 + f3) * (1 + f4) * (1 + e1) - 1) * (1 + fr);
f_d = ((1 + f1) * (1 + f2) * (1 + f3) * (1 + f4) * (1 + e2) - 1) * (1 + fr) + fr;

{
  |f1| <= 1b-24 /\ |f2| <= 1b-24 /\ |f3| <= 1b-24 /\ |f4| <= 1b-24 /\ |fr| <= 1b-24 /\
  |e1| <= 1b-50 /\ |e2| <= 1b-50
->
  # (5 + 2^-16) u
  |f_n| <= 327681b-40 /\
  |f_d| <= 327681b-40
}
