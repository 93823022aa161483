`default_nettype none
// x^2 + y^2 + z^2 of three unsigned magnitudes, exact. Combinational, three multipliers.
module wrinkle_sum_of_squares #(
  parameter BITS = 11
) (
  input  wire [3*BITS-1:0] m_i,
  output wire [2*BITS+1:0] sum_o
);
  wire [2*BITS-1:0] xx, yy, zz;

  wrinkle_multiply_unsigned #(.A_BITS(BITS), .B_BITS(BITS)) square_x (
    .a_i(m_i[0 +: BITS]), .b_i(m_i[0 +: BITS]), .product_o(xx));
  wrinkle_multiply_unsigned #(.A_BITS(BITS), .B_BITS(BITS)) square_y (
    .a_i(m_i[BITS +: BITS]), .b_i(m_i[BITS +: BITS]), .product_o(yy));
  wrinkle_multiply_unsigned #(.A_BITS(BITS), .B_BITS(BITS)) square_z (
    .a_i(m_i[2*BITS +: BITS]), .b_i(m_i[2*BITS +: BITS]), .product_o(zz));

  assign sum_o = {2'b00, xx} + {2'b00, yy} + {2'b00, zz};
endmodule
`default_nettype wire
