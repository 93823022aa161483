`default_nettype none
// rtl/unit/wrinkle_truncated_segment.v, arranged: base and dots in one bit heap.
module wrinkle_truncated_segment #(
  parameter N               = 5,
  parameter BASE_BITS       = 12,
  parameter SLOPE_BITS      = 7,
  parameter DROPPED_COLUMNS = 4,
  parameter RESULT_BITS     = 11
) (
  input  wire [BASE_BITS-1:0]   base_i,
  input  wire [SLOPE_BITS-1:0]  slope_i,
  input  wire [N-1:0]           dx_i,
  output wire [RESULT_BITS-1:0] result_o
);
  localparam COLUMNS = N + BASE_BITS;
  localparam ROWS    = N + 1;

  function [ROWS*COLUMNS-1:0] mask;
    input unused;
    integer a, b;
    begin
      mask = {ROWS*COLUMNS{1'b0}};
      for (a = 0; a < N; a = a + 1)
        for (b = 0; b < SLOPE_BITS; b = b + 1)
          if (a + b >= DROPPED_COLUMNS) mask[a*COLUMNS+a+b] = 1'b1;
      for (b = 0; b < BASE_BITS; b = b + 1) mask[N*COLUMNS+N+b] = 1'b1;
    end
  endfunction

  wire [ROWS*COLUMNS-1:0] rows;
  wire [COLUMNS-1:0]      sum;
  wire unused_low = &{1'b0, sum};

  genvar i;
  generate
    for (i = 0; i < N; i = i + 1) begin : row
      wire [SLOPE_BITS-1:0] dots = slope_i & {SLOPE_BITS{dx_i[i]}};
      assign rows[i*COLUMNS +: COLUMNS] = {{(COLUMNS - SLOPE_BITS){1'b0}}, dots} << i;
    end
  endgenerate
  assign rows[N*COLUMNS +: COLUMNS] = {base_i, {N{1'b0}}};

  wrinkle_bit_heap #(.ROWS(ROWS), .COLUMNS(COLUMNS), .MASK(mask(1'b0))) heap (.rows_i(rows), .sum_o(sum));
  assign result_o = sum[COLUMNS-1 -: RESULT_BITS];
endmodule
`default_nettype wire
