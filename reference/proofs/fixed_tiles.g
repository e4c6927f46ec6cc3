# Integers of fixed-tiles (library/rivals/fixed_tiles.h): vertices v within 2^22 units of 1/256
# px, centres p of a target of 65536 px; a = A and b = B of an edge; f = floor(E / 256) at a pixel.
# Where doubles hold them they are exact, where int32 does they do not overflow.
# Run: gappa -Eprecision=240 fixed_tiles.g

@d = float<ieee_64, ne>;

px = int<ne>(px_); py = int<ne>(py_); vx = int<ne>(vx_); vy = int<ne>(vy_);
a = int<ne>(a_); b = int<ne>(b_);
along_x = (px - vx) * a; along_y = (py - vy) * b;
e = along_x + along_y;
f = int<dn>((e - 1) / 256);

# What the values in the tiles of a box are compared with to find whether they fit in 30 bits.
w = int<ne>(w_); h = int<ne>(h_); fa = int<ne>(fa_); aa = int<ne>(aa_); ab = int<ne>(ab_);
across = aa * w; down = ab * h;
most = fa + across + down;

# In a tile, 32 bits: a value of 30, and what it changes by over 7 columns and 7 rows.
t = int<ne>(t_); i = int<ne>(i_); j = int<ne>(j_);
offset = i * a + j * b;

{
  px in [128, 16777088] /\ py in [128, 16777088] /\ |vx| <= 4194304 /\ |vy| <= 4194304 /\
  |a| <= 8388608 /\ |b| <= 8388608 /\
  fa in [0, 1374390362113] /\ aa in [0, 8388608] /\ ab in [0, 8388608] /\
  w in [0, 65672] /\ h in [0, 65552] /\
  |t| <= 1073741824 /\ i in [0, 7] /\ j in [0, 7]
->
  # int32
  |px - vx| <= 20971392 /\ |py - vy| <= 20971392 /\
  # float64: the products, E and its floor
  d(along_x) - along_x in [0, 0] /\ d(along_y) - along_y in [0, 0] /\ d(e) - e in [0, 0] /\
  |e| <= 351841573404672 /\ |f| <= 1374381146113 /\
  d(across) - across in [0, 0] /\ d(down) - down in [0, 0] /\ d(most) - most in [0, 0] /\
  # int32: the pixels of a tile
  |offset| <= 117440512 /\ |t + offset| <= 1191182336
}
