# Where a row crosses an edge, in steps of fixed point (library/kernels/exact_steps.h), less the
# crossing: what the guess at the edge's first row is off, 14u (2^14 + 1) by kernel_crossing.g with
# u = 2^-53, and its cut to 2^-32; n steps, each cut to 2^-32; the quotient's three roundings,
# which n of them carry to |n slope| <= 2^15; and two cuts to 2^-16, downwards.
# Proves the room of kStepError (library/kernels/crossing_errors.h).
# Run: gappa -Eprecision=240 kernel_steps.g

quotient = (1 + r1) * (1 + r2) / (1 + r3) - 1;
steps = n * cut_step + moved * quotient;
off = guess + cut_guess + steps + cut_start + cut_lane;

{
  |guess| <= 14b-38 /\ |cut_guess| <= 1b-32 /\ n in [0, 16384] /\ |cut_step| <= 1b-32 /\
  |moved| <= 32768 /\ |r1| <= 1b-53 /\ |r2| <= 1b-53 /\ |r3| <= 1b-53 /\
  cut_start in [-1b-16, 0] /\ cut_lane in [-1b-16, 0]
->
  |off| <= 1b-14
}
