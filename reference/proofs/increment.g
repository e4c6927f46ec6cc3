# One step of an incremental walk: half an ulp of the binade that the sum lies in, 2^(m - p - 1)
# for |sum| <= 2^m, wherever the binade is; nothing among subnormals and in the binade
# above them (Hauser, ACM TOPLAS 18, 1996).
# SteppingErrorBounds in reference/bounds.h rests on it.
# Run: gappa -Eprecision=240 increment.g

@f = float<ieee_32, ne>;
@d = float<ieee_64, ne>;

fe = f(fe_); fs = f(fs_); f_sum = f(fe + fs);
ge = f(ge_); gs = f(gs_); g_sum = f(ge + gs);
he = f(he_); hs = f(hs_); h_sum = f(he + hs);
de = d(de_); ds = d(ds_); d_sum = d(de + ds);

{
  |fe + fs| <= 1b28 /\ |ge + gs| <= 1b-60 /\ |he + hs| <= 1b-125 /\
  |de + ds| <= 1b28
->
  |f_sum - (fe + fs)| <= 1b3 /\
  |g_sum - (ge + gs)| <= 1b-85 /\
  h_sum - (he + hs) in [0, 0] /\
  |d_sum - (de + ds)| <= 1b-26
}
