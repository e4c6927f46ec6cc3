// Judges an interpolator by vectors with values, one sample, y down.
//   rasterproof vectors generate --profile P --values --format readmemh --out FOLDER
//   cd FOLDER && iverilog -g2012 -I . -o values .../values.sv && vvp values
// -P values.AFFINE=1: affine for perspective, which is convicted.
`include "vectors.svh"

module values;
  parameter AFFINE = 0;
  reg [31:0] vertices[0:VECTORS_VERTICES * vertices_COLUMNS - 1];
  reg [31:0] triangles[0:VECTORS_TRIANGLES * triangles_COLUMNS - 1];
  reg [31:0] channels[0:VECTORS_CHANNELS * channels_COLUMNS - 1];
  reg [31:0] numbers[0:VECTORS_VERTICES * numbers_COLUMNS - 1];
  reg [31:0] stated[0:VECTORS_VALUES * values_COLUMNS - 1];
  integer n, v, wrong;
  real value;

  // A float32 by its bits.
  function automatic real number(input [31:0] bits);
    number = bits[30:23] == 0 ? bits[22:0] * 2.0 ** -149
                              : (8388608 + bits[22:0]) * 2.0 ** ($signed({24'b0, bits[30:23]}) - 150);
    if (bits[31]) number = -number;
  endfunction

  // Your interpolator in place of this one: a channel of a triangle at (x, y) in lattice units.
  function automatic real value_at(input integer t, input integer channel, input real x,
                                   input real y);
    integer i, a, b, c;
    real area, over_w, above, below;
    above = 0;
    below = 0;
    for (i = 0; i < 3; i = i + 1) begin
      a = triangles[t * triangles_COLUMNS + (i + 1) % 3] * vertices_COLUMNS;
      b = triangles[t * triangles_COLUMNS + (i + 2) % 3] * vertices_COLUMNS;
      c = triangles[t * triangles_COLUMNS + i] * numbers_COLUMNS;
      area = (x - $signed(vertices[a])) * ($signed(vertices[b + 1]) * 1.0 - $signed(vertices[a + 1])) -
             (y - $signed(vertices[a + 1])) * ($signed(vertices[b]) * 1.0 - $signed(vertices[a]));
      over_w = AFFINE ? area : area / number(numbers[c]);
      above = above + (channels[channel * channels_COLUMNS] == 1 ? area : over_w) *
                          number(numbers[c + 1 + channel]);
      below = below + (channels[channel * channels_COLUMNS] == 2 ? over_w : area);
    end
    value_at = above / below;
    if (channels[channel * channels_COLUMNS] == 0)  // flat: the first vertex's, if that is stated
      value_at = number(numbers[triangles[t * triangles_COLUMNS] * numbers_COLUMNS + 1 + channel]);
  endfunction

  initial begin
    $readmemh("vertices.hex", vertices);
    $readmemh("triangles.hex", triangles);
    $readmemh("channels.hex", channels);
    $readmemh("numbers.hex", numbers);
    $readmemh("values.hex", stated);
    wrong = 0;
    for (n = 0; n < VECTORS_VALUES; n = n + 1) begin
      v = n * values_COLUMNS;
      value = value_at(stated[v + values_triangle], stated[v + values_channel],
                       (stated[v + values_column] + 0.5) * 2.0 ** VECTORS_LATTICE_BITS,
                       (stated[v + values_row] + 0.5) * 2.0 ** VECTORS_LATTICE_BITS);
      if (!(value >= number(stated[v + values_low]) && value <= number(stated[v + values_high])))
        wrong = wrong + 1;
    end
    $display("%0d of %0d values are wrong", wrong, VECTORS_VALUES);
    $finish;
  end
endmodule
