`default_nettype none
// x^2 + y^2 + z^2 + CONSTANT of three unsigned magnitudes, each square without that of the low CUT bits. Combinational.
// A synthesis map may arrange the sum. [golden/pixel/compact_geometry.h]
module wrinkle_truncated_squares #(
  parameter BITS = 11,
  parameter CUT  = 0,
  parameter [2*BITS+1:0] CONSTANT = 0
) (
  input  wire [3*BITS-1:0] m_i,
  output wire [2*BITS+1:0] sum_o
);
  localparam [2*BITS+1:0] LOW = ~({(2 * BITS + 2){1'b1}} << CUT);

  function [2*BITS+1:0] square;
    input [2*BITS+1:0] m;
    square = m * m - (m & LOW) * (m & LOW);
  endfunction

  localparam [BITS+1:0] WIDEN = {(BITS + 2){1'b0}};

  assign sum_o = square({WIDEN, m_i[0 +: BITS]}) + square({WIDEN, m_i[BITS +: BITS]}) +
                 square({WIDEN, m_i[2*BITS +: BITS]}) + CONSTANT;
endmodule
`default_nettype wire
