`default_nettype none
// A vector to unit length, faithfully rounded (< 1 ulp), odd-symmetric, exact on the axes; zero stays zero.
// Sign and magnitude: all three magnitudes are shifted by the leading zeros of their OR, S is the exact sum of squares,
// r = 1/sqrt of its leading bits, and each component is m * r, rounded, with its sign put back. The one value
// -2^(V+1) has no magnitude in V + 1 bits and saturates. Latency 5. [docs/architecture.md, golden/pixel/rsqrt.h]
module wrinkle_normalizer #(
  parameter VECTOR_BITS = 9,  // V
  parameter UNIT_BITS   = 9    // F
) (
  input  wire                       clk,
  input  wire                       advance_i,
  input  wire [3*(VECTOR_BITS+2)-1:0] vector_i,  // s1.V each, x in the low bits
  output wire [3*(UNIT_BITS+2)-1:0] unit_o,      // s1.F each
  output wire                       zero_o
);
  localparam F = UNIT_BITS;
  localparam W = VECTOR_BITS + 2;
  localparam P = VECTOR_BITS + 1;
  localparam S_BITS = 2 * P + 2;

  // The geometry of the table: kRsqrtGeometry of golden/pixel/rsqrt.h.
  localparam INPUT_BITS   = F == 6 ? 8 : F == 7 ? 9 : F == 8 ? 10 : F < 15 ? F + 3 : 19;
  localparam OUTPUT_BITS  = F == 15 ? 17 : F + 1;
  localparam SEGMENT_BITS = F < 8 ? 3 : F < 11 ? 4 : F < 13 ? 5 : F < 16 ? 6 : 7;
  localparam GUARD_BITS   = F < 12 || F == 13 ? 1 : 2;

  // Rank 1: signs and magnitudes, shifted up together.
  reg [3*P-1:0] m1_q;
  reg [2:0]     negative1_q;
  reg           zero1_q;
  wire [3*P-1:0] magnitude, m1;
  wire [2:0]     negative;
  wire [P-1:0]   any = magnitude[0 +: P] | magnitude[P +: P] | magnitude[2*P +: P];
  wire [4:0]     shift;

  wrinkle_leading_zeros #(.BITS(P)) zeros (.value_i(any), .count_o(shift));

  // Rank 2: the sum of squares.
  reg [S_BITS-1:0]  s2_q;
  wire [S_BITS-1:0] s2;

  wrinkle_sum_of_squares #(.BITS(P)) squares (.m_i(m1_q), .sum_o(s2));

  // Ranks 3 and 4: the reciprocal root of its leading bits.
  wire                  e2 = |s2_q[S_BITS-1:2*P];  // S >= 2^2P
  wire [S_BITS-1:0]     s2_scaled = e2 ? s2_q : {s2_q[2*P-1:0], 2'b00};
  wire [INPUT_BITS-1:0] t;
  wire [OUTPUT_BITS:0]  r4;

  generate
    if (S_BITS >= INPUT_BITS) begin : leading
      wire unused_low = &{1'b0, s2_scaled};
      assign t = s2_scaled[S_BITS-1 -: INPUT_BITS];
    end else begin : padded
      assign t = {s2_scaled, {(INPUT_BITS - S_BITS){1'b0}}};
    end
  endgenerate

  wrinkle_rsqrt #(
    .INPUT_BITS(INPUT_BITS), .OUTPUT_BITS(OUTPUT_BITS), .SEGMENT_BITS(SEGMENT_BITS), .GUARD_BITS(GUARD_BITS)
  ) rsqrt (.clk(clk), .advance_i(advance_i), .t_i(t), .r_o(r4));

  // Beside them: magnitudes, signs, exponent.
  wire [3*P+3:0] carried2, carried4;
  wire           e4;
  wire [3*P-1:0] m4;
  wire [2:0]     negative4;
  wire           zero4;

  wrinkle_delay #(.WIDTH(3*P + 4), .RANKS(1)) carry2 (
    .clk(clk), .advance_i(advance_i), .data_i({zero1_q, negative1_q, m1_q}), .data_o(carried2));
  wrinkle_delay #(.WIDTH(3*P + 4), .RANKS(2)) carry4 (
    .clk(clk), .advance_i(advance_i), .data_i(carried2), .data_o(carried4));
  wrinkle_delay #(.WIDTH(1), .RANKS(2)) exponent4 (.clk(clk), .advance_i(advance_i), .data_i(e2), .data_o(e4));
  assign {zero4, negative4, m4} = carried4;

  // Rank 5: the products, rounded.
  reg [3*(F+2)-1:0]  unit_q;
  reg                zero_q;
  wire [3*(F+2)-1:0] unit;

  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : component
      wire [W-1:0] value  = vector_i[k*W +: W];
      wire [P-1:0] minus  = {P{1'b0}} - value[P-1:0];
      wire         lowest = value[W-1] & ~|value[P-1:0];
      assign negative[k] = value[W-1];
      assign magnitude[k*P +: P] = lowest ? {P{1'b1}} : negative[k] ? minus : value[P-1:0];
      assign m1[k*P +: P] = magnitude[k*P +: P] << shift;

      wire [P+OUTPUT_BITS:0]  product;
      wire signed [F+1:0]     rounded;
      wrinkle_multiply_unsigned #(.A_BITS(P), .B_BITS(OUTPUT_BITS + 1)) multiply (
        .a_i(m4[k*P +: P]), .b_i(r4), .product_o(product));
      wrinkle_round_half_up #(
        .VALUE_BITS(P + OUTPUT_BITS + 3), .SHIFT(P + 1 + OUTPUT_BITS - F), .RESULT_BITS(F + 2)
      ) round (.value_i(e4 ? {2'b00, product} : {1'b0, product, 1'b0}), .result_o(rounded));
      assign unit[k*(F+2) +: F+2] = negative4[k] ? -rounded : rounded;
    end
  endgenerate

  assign unit_o = unit_q;
  assign zero_o = zero_q;

  always @(posedge clk)
    if (advance_i) begin
      m1_q        <= m1;
      negative1_q <= negative;
      zero1_q     <= ~|any;
      s2_q        <= s2;
      unit_q      <= unit;
      zero_q      <= zero4;
    end
endmodule
`default_nettype wire
