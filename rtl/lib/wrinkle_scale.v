`default_nettype none
// a * b, b u1.FRACTION_BITS and at most one, rounded to the format of a. Combinational. No saturation: |result| <= a.
module wrinkle_scale #(
  parameter BITS          = 11,
  parameter FRACTION_BITS = 10
) (
  input  wire [BITS-1:0]        a_i,
  input  wire [FRACTION_BITS:0] b_i,
  output wire [BITS-1:0]        result_o
);
  wire [BITS+FRACTION_BITS:0] product;

  wrinkle_multiply_unsigned #(.A_BITS(BITS), .B_BITS(FRACTION_BITS + 1)) multiply (
    .a_i(a_i), .b_i(b_i), .product_o(product));
  wrinkle_round_half_up #(.VALUE_BITS(BITS + FRACTION_BITS + 2), .SHIFT(FRACTION_BITS), .RESULT_BITS(BITS)) round (
    .value_i({1'b0, product}), .result_o(result_o));
endmodule
`default_nettype wire
