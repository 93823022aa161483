`default_nettype none
// negative ? -magnitude : magnitude. Combinational. A synthesis map may arrange the negation.
module wrinkle_signed #(
  parameter BITS = 10
) (
  input  wire [BITS-1:0] magnitude_i,
  input  wire            negative_i,
  output wire [BITS:0]   value_o
);
  wire [BITS:0] magnitude = {1'b0, magnitude_i};

  assign value_o = negative_i ? -magnitude : magnitude;
endmodule
`default_nettype wire
