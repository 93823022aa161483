`default_nettype none
// max(a . b, 0) in u1.DF, at most one: three products, then their sum, rounded and saturated. Latency 2.
module wrinkle_clamped_dot #(
  parameter UNIT_BITS = 9,   // F
  parameter DOT_BITS  = 10   // DF, at most 2F
) (
  input  wire                       clk,
  input  wire                       advance_i,
  input  wire [3*(UNIT_BITS+2)-1:0] a_i,    // s1.F, x in the low bits
  input  wire [3*(UNIT_BITS+2)-1:0] b_i,
  output wire [DOT_BITS:0]          dot_o   // u1.DF
);
  localparam W       = UNIT_BITS + 2;
  localparam SHIFT   = 2 * UNIT_BITS - DOT_BITS;
  localparam SUM     = 2 * W + 2;
  localparam ROUNDED = SUM - SHIFT + 1;

  wire signed [2*W-1:0]     x, y, z;
  reg signed [2*W-1:0]      x_q, y_q, z_q;
  wire signed [SUM-1:0]     sum = {{2{x_q[2*W-1]}}, x_q} + {{2{y_q[2*W-1]}}, y_q} + {{2{z_q[2*W-1]}}, z_q};
  wire signed [ROUNDED-1:0] rounded;
  wire [DOT_BITS:0]         dot;
  reg [DOT_BITS:0]          dot_q;

  wrinkle_multiply #(.A_BITS(W), .B_BITS(W)) multiply_x (.a_i(a_i[0 +: W]), .b_i(b_i[0 +: W]), .product_o(x));
  wrinkle_multiply #(.A_BITS(W), .B_BITS(W)) multiply_y (.a_i(a_i[W +: W]), .b_i(b_i[W +: W]), .product_o(y));
  wrinkle_multiply #(.A_BITS(W), .B_BITS(W)) multiply_z (.a_i(a_i[2*W +: W]), .b_i(b_i[2*W +: W]), .product_o(z));
  wrinkle_round_half_up #(.VALUE_BITS(SUM), .SHIFT(SHIFT), .RESULT_BITS(ROUNDED)) round (
    .value_i(sum), .result_o(rounded));
  wrinkle_saturate #(
    .VALUE_BITS(ROUNDED), .RESULT_BITS(DOT_BITS + 1), .MINIMUM(0), .MAXIMUM(1 << DOT_BITS)
  ) saturate (.value_i(rounded), .result_o(dot));

  assign dot_o = dot_q;

  always @(posedge clk)
    if (advance_i) begin
      x_q   <= x;
      y_q   <= y;
      z_q   <= z;
      dot_q <= dot;
    end
endmodule
`default_nettype wire
