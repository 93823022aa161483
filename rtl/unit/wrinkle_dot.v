`default_nettype none
// a . b exactly: three products in registers, then their sum. Latency 1, and the sum after it.
module wrinkle_dot #(
  parameter UNIT_BITS = 9  // F
) (
  input  wire                           clk,
  input  wire                           advance_i,
  input  wire [3*(UNIT_BITS+2)-1:0]     a_i,   // s1.F, x in the low bits
  input  wire [3*(UNIT_BITS+2)-1:0]     b_i,
  output wire signed [2*UNIT_BITS+5:0]  dot_o  // 2F fraction bits
);
  localparam W = UNIT_BITS + 2;

  wire signed [2*W-1:0] x, y, z;
  reg signed [2*W-1:0]  x_q, y_q, z_q;

  wrinkle_multiply #(.A_BITS(W), .B_BITS(W)) multiply_x (.a_i(a_i[0 +: W]), .b_i(b_i[0 +: W]), .product_o(x));
  wrinkle_multiply #(.A_BITS(W), .B_BITS(W)) multiply_y (.a_i(a_i[W +: W]), .b_i(b_i[W +: W]), .product_o(y));
  wrinkle_multiply #(.A_BITS(W), .B_BITS(W)) multiply_z (.a_i(a_i[2*W +: W]), .b_i(b_i[2*W +: W]), .product_o(z));

  assign dot_o = {{2{x_q[2*W-1]}}, x_q} + {{2{y_q[2*W-1]}}, y_q} + {{2{z_q[2*W-1]}}, z_q};

  always @(posedge clk)
    if (advance_i) begin
      x_q <= x;
      y_q <= y;
      z_q <= z;
    end
endmodule
`default_nettype wire
