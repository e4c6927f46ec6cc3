# The column where E changes side, guessed in double (reference/plan_kernel.h): the reciprocal of
# E's step, the difference and their product round once each, and so does adding the bias to at
# most 2^16 + 1 columns. The guess is off by at most 2^-34: a bias of 2^-33 puts a crossing that is
# a column beyond it, and leaves one that is at least 2^-31 away on its side.
# Run: gappa -Eprecision=240 crossing.g

@d = float<ieee_64, ne>;

guess = column * ((1 + r1) * (1 + r2) * (1 + r3));
biased = d(guess + 1 - 1b-33);
off = (guess - column) + (biased - (guess + 1 - 1b-33));

{
  |column| <= 65537 /\ |r1| <= 1b-53 /\ |r2| <= 1b-53 /\ |r3| <= 1b-53
->
  |guess - column| <= 1b-35 /\
  |off| <= 1b-34
}

guess - column -> column * ((1 + r1) * (1 + r2) * (1 + r3) - 1);
