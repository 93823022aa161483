`default_nettype none
// (m * r + CONSTANT) >> SHIFT, where each row (two bits of m) * r lacks its part in the columns below CUT.
// Combinational. A synthesis map may arrange the sum. [golden/pixel/compact_geometry.h]
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
  localparam ROWS    = (M_BITS + 1) / 2;
  localparam [COLUMNS-1:0] KEPT = {COLUMNS{1'b1}} << CUT;

  wire [2*ROWS-1:0]  m = {{(2 * ROWS - M_BITS){1'b0}}, m_i};
  wire [COLUMNS-1:0] sum = rows[ROWS-1].partial;
  wire unused_low = &{1'b0, sum};

  genvar i;
  generate
    for (i = 0; i < ROWS; i = i + 1) begin : rows
      wire [R_BITS+1:0]  multiple;
      wire [COLUMNS-1:0] row = ({{(COLUMNS - R_BITS - 2){1'b0}}, multiple} << (2 * i)) & KEPT;
      wire [COLUMNS-1:0] partial;
      wrinkle_multiple #(.BITS(R_BITS)) times (.digit_i(m[2*i +: 2]), .value_i(r_i), .multiple_o(multiple));
      if (i == 0) begin : first
        assign partial = row + CONSTANT;
      end else begin : later
        assign partial = row + rows[i-1].partial;
      end
    end
  endgenerate

  assign result_o = sum[COLUMNS-1 -: RESULT_BITS];
endmodule
`default_nettype wire
