// Judges a rasterizer of whole numbers by vectors: 8 subpixel bits, one sample, y down.
//   rasterproof vectors generate --profile P --format readmemh --out FOLDER
//   cd FOLDER && iverilog -g2012 -I . -o reader .../reader.sv && vvp reader
// or, by Verilator 5 (tried with 5.006):
//   cd FOLDER && verilator --binary -Wno-WIDTH -I. --top reader .../reader.sv && obj_dir/Vreader
// -P reader.INCLUSIVE=1, or -GINCLUSIVE=1 for Verilator: a wrong tie rule, which is convicted.
`include "vectors.svh"

module reader;
  parameter INCLUSIVE = 0;
  reg [31:0] cases[0:VECTORS_CASES * cases_COLUMNS - 1];
  reg [31:0] vertices[0:VECTORS_VERTICES * vertices_COLUMNS - 1];
  reg [31:0] triangles[0:VECTORS_TRIANGLES * triangles_COLUMNS - 1];
  reg [31:0] joints[0:(VECTORS_JOINTS == 0 ? 1 : VECTORS_JOINTS * joints_COLUMNS) - 1];
  reg [VECTORS_ROW_BITS - 1:0] must[0:VECTORS_ROWS - 1];
  reg [VECTORS_ROW_BITS - 1:0] may[0:VECTORS_ROWS - 1];

  integer n, c, t, x, y, j, k, row, first, count, wrong;

  // The reader: load, compare, say what contradicts.
  initial begin
    wrong = 0;
    load;
    for (n = 0; n < VECTORS_CASES; n = n + 1) begin
      c = n * cases_COLUMNS;
      first = cases[c + cases_first_triangle];
      for (t = first; t < first + cases[c + cases_triangles]; t = t + 1) judge_triangle;
      for (j = 0; j < cases[c + cases_joints]; j = j + 1) judge_joint;
    end
    if (wrong != 0) $display("%0d contradictions in %0d cases", wrong, VECTORS_CASES);
    else $display("no contradiction in %0d cases", VECTORS_CASES);
    $finish;
  end

  task load;
    begin
      if (VECTORS_VERSION != 1 || VECTORS_LATTICE_BITS != 8 || VECTORS_Y_UP != 0) $fatal(1);
      $readmemh("cases.hex", cases);
      $readmemh("vertices.hex", vertices);
      $readmemh("triangles.hex", triangles);
      $readmemh("joints.hex", joints);
      $readmemh("must.hex", must);
      $readmemh("may.hex", may);
    end
  endtask

  task judge_triangle;
    for (y = 0; y < cases[c + cases_height]; y = y + 1)
      for (x = 0; x < cases[c + cases_width]; x = x + 1) begin
        row = triangles[t * triangles_COLUMNS + triangles_first_row] + y;
        if (!may[row][x] && covers(t, x, y) != must[row][x]) begin
          $display("case %0d triangle %0d column %0d row %0d: must%s be covered", n, t - first, x,
                   y, must[row][x] ? "" : " not");
          wrong = wrong + 1;
        end
      end
  endtask

  task judge_joint;
    begin
      k = (cases[c + cases_first_joint] + j) * joints_COLUMNS;
      x = joints[k + joints_column];
      y = joints[k + joints_row];
      count = 0;
      for (t = 0; t < cases[c + cases_triangles]; t = t + 1)
        if (joints[k + joints_triangles][t] && covers(first + t, x, y)) count = count + 1;
      if (!joints[k + joints_counts][count]) begin
        $display("case %0d column %0d row %0d: %0d triangles cover it", n, x, y, count);
        wrong = wrong + 1;
      end
    end
  endtask

  // Your rasterizer in place of this one. All numbers in 1/256 pixel; the rule is top-left.

  // E(a, b; x, y): products of the largest coordinates have 66 bits.
  function automatic signed [71:0] edge_at(input signed [71:0] ax, input signed [71:0] ay,
                                           input signed [71:0] bx, input signed [71:0] by,
                                           input signed [71:0] x, input signed [71:0] y);
    edge_at = (x - ax) * (by - ay) - (y - ay) * (bx - ax);
  endfunction

  // Whether the sample lies on the inner side of a -> b, or on it and the edge owns it.
  function automatic is_inside(input signed [71:0] ax, input signed [71:0] ay,
                               input signed [71:0] bx, input signed [71:0] by,
                               input signed [71:0] x, input signed [71:0] y);
    reg signed [71:0] e;
    e = edge_at(ax, ay, bx, by, x, y);
    is_inside = e > 0 ||
        (e == 0 && (INCLUSIVE != 0 || by > ay || (by == ay && bx < ax)));
  endfunction

  // Whether triangle t of the file covers the sample.
  function automatic covers(input integer t, input integer column, input integer row);
    reg signed [31:0] ax, ay, bx, by, cx, cy;
    reg signed [71:0] area;
    integer x, y, k;
    k = t * triangles_COLUMNS;
    ax = vertices[2 * triangles[k]];
    ay = vertices[2 * triangles[k] + 1];
    bx = vertices[2 * triangles[k + 1]];
    by = vertices[2 * triangles[k + 1] + 1];
    cx = vertices[2 * triangles[k + 2]];
    cy = vertices[2 * triangles[k + 2] + 1];
    x = 256 * column + 128;
    y = 256 * row + 128;
    area = edge_at(ax, ay, bx, by, cx, cy);
    if (area > 0)
      covers = is_inside(ax, ay, bx, by, x, y) && is_inside(bx, by, cx, cy, x, y) &&
               is_inside(cx, cy, ax, ay, x, y);
    else
      covers = area != 0 && is_inside(ax, ay, cx, cy, x, y) &&
               is_inside(cx, cy, bx, by, x, y) && is_inside(bx, by, ax, ay, x, y);
  endfunction
endmodule
