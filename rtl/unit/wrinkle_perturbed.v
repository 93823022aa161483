`default_nettype none
// One component of the perturbed normal of [Peercy97 fig. 2]: a - fu b - fv c, rounded and saturated. Two multipliers.
// Latency 2.
module wrinkle_perturbed #(
  parameter WIDE_BITS     = 16,  // VW
  parameter GRADIENT_BITS = 9    // GB
) (
  input  wire                          clk,
  input  wire                          advance_i,
  input  wire signed [WIDE_BITS+1:0]   a_i,   // s1.VW
  input  wire signed [WIDE_BITS+1:0]   b_i,
  input  wire signed [WIDE_BITS+1:0]   c_i,
  input  wire signed [GRADIENT_BITS:0] fu_i,  // s0.GB
  input  wire signed [GRADIENT_BITS:0] fv_i,
  output wire [WIDE_BITS+2:0]          n_o    // s2.VW
);
  localparam WW      = WIDE_BITS + 2;
  localparam GB      = GRADIENT_BITS;
  localparam PRODUCT = WW + GB + 1;
  localparam SUM     = PRODUCT + 2;
  localparam LIMIT   = 1 << (WIDE_BITS + 2);

  wire signed [PRODUCT-1:0] u, v;
  reg signed [PRODUCT-1:0]  u_q, v_q;
  reg signed [WW-1:0]       a_q;
  wire signed [SUM-1:0]     a = {{3{a_q[WW-1]}}, a_q, {GB{1'b0}}};
  wire signed [SUM-1:0]     sum = a - {{2{u_q[PRODUCT-1]}}, u_q} - {{2{v_q[PRODUCT-1]}}, v_q};
  wire signed [WW+2:0]      rounded;
  wire [WW:0]               n;
  reg [WW:0]                n_q;

  wrinkle_multiply #(.A_BITS(GB + 1), .B_BITS(WW)) scale_b (.a_i(fu_i), .b_i(b_i), .product_o(u));
  wrinkle_multiply #(.A_BITS(GB + 1), .B_BITS(WW)) scale_c (.a_i(fv_i), .b_i(c_i), .product_o(v));
  wrinkle_round_half_up #(.VALUE_BITS(SUM), .SHIFT(GB), .RESULT_BITS(WW + 3)) round (
    .value_i(sum), .result_o(rounded));
  wrinkle_saturate #(.VALUE_BITS(WW + 3), .RESULT_BITS(WW + 1), .MINIMUM(-LIMIT), .MAXIMUM(LIMIT - 1)) saturate (
    .value_i(rounded), .result_o(n));

  assign n_o = n_q;

  always @(posedge clk)
    if (advance_i) begin
      u_q <= u;
      v_q <= v;
      a_q <= a_i;
      n_q <= n;
    end
endmodule
`default_nettype wire
