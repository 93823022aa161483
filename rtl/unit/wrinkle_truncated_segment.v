`default_nettype none
// One linear segment of a table: the leading RESULT_BITS bits of (base << N) + slope * dx, where the product lacks its
// dots in the columns below DROPPED_COLUMNS; the sum fits its width. Combinational. A synthesis map may
// arrange the sum. [golden/pixel/compact_rsqrt.h]
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
  localparam [COLUMNS-1:0] KEPT = {COLUMNS{1'b1}} << DROPPED_COLUMNS;

  wire [COLUMNS-1:0] slope = {{(COLUMNS - SLOPE_BITS){1'b0}}, slope_i};
  wire [COLUMNS-1:0] sum = rows[N-1].partial;
  wire unused_low = &{1'b0, sum};

  genvar i;
  generate
    for (i = 0; i < N; i = i + 1) begin : rows
      wire [COLUMNS-1:0] row = (slope << i) & {COLUMNS{dx_i[i]}} & KEPT;
      wire [COLUMNS-1:0] partial;
      if (i == 0) begin : first
        assign partial = row + {base_i, {N{1'b0}}};
      end else begin : later
        assign partial = row + rows[i-1].partial;
      end
    end
  endgenerate

  assign result_o = sum[COLUMNS-1 -: RESULT_BITS];
endmodule
`default_nettype wire
