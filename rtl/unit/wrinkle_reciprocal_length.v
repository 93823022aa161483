`default_nettype none
// The front half of a normalizer: mantissas and reciprocal length of a vector. Sign and magnitude: all three magnitudes
// are shifted by the leading zeros of their OR and cut to their MANTISSA_BITS leading bits, m; S is the exact sum of
// squares of these, r = 1/sqrt of its leading bits, brought to [1/4, 1); then m_i * r, halved where `halve`, is a
// component of the unit vector. With COMPLEMENT 1 the sign is put back into m. The one value -2^(V+1) has no magnitude
// in V + 1 bits and saturates. Of zero, m is zero and r that of t = 1/4. Latency 4; with PIPELINED 2 two, after the sum
// of squares and after the root. [docs/architecture.md, golden/pixel/rsqrt.h]
module wrinkle_reciprocal_length #(
  parameter VECTOR_BITS   = 9,   // V
  parameter UNIT_BITS     = 9,   // F
  parameter MANTISSA_BITS = 10,  // at most V + 1
  parameter COMPLEMENT    = 0,
  parameter PIPELINED     = 1,
  parameter OUTPUT_BITS   = UNIT_BITS == 15 ? 17 : UNIT_BITS + 1  // RB, of the above
) (
  input  wire                         clk,
  input  wire                         advance_i,
  input  wire [3*(VECTOR_BITS+2)-1:0] vector_i,    // s1.V each, x in the low bits
  output wire [3*MANTISSA_BITS-1:0]   m_o,         // magnitudes, the greatest with its leading bit set
  output wire [2:0]                   negative_o,  // with COMPLEMENT the bits above those of m_o
  output wire [OUTPUT_BITS:0]         r_o,         // u1.RB
  output wire                         halve_o,     // S is at least one
  output wire                         zero_o
);
  localparam F      = UNIT_BITS;
  localparam W      = VECTOR_BITS + 2;
  localparam P      = VECTOR_BITS + 1;
  localparam M      = MANTISSA_BITS;
  localparam S_BITS = 2 * M + 2;
  localparam ALL    = PIPELINED == 1 ? 1 : 0;  // every rank, not two alone

  // The geometry of the table: kRsqrtGeometry of golden/pixel/rsqrt.h.
  localparam INPUT_BITS   = F == 6 ? 8 : F == 7 ? 9 : F == 8 ? 10 : F < 15 ? F + 3 : 19;
  localparam SEGMENT_BITS = F < 8 ? 3 : F < 11 ? 4 : F < 13 ? 5 : F < 16 ? 6 : 7;
  localparam GUARD_BITS   = F < 12 || F == 13 ? 1 : 2;

  // Rank 1: signs and magnitudes, shifted up together.
  wire [3*P-1:0] magnitude;
  wire [3*M-1:0] m0, m1, m2;
  wire [2:0]     negative, negative1, negative2;
  wire [P-1:0]   any = magnitude[0 +: P] | magnitude[P +: P] | magnitude[2*P +: P];
  wire [4:0]     shift;

  wrinkle_leading_zeros #(.BITS(P)) zeros (.value_i(any), .count_o(shift));

  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : component
      wire [W-1:0] value   = vector_i[k*W +: W];
      wire [P-1:0] minus   = {P{1'b0}} - value[P-1:0];
      wire         lowest  = value[W-1] & ~|value[P-1:0];
      wire [P-1:0] shifted = magnitude[k*P +: P] << shift;
      assign negative[k] = value[W-1];
      assign magnitude[k*P +: P] = lowest ? {P{1'b1}} : negative[k] ? minus : value[P-1:0];
      assign m0[k*M +: M] = shifted[P-1 -: M];
      if (M < P) begin : cut
        wire unused_low = &{1'b0, shifted[P-M-1:0]};
      end
      assign {negative2[k], m2[k*M +: M]} =
        COMPLEMENT != 0 && negative1[k] ? -{1'b0, m1[k*M +: M]} : {negative1[k], m1[k*M +: M]};
    end
  endgenerate

  // Rank 2: the sum of squares.
  wire [S_BITS-1:0] s1, s2;

  wrinkle_sum_of_squares #(.BITS(M)) squares (.m_i(m1), .sum_o(s1));
  wrinkle_delay #(.WIDTH(S_BITS), .RANKS(1)) sum2 (
    .clk(clk), .advance_i(advance_i), .data_i(s1), .data_o(s2));

  // Ranks 3 and 4: the reciprocal root of its leading bits.
  wire                  e2 = |s2[S_BITS-1:2*M];  // S >= 2^2M
  wire [S_BITS-1:0]     s2_scaled = e2 ? s2 : {s2[2*M-1:0], 2'b00};
  wire [INPUT_BITS-1:0] t;

  generate
    if (S_BITS >= INPUT_BITS) begin : leading
      wire unused_low = &{1'b0, s2_scaled};
      assign t = s2_scaled[S_BITS-1 -: INPUT_BITS];
    end else begin : padded
      assign t = {s2_scaled, {(INPUT_BITS - S_BITS){1'b0}}};
    end
  endgenerate

  wrinkle_rsqrt #(
    .INPUT_BITS(INPUT_BITS), .OUTPUT_BITS(OUTPUT_BITS), .SEGMENT_BITS(SEGMENT_BITS), .GUARD_BITS(GUARD_BITS),
    .PIPELINED(PIPELINED)
  ) rsqrt (.clk(clk), .advance_i(advance_i), .t_i(t), .r_o(r_o));

  // Beside them: magnitudes, signs, exponent.
  wire zero1;

  wrinkle_delay #(.WIDTH(3*M + 4), .RANKS(ALL)) rank1 (
    .clk(clk), .advance_i(advance_i), .data_i({~|any, negative, m0}), .data_o({zero1, negative1, m1}));
  wrinkle_delay #(.WIDTH(3*M + 4), .RANKS(ALL + 2)) carry4 (
    .clk(clk), .advance_i(advance_i), .data_i({zero1, negative2, m2}), .data_o({zero_o, negative_o, m_o}));
  wrinkle_delay #(.WIDTH(1), .RANKS(ALL + 1)) exponent4 (
    .clk(clk), .advance_i(advance_i), .data_i(e2), .data_o(halve_o));
endmodule
`default_nettype wire
