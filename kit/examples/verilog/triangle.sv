// A coverage unit: whether a triangle of 12.4 coordinates covers the sample (px, py).
// plugin.cc says how it is built; with -GEDGE_BITS=32 it has one bit less than it needs.
// EDGE_BITS is what `rasterproof widths --fixed 12.4 --target 2048x2048` says of E on the target.
// Sums and products are taken modulo 2^EDGE_BITS, so that E alone has to fit.
module triangle #(
    parameter COORDINATE_BITS = 16,
    parameter SAMPLE_BITS = 17,
    parameter EDGE_BITS = 33
) (
    input signed [COORDINATE_BITS-1:0] ax, ay, bx, by, cx, cy,
    input signed [SAMPLE_BITS-1:0] px, py,  // in 1/16 pixel
    output covers,
    output is_back
);
  // E(a, b; p): the operands are extended to the width of the result.
  function automatic signed [EDGE_BITS-1:0] edge_at(
      input signed [COORDINATE_BITS-1:0] ux, uy, vx, vy, input signed [SAMPLE_BITS-1:0] x, y);
    edge_at = (EDGE_BITS'(x) - EDGE_BITS'(ux)) * (EDGE_BITS'(vy) - EDGE_BITS'(uy)) -
        (EDGE_BITS'(y) - EDGE_BITS'(uy)) * (EDGE_BITS'(vx) - EDGE_BITS'(ux));
  endfunction

  // Whether the sample lies on the inner side, or on an edge that is top or left.
  function automatic is_inside(input signed [EDGE_BITS-1:0] e,
                               input signed [COORDINATE_BITS-1:0] ux, uy, vx, vy);
    is_inside = e > 0 || (e == 0 && (vy > uy || (vy == uy && vx < ux)));
  endfunction

  // The area is E at a vertex; its sign says whether the edges are walked the other way.
  wire signed [EDGE_BITS-1:0] area =
      edge_at(ax, ay, bx, by, SAMPLE_BITS'(cx), SAMPLE_BITS'(cy));
  wire signed [EDGE_BITS-1:0] ab = edge_at(ax, ay, bx, by, px, py);
  wire signed [EDGE_BITS-1:0] bc = edge_at(bx, by, cx, cy, px, py);
  wire signed [EDGE_BITS-1:0] ca = edge_at(cx, cy, ax, ay, px, py);
  wire front = area > 0 && is_inside(ab, ax, ay, bx, by) && is_inside(bc, bx, by, cx, cy) &&
      is_inside(ca, cx, cy, ax, ay);
  wire back = area < 0 && is_inside(-ab, bx, by, ax, ay) && is_inside(-bc, cx, cy, bx, by) &&
      is_inside(-ca, ax, ay, cx, cy);
  assign covers = front || back;
  assign is_back = back;
endmodule
