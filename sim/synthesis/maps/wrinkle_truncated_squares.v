`default_nettype none
// rtl/unit/wrinkle_truncated_squares.v, arranged: one bit heap of folded squares, in which bit i alone weighs
// 2^(2i), bits i < j together 2^(i+j+1). Dots of two bits below CUT are left out.
module wrinkle_truncated_squares #(
  parameter BITS = 11,
  parameter CUT  = 0,
  parameter [2*BITS+1:0] CONSTANT = 0
) (
  input  wire [3*BITS-1:0] m_i,
  output wire [2*BITS+1:0] sum_o
);
  localparam COLUMNS = 2 * BITS + 2;
  localparam ROWS    = 3 * BITS + 1;

  function [ROWS*COLUMNS-1:0] mask;
    input unused;
    integer a, b, c;
    begin
      mask = {ROWS*COLUMNS{1'b0}};
      for (c = 0; c < 3; c = c + 1)
        for (a = 0; a < BITS; a = a + 1) begin
          if (a >= CUT) mask[(c*BITS+a)*COLUMNS+2*a] = 1'b1;
          for (b = a + 1; b < BITS; b = b + 1)
            if (b >= CUT) mask[(c*BITS+a)*COLUMNS+a+b+1] = 1'b1;
        end
      mask[ROWS*COLUMNS-1 -: COLUMNS] = CONSTANT;
    end
  endfunction

  wire [ROWS*COLUMNS-1:0] rows;

  genvar i, j, k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : component
      for (i = 0; i < BITS; i = i + 1) begin : row
        wire [COLUMNS-1:0] dots;
        for (j = 0; j < COLUMNS; j = j + 1) begin : column
          if (j == 2 * i) begin : own
            assign dots[j] = m_i[k*BITS+i];
          end else if (j > 2 * i + 1 && j < i + 1 + BITS) begin : pair
            assign dots[j] = m_i[k*BITS+i] & m_i[k*BITS+j-i-1];
          end else begin : none
            assign dots[j] = 1'b0;
          end
        end
        assign rows[(k*BITS+i)*COLUMNS +: COLUMNS] = dots;
      end
    end
  endgenerate
  assign rows[ROWS*COLUMNS-1 -: COLUMNS] = CONSTANT;

  wrinkle_bit_heap #(.ROWS(ROWS), .COLUMNS(COLUMNS), .MASK(mask(1'b0))) heap (.rows_i(rows), .sum_o(sum_o));
endmodule
`default_nettype wire
