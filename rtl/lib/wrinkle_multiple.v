`default_nettype none
// 0, 1, 2 or 3 times a value: one row of a product of which one factor is taken two bits at a time. Combinational.
// A synthesis map may arrange it.
module wrinkle_multiple #(
  parameter BITS = 12
) (
  input  wire [1:0]      digit_i,
  input  wire [BITS-1:0] value_i,
  output wire [BITS+1:0] multiple_o
);
  assign multiple_o = {2'b00, value_i} * {{BITS{1'b0}}, digit_i};
endmodule
`default_nettype wire
