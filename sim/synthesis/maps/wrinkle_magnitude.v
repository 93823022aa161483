`default_nettype none
// rtl/lib/wrinkle_magnitude.v, arranged: a negation inverts the bits above the lowest one that is set, so that no
// adder is needed.
module wrinkle_magnitude #(
  parameter BITS = 10
) (
  input  wire [BITS:0]   value_i,
  output wire [BITS-1:0] magnitude_o
);
  function [BITS-1:0] inverted;
    input [BITS:0] value;
    integer a;
    begin
      inverted = {BITS{1'b0}};
      inverted[0] = value[BITS] & ~|value[BITS-1:0];
      for (a = 1; a < BITS; a = a + 1) inverted[a] = inverted[a-1] | (value[BITS] & value[a-1]);
    end
  endfunction

  assign magnitude_o = value_i[BITS-1:0] ^ inverted(value_i);
endmodule
`default_nettype wire
