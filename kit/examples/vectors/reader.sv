// Judges a rasterizer of whole numbers by vectors, with their subpixel bits and samples, y down.
//   rasterproof vectors generate --profile P --format readmemh --out FOLDER
//   cd FOLDER && iverilog -g2012 -I . -o reader .../reader.sv && vvp reader
// or, by Verilator 5 (tried with 5.006):
//   cd FOLDER && verilator --binary -Wno-WIDTH -I. --top reader .../reader.sv && obj_dir/Vreader
// -P reader.INCLUSIVE=1, or -GINCLUSIVE=1 for Verilator: a wrong tie rule, which is convicted.
`include "vectors.svh"

module reader;
  parameter INCLUSIVE = 0;
  reg [31:0] cases[0:VECTORS_CASES * cases_COLUMNS - 1];
  reg [31:0] locations[0:VECTORS_LOCATIONS * locations_COLUMNS - 1];
  reg [31:0] vertices[0:VECTORS_VERTICES * vertices_COLUMNS - 1];
  reg [31:0] triangles[0:VECTORS_TRIANGLES * triangles_COLUMNS - 1];
  reg [31:0] joints[0:(VECTORS_JOINTS == 0 ? 1 : VECTORS_JOINTS * joints_COLUMNS) - 1];
  reg [VECTORS_ROW_BITS - 1:0] must[0:VECTORS_ROWS - 1];
  reg [VECTORS_ROW_BITS - 1:0] may[0:VECTORS_ROWS - 1];

  integer n, c, t, x, y, s, j, k, row, bit_at, first, count, wrong;

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
      if (VECTORS_VERSION != 1) $fatal(1, "vectors of another version than 1");
      if (VECTORS_Y_UP != 0) $fatal(1, "y points up, and this rasterizer's points down");
      $readmemh("cases.hex", cases);
      $readmemh("locations.hex", locations);
      $readmemh("vertices.hex", vertices);
      $readmemh("triangles.hex", triangles);
      $readmemh("joints.hex", joints);
      $readmemh("must.hex", must);
      $readmemh("may.hex", may);
    end
  endtask

  task judge_triangle;
    for (y = 0; y < cases[c + cases_height]; y = y + 1)
      for (x = 0; x < cases[c + cases_width]; x = x + 1)
        for (s = 0; s < cases[c + cases_samples]; s = s + 1) begin
          row = triangles[t * triangles_COLUMNS + triangles_first_row] + y;
          bit_at = x * cases[c + cases_samples] + s;
          if (!may[row][bit_at] && covers(t, x, y, s) != must[row][bit_at]) begin
            $display("case %0d triangle %0d column %0d row %0d sample %0d: must%s be covered", n,
                     t - first, x, y, s, must[row][bit_at] ? "" : " not");
            wrong = wrong + 1;
          end
        end
  endtask

  task judge_joint;
    begin
      k = (cases[c + cases_first_joint] + j) * joints_COLUMNS;
      x = joints[k + joints_column];
      y = joints[k + joints_row];
      s = joints[k + joints_sample];
      count = 0;
      for (t = 0; t < cases[c + cases_triangles]; t = t + 1)
        if (joints[k + joints_triangles][t] && covers(first + t, x, y, s)) count = count + 1;
      if (!joints[k + joints_counts][count]) begin
        $display("case %0d column %0d row %0d sample %0d: %0d triangles cover it", n, x, y, s,
                 count);
        wrong = wrong + 1;
      end
    end
  endtask

  // Your rasterizer in place of this one. All numbers have the finer of two grids: the vertices',
  // and 1/256 pixel, in which locations are. The rule is top-left.
  localparam BITS = VECTORS_LATTICE_BITS > 8 ? VECTORS_LATTICE_BITS : 8;

  // E(a, b; x, y): coordinates have 40 bits, differences 41, a product of two 82.
  function automatic signed [95:0] edge_at(input signed [95:0] ax, input signed [95:0] ay,
                                           input signed [95:0] bx, input signed [95:0] by,
                                           input signed [95:0] x, input signed [95:0] y);
    edge_at = (x - ax) * (by - ay) - (y - ay) * (bx - ax);
  endfunction

  // Whether the sample lies on the inner side of a -> b, or on it and the edge owns it.
  function automatic is_inside(input signed [95:0] ax, input signed [95:0] ay,
                               input signed [95:0] bx, input signed [95:0] by,
                               input signed [95:0] x, input signed [95:0] y);
    reg signed [95:0] e;
    e = edge_at(ax, ay, bx, by, x, y);
    is_inside = e > 0 ||
        (e == 0 && (INCLUSIVE != 0 || by > ay || (by == ay && bx < ax)));
  endfunction

  // Column `axis` of a vertex.
  function automatic signed [39:0] vertex(input integer v, input integer axis);
    reg signed [31:0] stored;
    stored = vertices[v * vertices_COLUMNS + axis];
    vertex = stored;
    vertex = vertex <<< (BITS - VECTORS_LATTICE_BITS);
  endfunction

  // Whether triangle t of the file covers a sample of case n.
  function automatic covers(input integer t, input integer column, input integer row,
                            input integer sample);
    reg signed [39:0] ax, ay, bx, by, cx, cy, x, y;
    reg signed [95:0] area;
    integer k;
    k = t * triangles_COLUMNS;
    ax = vertex(triangles[k], vertices_x);
    ay = vertex(triangles[k], vertices_y);
    bx = vertex(triangles[k + 1], vertices_x);
    by = vertex(triangles[k + 1], vertices_y);
    cx = vertex(triangles[k + 2], vertices_x);
    cy = vertex(triangles[k + 2], vertices_y);
    k = (cases[c + cases_first_location] + sample) * locations_COLUMNS;
    x = (256 * column + locations[k + locations_x]) << (BITS - 8);
    y = (256 * row + locations[k + locations_y]) << (BITS - 8);
    area = edge_at(ax, ay, bx, by, cx, cy);
    if (area > 0)
      covers = is_inside(ax, ay, bx, by, x, y) && is_inside(bx, by, cx, cy, x, y) &&
               is_inside(cx, cy, ax, ay, x, y);
    else
      covers = area != 0 && is_inside(ax, ay, cx, cy, x, y) &&
               is_inside(cx, cy, bx, by, x, y) && is_inside(bx, by, ax, ay, x, y);
  endfunction
endmodule
