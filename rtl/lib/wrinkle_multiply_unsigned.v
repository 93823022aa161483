`default_nettype none
// One unsigned multiplier, exact. Combinational. Nothing else, so that a netlist can be proven equal leaf by leaf.
module wrinkle_multiply_unsigned #(
  parameter A_BITS = 10,
  parameter B_BITS = 10
) (
  input  wire [A_BITS-1:0]        a_i,
  input  wire [B_BITS-1:0]        b_i,
  output wire [A_BITS+B_BITS-1:0] product_o
);
  assign product_o = a_i * b_i;
endmodule
`default_nettype wire
