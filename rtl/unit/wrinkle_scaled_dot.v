`default_nettype none
// The cosine of two vectors that are not of unit length, max(a . b, 0) in u1.DF and at most one: the dot product of their
// mantissas by the product of their scales, each rounded to DF fraction bits first. Latency 3.
module wrinkle_scaled_dot #(
  parameter UNIT_BITS  = 9,   // F
  parameter DOT_BITS   = 10,  // DF, at most 2F
  parameter SCALE_BITS = UNIT_BITS == 15 ? 17 : UNIT_BITS + 1  // RB, of the above
) (
  input  wire                       clk,
  input  wire                       advance_i,
  input  wire [3*(UNIT_BITS+1)-1:0] a_i,        // s0.F, x in the low bits
  input  wire [3*(UNIT_BITS+1)-1:0] b_i,
  input  wire [SCALE_BITS:0]        scale_a_i,  // u1.RB
  input  wire [SCALE_BITS:0]        scale_b_i,
  output wire [DOT_BITS:0]          dot_o       // u1.DF
);
  localparam DOT     = 2 * UNIT_BITS + 4;
  localparam D       = DOT_BITS + 2;                                            // u2.DF: the dot product is below 3
  localparam SCALE   = SCALE_BITS > DOT_BITS + 2 ? DOT_BITS + 3 : DOT_BITS + 2; // u3.DF where 4 - 2^-RB rounds to 4
  localparam ROUNDED = D + SCALE - DOT_BITS + 2;                                // with a carry and a sign

  // Rank 1: the dot product, and beside it the product of the scales.
  wire signed [DOT-1:0]   dot1;
  wire [2*SCALE_BITS+1:0] product0;
  wire [SCALE-1:0]        scale0;
  reg [SCALE-1:0]         scale1_q;

  wrinkle_dot #(.UNIT_BITS(UNIT_BITS - 1)) dot (
    .clk(clk), .advance_i(advance_i), .a_i(a_i), .b_i(b_i), .dot_o(dot1));
  wrinkle_multiply_unsigned #(.A_BITS(SCALE_BITS + 1), .B_BITS(SCALE_BITS + 1)) multiply_scales (
    .a_i(scale_a_i), .b_i(scale_b_i), .product_o(product0));
  wrinkle_round_half_up #(
    .VALUE_BITS(2*SCALE_BITS + 3), .SHIFT(2*SCALE_BITS - DOT_BITS), .RESULT_BITS(SCALE)
  ) round_scale (.value_i({1'b0, product0}), .result_o(scale0));

  // Rank 2: clamped and rounded.
  wire [D-1:0]    rounded1;
  reg [D-1:0]     dot2_q;
  reg [SCALE-1:0] scale2_q;

  wrinkle_round_half_up #(.VALUE_BITS(DOT), .SHIFT(2*UNIT_BITS - DOT_BITS), .RESULT_BITS(D)) round_dot (
    .value_i(dot1), .result_o(rounded1));

  // Rank 3: scaled.
  wire [D+SCALE-1:0]        product2;
  wire signed [ROUNDED-1:0] rounded2;
  wire [DOT_BITS:0]         cosine2;
  reg [DOT_BITS:0]          cosine3_q;

  wrinkle_multiply_unsigned #(.A_BITS(D), .B_BITS(SCALE)) multiply (
    .a_i(dot2_q), .b_i(scale2_q), .product_o(product2));
  wrinkle_round_half_up #(.VALUE_BITS(D + SCALE + 1), .SHIFT(DOT_BITS), .RESULT_BITS(ROUNDED)) round (
    .value_i({1'b0, product2}), .result_o(rounded2));
  wrinkle_saturate #(
    .VALUE_BITS(ROUNDED), .RESULT_BITS(DOT_BITS + 1), .MINIMUM(0), .MAXIMUM(1 << DOT_BITS)
  ) saturate (.value_i(rounded2), .result_o(cosine2));

  assign dot_o = cosine3_q;

  always @(posedge clk)
    if (advance_i) begin
      scale1_q  <= scale0;
      dot2_q    <= dot1[DOT-1] ? {D{1'b0}} : rounded1;
      scale2_q  <= scale1_q;
      cosine3_q <= cosine2;
    end
endmodule
`default_nettype wire
