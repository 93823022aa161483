`default_nettype none
// rtl/lib/wrinkle_multiple.v, arranged: a choice of once, twice and three times the value. The adder of the
// last merges with those of all other rows of the same value.
module wrinkle_multiple #(
  parameter BITS = 12
) (
  input  wire [1:0]      digit_i,
  input  wire [BITS-1:0] value_i,
  output wire [BITS+1:0] multiple_o
);
  wire [BITS+1:0] once  = {2'b00, value_i};
  wire [BITS+1:0] twice = {1'b0, value_i, 1'b0};
  wire [BITS+1:0] triple = once + twice;

  assign multiple_o = (once & {(BITS + 2){digit_i[0] & ~digit_i[1]}}) |
                      (twice & {(BITS + 2){digit_i[1] & ~digit_i[0]}}) |
                      (triple & {(BITS + 2){digit_i[0] & digit_i[1]}});
endmodule
`default_nettype wire
