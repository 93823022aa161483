`default_nettype none
// rtl/lib/wrinkle_signed.v, arranged: a negation inverts the bits above the lowest one that is set, so that no
// adder is needed.
module wrinkle_signed #(
  parameter BITS = 10
) (
  input  wire [BITS-1:0] magnitude_i,
  input  wire            negative_i,
  output wire [BITS:0]   value_o
);
  function [BITS:0] inverted;
    input [BITS-1:0] magnitude;
    input            negative;
    integer a;
    begin
      inverted = {(BITS + 1){1'b0}};
      for (a = 1; a <= BITS; a = a + 1) inverted[a] = inverted[a-1] | (negative & magnitude[a-1]);
    end
  endfunction

  assign value_o = {1'b0, magnitude_i} ^ inverted(magnitude_i, negative_i);
endmodule
`default_nettype wire
