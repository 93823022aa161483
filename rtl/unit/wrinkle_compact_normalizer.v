`default_nettype none
// A vector to unit length from truncated squares and products; zero stays zero, n(-v) = -n(v). KIND 2, compact: each
// component off by less than 1 ulp, exact on the axes. 3, lite: the direction alone, the length within 3 %. 4, near: as
// compact, for lengths of 1/2 to 1, where the shift is not needed. Latency 5; with PIPELINED 2 two, after the sum of
// squares and after the root.
// Sign and magnitude: the magnitudes are shifted up together by the leading zeros of their OR; S is the sum of their
// squares, r = 1/sqrt of its leading bits, each component m * r. The one value -2^(V+1) saturates. Does not compute
// what the kind `faithful` does: an ulp may differ. [docs/architecture.md, golden/pixel/compact_geometry.h]
module wrinkle_compact_normalizer #(
  parameter KIND        = 2,
  parameter VECTOR_BITS = 9,  // V
  parameter UNIT_BITS   = 9,  // F
  parameter PIPELINED   = 1
) (
  input  wire                         clk,
  input  wire                         advance_i,
  input  wire [3*(VECTOR_BITS+2)-1:0] vector_i,  // s1.V each, x in the low bits
  output wire [3*(UNIT_BITS+2)-1:0]   unit_o,    // s1.F each
  output wire                         zero_o
);
  localparam F     = UNIT_BITS;
  localparam V     = VECTOR_BITS;
  localparam LITE  = KIND == 3 ? 1 : 0;
  localparam NEAR  = KIND == 4 ? 1 : 0;
  localparam PAD   = V < F ? F - V : 0;
  localparam WIDER = V > F ? V - F : 0;
  localparam P     = V + 1 + PAD;
  localparam ALL   = PIPELINED == 1 ? 1 : 0;  // every rank, not two alone

  // The geometry: compact_geometry() of golden/pixel/compact_geometry.h.
  localparam INPUT_BITS   = LITE != 0 ? 7 : F < 10 ? F + 3 : F + 4;
  localparam OUTPUT_BITS  = LITE != 0 ? 7 : F + 2;
  localparam SEGMENT_BITS = LITE != 0 ? 5 : F < 8 ? 3 : F < 11 ? 4 : F < 13 ? 5 : F < 15 ? 6 : 7;
  localparam GUARD_BITS   = LITE != 0 ? 0 : F < 9 || F == 13 ? 2 : 1;
  localparam BIAS         = LITE == 0 && (F == 6 || F == 9 || F == 11 || F == 13 || F > 14) ? 1 : 0;
  localparam DROPPED      = LITE != 0 ? 0 : F == 6 || F == 8 ? 4 : F == 7 || F == 9 ? 5 : F == 10 ? 6 : F < 13 ? 7 :
                            F < 15 ? 8 : 9;
  localparam SQUARE_BITS  = LITE != 0 ? 7 : P;
  localparam SQUARE_CUT   = LITE != 0 ? 0 : WIDER + (F == 6 ? 1 : F < 9 ? 2 : F < 11 ? 3 : F < 14 ? 4 : F < 16 ? 5 : 6);
  localparam CUT_EQUAL    = F == 6 ? 5 : F == 7 || F == 9 ? 7 : F == 8 || F == 10 ? 8 : F < 13 ? 9 : F == 14 || F == 16
                            ? 11 : 12;
  localparam PRODUCT_CUT  = LITE != 0 ? 0 : CUT_EQUAL + WIDER - (WIDER > 0 ? 1 : 0) - (WIDER > 7 ? 1 : 0)
                            - (WIDER > 11 ? 1 : 0);
  localparam SHIFT        = OUTPUT_BITS + P - F;

  // Half of the most that is left out, rounded to the lowest column that is kept.
  function [63:0] square_constant;
    input unused;
    reg [63:0] low, unit;
    begin
      low  = (64'd1 << SQUARE_CUT) - 64'd1;
      unit = 64'd2 << SQUARE_CUT;
      square_constant = LITE != 0 ? 64'd96 : (64'd3 * low * low + unit) / (64'd2 * unit) * unit;
    end
  endfunction

  function [63:0] product_constant;
    input unused;
    reg [63:0] one;
    integer a;
    begin
      one = 64'd1 << PRODUCT_CUT;
      product_constant = 64'd0;
      for (a = 0; a < PRODUCT_CUT; a = a + 2) product_constant = product_constant + one - (64'd1 << a);
      product_constant = (product_constant + one) / (64'd2 * one) * one + (64'd1 << (SHIFT - 1));
    end
  endfunction

  localparam [63:0] SQUARE_CONSTANT  = square_constant(1'b0);
  localparam [63:0] PRODUCT_CONSTANT = product_constant(1'b0);

  // Rank 1: signs and magnitudes, shifted up together.
  wire [3*P-1:0] magnitude, m0, m1, m4;
  wire [2:0]     negative0, negative4;
  wire           zero0, zero4;

  generate
    if (NEAR != 0) begin : unshifted  // one is 2^(P-1): twice the magnitude, saturated
      assign m0 = {(magnitude[2*P +: P] << 1) | {P{magnitude[3*P-1]}},
                   (magnitude[P +: P] << 1) | {P{magnitude[2*P-1]}},
                   (magnitude[0 +: P] << 1) | {P{magnitude[P-1]}}};
      assign zero0 = ~|magnitude;
    end else begin : shifted
      wrinkle_block_shift #(.BITS(P)) shift (.m_i(magnitude), .m_o(m0), .zero_o(zero0));
    end
  endgenerate

  wrinkle_delay #(.WIDTH(3*P), .RANKS(ALL)) rank1 (
    .clk(clk), .advance_i(advance_i), .data_i(m0), .data_o(m1));

  // Rank 2: the sum of squares.
  wire [3*SQUARE_BITS-1:0] leading;
  wire [2*SQUARE_BITS+1:0] s1, s2;

  wrinkle_truncated_squares #(
    .BITS(SQUARE_BITS), .CUT(SQUARE_CUT), .CONSTANT(SQUARE_CONSTANT[2*SQUARE_BITS+1:0])
  ) squares (.m_i(leading), .sum_o(s1));
  wrinkle_delay #(.WIDTH(2*SQUARE_BITS + 2), .RANKS(1)) rank2 (
    .clk(clk), .advance_i(advance_i), .data_i(s1), .data_o(s2));

  // Ranks 3 and 4: the reciprocal root of its leading bits.
  wire [INPUT_BITS-1:0]  t;
  wire                   halve;
  wire [OUTPUT_BITS:0]   r4;

  wrinkle_root_argument #(.NEAR(NEAR), .BITS(SQUARE_BITS), .INPUT_BITS(INPUT_BITS)) argument (
    .sum_i(s2), .t_o(t), .halve_o(halve));
  wrinkle_compact_rsqrt #(
    .INPUT_BITS(INPUT_BITS), .OUTPUT_BITS(OUTPUT_BITS), .SEGMENT_BITS(SEGMENT_BITS), .GUARD_BITS(GUARD_BITS),
    .BIAS(BIAS), .DROPPED_COLUMNS(DROPPED), .PIPELINED(PIPELINED)
  ) rsqrt (.clk(clk), .advance_i(advance_i), .t_i(t), .halve_i(halve), .r_o(r4));

  // Beside them: magnitudes and signs.
  wrinkle_delay #(.WIDTH(3*P), .RANKS(ALL + 2)) carry_magnitudes (
    .clk(clk), .advance_i(advance_i), .data_i(m1), .data_o(m4));
  wrinkle_delay #(.WIDTH(4), .RANKS(2*ALL + 2)) carry_signs (
    .clk(clk), .advance_i(advance_i), .data_i({zero0, negative0}), .data_o({zero4, negative4}));

  // Rank 5: the products, rounded.
  wire [3*(F+2)-1:0] unit;

  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : component
      wire [V:0] m;
      wire [F:0] n;
      assign negative0[k] = vector_i[k*(V+2)+V+1];
      wrinkle_magnitude #(.BITS(V + 1)) absolute (.value_i(vector_i[k*(V+2) +: V+2]), .magnitude_o(m));
      if (PAD > 0) begin : padded
        assign magnitude[k*P +: P] = {m, {PAD{1'b0}}};
      end else begin : whole
        assign magnitude[k*P +: P] = m;
      end
      assign leading[k*SQUARE_BITS +: SQUARE_BITS] = m1[k*P+P-1 -: SQUARE_BITS];

      wrinkle_truncated_product #(
        .M_BITS(P), .R_BITS(OUTPUT_BITS + 1), .SHIFT(SHIFT), .RESULT_BITS(F + 1), .CUT(PRODUCT_CUT),
        .CONSTANT(PRODUCT_CONSTANT[SHIFT+F:0])
      ) multiply (.m_i(m4[k*P +: P]), .r_i(r4), .result_o(n));
      wrinkle_signed #(.BITS(F + 1)) sign (
        .magnitude_i(n), .negative_i(negative4[k]), .value_o(unit[k*(F+2) +: F+2]));
    end
  endgenerate

  wrinkle_delay #(.WIDTH(3*(F+2) + 1), .RANKS(ALL)) rank5 (
    .clk(clk), .advance_i(advance_i), .data_i({zero4, unit}), .data_o({zero_o, unit_o}));
endmodule
`default_nettype wire
