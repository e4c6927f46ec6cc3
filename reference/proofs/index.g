# The index form: a whole number of pixels times the step, fused with the start, is one rounding,
# however many pixels. A product of an integer and a float never underflows. (SteppingErrorBounds,
# reference/bounds.h.) Run: gappa -Eprecision=240 index.g

@f = float<ieee_32, ne>;
@d = float<ieee_64, ne>;

fn = int<ne>(fn_); fs = f(fs_); fe = f(fe_);
f_exact = fn * fs + fe;
f_index = f(f_exact);
f_product = f(fn * fs);

dn = int<ne>(dn_); ds = d(ds_); de = d(de_);
d_exact = dn * ds + de;
d_index = d(d_exact);
d_product = d(dn * ds);

{
  @FIX(fs, -149) /\ @FIX(fe, -149) /\ @FIX(ds, -1074) /\ @FIX(de, -1074)
->
  |f_index -/ f_exact| <= 1b-24 /\
  |f_product -/ (fn * fs)| <= 1b-24 /\
  |d_index -/ d_exact| <= 1b-53 /\
  |d_product -/ (dn * ds)| <= 1b-53
}
