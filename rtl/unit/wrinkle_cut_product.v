`default_nettype none
// (m * r + CONSTANT) >> SHIFT, without the dots in columns below CUT of the rows (two bits of m) * r. Three times r
// comes from outside, where three products share it. Combinational. [golden/pixel/compact_geometry.h]
module wrinkle_cut_product #(
  parameter M_BITS      = 10,
  parameter R_BITS      = 12,
  parameter SHIFT       = 12,
  parameter RESULT_BITS = 10,
  parameter CUT         = 7,
  parameter [SHIFT+RESULT_BITS-1:0] CONSTANT = 0
) (
  input  wire [M_BITS-1:0]      m_i,
  input  wire [R_BITS-1:0]      r_i,
  input  wire [R_BITS+1:0]      r3_i,
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

  wire [ROWS*COLUMNS-1:0] rows;
  wire [COLUMNS-1:0]      product;
  wire unused_low = &{1'b0, product};

  genvar i;
  generate
    for (i = 0; i < DIGITS; i = i + 1) begin : digit
      wire [COLUMNS+1:0] row;
      if (2 * i + 1 < M_BITS) begin : two
        wire one   = m_i[2*i] & ~m_i[2*i+1];
        wire twice = m_i[2*i+1] & ~m_i[2*i];
        wire three = m_i[2*i] & m_i[2*i+1];
        wire [R_BITS+1:0] times = ({2'b00, r_i} & {(R_BITS + 2){one}}) | ({1'b0, r_i, 1'b0} & {(R_BITS + 2){twice}}) |
                                  (r3_i & {(R_BITS + 2){three}});
        assign row = {{(COLUMNS - R_BITS){1'b0}}, times} << (2 * i);
      end else begin : single
        wire [R_BITS-1:0] times = r_i & {R_BITS{m_i[2*i]}};
        assign row = {{(COLUMNS + 2 - R_BITS){1'b0}}, times} << (2 * i);
      end
      wire unused_top = &{1'b0, row};
      assign rows[i*COLUMNS +: COLUMNS] = row[COLUMNS-1:0];
    end
  endgenerate
  assign rows[ROWS*COLUMNS-1 -: COLUMNS] = CONSTANT;

  wrinkle_heap #(.ROWS(ROWS), .COLUMNS(COLUMNS), .MASK(mask(1'b0))) heap (.rows_i(rows), .sum_o(product));
  assign result_o = product[COLUMNS-1 -: RESULT_BITS];
endmodule
`default_nettype wire
