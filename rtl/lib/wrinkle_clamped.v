`default_nettype none
// max(value, 0) from s1.F to u1.DF, rounded, at most one: the dot product with (0, 0, 1), or the height of a vector
// above the surface. Combinational.
module wrinkle_clamped #(
  parameter UNIT_BITS = 9,   // F
  parameter DOT_BITS  = 10   // DF
) (
  input  wire signed [UNIT_BITS+1:0] value_i,   // s1.F
  output wire [DOT_BITS:0]           clamped_o  // u1.DF
);
  localparam BITS = (UNIT_BITS > DOT_BITS ? UNIT_BITS : DOT_BITS) + 3;

  wire signed [BITS-1:0] rounded;

  wrinkle_round_half_up #(.VALUE_BITS(UNIT_BITS + 2), .SHIFT(UNIT_BITS - DOT_BITS), .RESULT_BITS(BITS)) round (
    .value_i(value_i), .result_o(rounded));
  wrinkle_saturate #(
    .VALUE_BITS(BITS), .RESULT_BITS(DOT_BITS + 1), .MINIMUM(0), .MAXIMUM(1 << DOT_BITS)
  ) saturate (.value_i(rounded), .result_o(clamped_o));
endmodule
`default_nettype wire
