`default_nettype none
// |value| in BITS bits; the one value that does not fit, -2^BITS, saturates. Combinational. A synthesis map may arrange
// the negation.
module wrinkle_magnitude #(
  parameter BITS = 10
) (
  input  wire [BITS:0]   value_i,
  output wire [BITS-1:0] magnitude_o
);
  wire [BITS:0] turned = (value_i ^ {(BITS + 1){value_i[BITS]}}) + {{BITS{1'b0}}, value_i[BITS]};

  assign magnitude_o = turned[BITS-1:0] - {{(BITS - 1){1'b0}}, turned[BITS]};
endmodule
`default_nettype wire
