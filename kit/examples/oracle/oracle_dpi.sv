// The oracle in a simulation, by DPI-C:
//
//     $ verilator --binary oracle_dpi.sv -LDFLAGS -lrasterproof_oracle && obj_dir/Voracle_dpi
//
// A unit that owns top-left edges in integers of 8 fraction bits is compared with what every legal
// rasterizer must and may do. With +inclusive it owns every edge, and is convicted.
module oracle_dpi;
  import "DPI-C" function int rasterproof_oracle_open(input string text, output chandle profile);
  import "DPI-C" function string rasterproof_oracle_message();
  import "DPI-C" function int rasterproof_oracle_covers(
    input chandle profile, input int width, input int height,
    input real x0, input real y0, input real x1, input real y1, input real x2, input real y2,
    input int column, input int row, input int s);

  localparam int Side = 8;

  bit is_inclusive = $test$plusargs("inclusive") != 0;

  // Whether (x, y) is on the inner side of the edge from a to b, in 1/256 of a pixel; y is down.
  function automatic bit owns(input longint ax, ay, bx, by, x, y);
    longint e = (x - ax) * (by - ay) - (y - ay) * (bx - ax);
    return e < 0 || (e == 0 && (is_inclusive || by < ay || (by == ay && bx > ax)));
  endfunction

  chandle gl;
  int wrong = 0;
  initial begin
    longint px[3] = '{128, 1664, 128}, py[3] = '{128, 128, 1664};  // (0.5, 0.5) (6.5, 0.5) (0.5, 6.5)
    if (rasterproof_oracle_open("gl-canonical", gl) != 0) $fatal(2, rasterproof_oracle_message());
    for (int row = 0; row < Side; ++row)
      for (int column = 0; column < Side; ++column) begin
        longint x = 256 * longint'(column) + 128, y = 256 * longint'(row) + 128;
        bit mine = owns(px[0], py[0], px[1], py[1], x, y) &&
                   owns(px[1], py[1], px[2], py[2], x, y) &&
                   owns(px[2], py[2], px[0], py[0], x, y);
        int legal = rasterproof_oracle_covers(gl, Side, Side, px[0] / 256.0, py[0] / 256.0,
                                              px[1] / 256.0, py[1] / 256.0, px[2] / 256.0,
                                              py[2] / 256.0, column, row, 0);
        if (legal < 0) $fatal(2, rasterproof_oracle_message());
        if (legal != 2 && legal != int'(mine)) begin
          $display("column %0d row %0d: %s", column, row, mine ? "covered" : "not covered");
          ++wrong;
        end
      end
    if (wrong != 0) $fatal(1, "%0d samples contradict every legal rasterizer", wrong);
    $display("no contradiction in %0d samples", Side * Side);
    $finish;
  end
endmodule
