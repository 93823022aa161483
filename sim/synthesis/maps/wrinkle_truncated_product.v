`default_nettype none
// rtl/unit/wrinkle_truncated_product.v, arranged: constant and rows in one bit heap. The row of a last bit of m
// that stands alone has no dots above those of r.
module wrinkle_truncated_product #(
  parameter M_BITS      = 10,
  parameter R_BITS      = 12,
  parameter SHIFT       = 12,
  parameter RESULT_BITS = 10,
  parameter CUT         = 7,
  parameter [SHIFT+RESULT_BITS-1:0] CONSTANT = 0
) (
  input  wire [M_BITS-1:0]      m_i,
  input  wire [R_BITS-1:0]      r_i,
  output wire [RESULT_BITS-1:0] result_o
);
  localparam COLUMNS = SHIFT + RESULT_BITS;
  localparam DIGITS  = (M_BITS + 1) / 2;
  localparam ROWS    = DIGITS + 1;

  function [ROWS*COLUMNS-1:0] mask;
    input unused;
    integer a, b;
    begin
      mask = {ROWS*COLUMNS{1'b0}};
      for (a = 0; a < DIGITS; a = a + 1)
        for (b = 0; b < R_BITS + (2 * a + 1 < M_BITS ? 2 : 0); b = b + 1)
          if (2 * a + b >= CUT && 2 * a + b < COLUMNS) mask[a*COLUMNS+2*a+b] = 1'b1;
      mask[ROWS*COLUMNS-1 -: COLUMNS] = CONSTANT;
    end
  endfunction

  wire [2*DIGITS-1:0]     m = {{(2 * DIGITS - M_BITS){1'b0}}, m_i};
  wire [ROWS*COLUMNS-1:0] dots;
  wire [COLUMNS-1:0]      sum;

  genvar i;
  generate
    for (i = 0; i < DIGITS; i = i + 1) begin : rows
      wire [R_BITS+1:0] multiple;
      wrinkle_multiple #(.BITS(R_BITS)) times (.digit_i(m[2*i +: 2]), .value_i(r_i), .multiple_o(multiple));
      assign dots[i*COLUMNS +: COLUMNS] = {{(COLUMNS - R_BITS - 2){1'b0}}, multiple} << (2 * i);
    end
  endgenerate
  assign dots[ROWS*COLUMNS-1 -: COLUMNS] = CONSTANT;

  wrinkle_bit_heap #(.ROWS(ROWS), .COLUMNS(COLUMNS), .MASK(mask(1'b0))) heap (.rows_i(dots), .sum_o(sum));
  assign result_o = sum[COLUMNS-1 -: RESULT_BITS];
endmodule
`default_nettype wire
