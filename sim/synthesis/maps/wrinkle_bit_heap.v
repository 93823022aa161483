`default_nettype none
// Sum of ROWS rows modulo 2^COLUMNS with as few full adders as there can be: bits that MASK says are always 0 take part
// in nothing. Row i is rows_i[i*COLUMNS +: COLUMNS]. Combinational.
module wrinkle_bit_heap #(
  parameter ROWS = 3,
  parameter COLUMNS = 8,
  parameter [ROWS*COLUMNS-1:0] MASK = {ROWS*COLUMNS{1'b1}}
) (
  input  wire [ROWS*COLUMNS-1:0] rows_i,
  output wire [COLUMNS-1:0]      sum_o
);
  // Bits in the column itself, of the rows before `row`.
  function integer dots;
    input integer column, row;
    integer a;
    begin
      dots = 0;
      for (a = 0; a < row; a = a + 1)
        if (MASK[a*COLUMNS+column]) dots = dots + 1;
    end
  endfunction

  // Bits with the carries from the column before.
  function integer height;
    input integer column;
    integer a;
    begin
      height = 0;
      for (a = 0; a <= column; a = a + 1) height = height / 2 + dots(a, ROWS);
    end
  endfunction

  wire unused_rows = &{1'b0, rows_i};

  genvar c, i;
  generate
    for (c = 0; c < COLUMNS; c = c + 1) begin : columns
      localparam DOTS    = dots(c, ROWS);
      localparam HEIGHT  = height(c);
      localparam CARRIES = HEIGHT > 1 ? HEIGHT / 2 : 1;
      wire [CARRIES-1:0] carry;
      if (HEIGHT == 0) begin : empty
        assign sum_o[c] = 1'b0;
        assign carry = 1'b0;
      end else begin : filled
        wire [HEIGHT-1:0] bits;
        for (i = 0; i < ROWS; i = i + 1) begin : rows
          if (MASK[i*COLUMNS+c]) begin : dot
            assign bits[dots(c, i)] = rows_i[i*COLUMNS+c];
          end
        end
        if (HEIGHT > DOTS) begin : carries
          assign bits[HEIGHT-1:DOTS] = columns[c-1].carry;
        end
        wrinkle_bit_heap_column #(.COUNT(HEIGHT)) column (.bits_i(bits), .sum_o(sum_o[c]), .carry_o(carry));
      end
      if (c == COLUMNS - 1 || HEIGHT < 2) begin : loose
        wire unused_carry = &{1'b0, carry};
      end
    end
  endgenerate
endmodule
`default_nettype wire
