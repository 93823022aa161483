`default_nettype none
// |value| in BITS bits; the one value that does not fit, -2^BITS, saturates. Combinational. A synthesis map may arrange
// the negation.
module wrinkle_magnitude #(
  parameter BITS = 10
) (
  input  wire [BITS:0]   value_i,
  output wire [BITS-1:0] magnitude_o
);
  wire            negative = value_i[BITS];
  wire            lowest   = negative & ~|value_i[BITS-1:0];
  wire [BITS-1:0] minus    = {BITS{1'b0}} - value_i[BITS-1:0];

  assign magnitude_o = lowest ? {BITS{1'b1}} : negative ? minus : value_i[BITS-1:0];
endmodule
`default_nettype wire
