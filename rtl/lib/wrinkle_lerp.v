`default_nettype none
// a + weight * (b - a) with a weight of WEIGHT_BITS fraction bits, exact. Combinational, one multiplier.
module wrinkle_lerp #(
  parameter BITS        = 8,
  parameter WEIGHT_BITS = 8
) (
  input  wire [BITS-1:0]             a_i,
  input  wire [BITS-1:0]             b_i,
  input  wire [WEIGHT_BITS-1:0]      weight_i,  // u0.WEIGHT_BITS
  output wire [BITS+WEIGHT_BITS-1:0] value_o
);
  wire signed [BITS:0]               difference = $signed({1'b0, b_i}) - $signed({1'b0, a_i});
  wire signed [BITS+WEIGHT_BITS+1:0] product;
  wire unused_sign = &{1'b0, product};

  wrinkle_multiply #(.A_BITS(BITS + 1), .B_BITS(WEIGHT_BITS + 1)) multiply (
    .a_i(difference), .b_i({1'b0, weight_i}), .product_o(product));

  assign value_o = {a_i, {WEIGHT_BITS{1'b0}}} + product[BITS+WEIGHT_BITS-1:0];
endmodule
`default_nettype wire
