`default_nettype none
// R.E with R the reflection of L about N, without making R: 2 (N.L)(N.E) - L.E, clamped to [0, 1]; zero where the
// light is not above the surface. N.L and N.E are rounded to s1.F before their product. With NORMAL_IS_Z
// N is (0, 0, 1) and they are the z of L and E. Latency 4.
module wrinkle_reflection #(
  parameter NORMAL_IS_Z = 0,
  parameter UNIT_BITS   = 9,   // F
  parameter DOT_BITS    = 10   // DF, at most 2F
) (
  input  wire                       clk,
  input  wire                       advance_i,
  input  wire [3*(UNIT_BITS+2)-1:0] n_i,   // s1.F, x in the low bits
  input  wire [3*(UNIT_BITS+2)-1:0] l_i,
  input  wire [3*(UNIT_BITS+2)-1:0] e_i,
  output wire [DOT_BITS:0]          re_o   // u1.DF
);
  localparam F       = UNIT_BITS;
  localparam W       = F + 2;
  localparam SUM     = 2 * W + 2;
  localparam SHIFT   = 2 * F - DOT_BITS;
  localparam R_BITS  = SUM + 1;
  localparam ROUNDED = R_BITS - SHIFT + 1;

  // Rank 2: a = N.L and b = N.E in s1.F, not beyond one; L.E.
  wire [W-1:0]          a, b;
  wire                  lit;
  wire signed [SUM-1:0] le;
  reg signed [W-1:0]    a_q, b_q;
  reg                   lit_q;
  reg signed [SUM-1:0]  le_q;

  wrinkle_dot #(.UNIT_BITS(F)) dot_le (.clk(clk), .advance_i(advance_i), .a_i(l_i), .b_i(e_i), .dot_o(le));

  generate
    if (NORMAL_IS_Z != 0) begin : along_z
      wire [2*W-1:0] z;
      wire signed [W-1:0] lz = z[0 +: W];
      wire unused_n = &{1'b0, n_i};
      wrinkle_delay #(.WIDTH(2*W), .RANKS(1)) delay (
        .clk(clk), .advance_i(advance_i), .data_i({e_i[2*W +: W], l_i[2*W +: W]}), .data_o(z));
      wrinkle_saturate #(.VALUE_BITS(W), .RESULT_BITS(W), .MINIMUM(-(1 << F)), .MAXIMUM(1 << F)) saturate_a (
        .value_i(z[0 +: W]), .result_o(a));
      wrinkle_saturate #(.VALUE_BITS(W), .RESULT_BITS(W), .MINIMUM(-(1 << F)), .MAXIMUM(1 << F)) saturate_b (
        .value_i(z[W +: W]), .result_o(b));
      assign lit = lz > 0;
    end else begin : general
      wire signed [SUM-1:0]   nl, ne;
      wire signed [SUM-F:0]   nl_rounded, ne_rounded;
      wrinkle_dot #(.UNIT_BITS(F)) dot_nl (.clk(clk), .advance_i(advance_i), .a_i(n_i), .b_i(l_i), .dot_o(nl));
      wrinkle_dot #(.UNIT_BITS(F)) dot_ne (.clk(clk), .advance_i(advance_i), .a_i(n_i), .b_i(e_i), .dot_o(ne));
      wrinkle_round_half_up #(.VALUE_BITS(SUM), .SHIFT(F), .RESULT_BITS(SUM - F + 1)) round_a (
        .value_i(nl), .result_o(nl_rounded));
      wrinkle_round_half_up #(.VALUE_BITS(SUM), .SHIFT(F), .RESULT_BITS(SUM - F + 1)) round_b (
        .value_i(ne), .result_o(ne_rounded));
      wrinkle_saturate #(
        .VALUE_BITS(SUM - F + 1), .RESULT_BITS(W), .MINIMUM(-(1 << F)), .MAXIMUM(1 << F)
      ) saturate_a (.value_i(nl_rounded), .result_o(a));
      wrinkle_saturate #(
        .VALUE_BITS(SUM - F + 1), .RESULT_BITS(W), .MINIMUM(-(1 << F)), .MAXIMUM(1 << F)
      ) saturate_b (.value_i(ne_rounded), .result_o(b));
      assign lit = nl > 0;
    end
  endgenerate

  // Rank 3: r = 2 a b - L.E.
  wire signed [2*W-1:0]     ab;
  wire signed [R_BITS-1:0]  r = {{2{ab[2*W-1]}}, ab, 1'b0} - {le_q[SUM-1], le_q};
  reg signed [R_BITS-1:0]   r_q;
  reg                       lit3_q;
  wrinkle_multiply #(.A_BITS(W), .B_BITS(W)) multiply (.a_i(a_q), .b_i(b_q), .product_o(ab));

  // Rank 4.
  wire signed [ROUNDED-1:0] rounded;
  wire [DOT_BITS:0]         re;
  reg [DOT_BITS:0]          re_q;
  wrinkle_round_half_up #(.VALUE_BITS(R_BITS), .SHIFT(SHIFT), .RESULT_BITS(ROUNDED)) round (
    .value_i(r_q), .result_o(rounded));
  wrinkle_saturate #(
    .VALUE_BITS(ROUNDED), .RESULT_BITS(DOT_BITS + 1), .MINIMUM(0), .MAXIMUM(1 << DOT_BITS)
  ) saturate (.value_i(rounded), .result_o(re));

  assign re_o = re_q;

  always @(posedge clk)
    if (advance_i) begin
      a_q    <= a;
      b_q    <= b;
      lit_q  <= lit;
      le_q   <= le;
      r_q    <= r;
      lit3_q <= lit_q;
      re_q   <= lit3_q ? re : {(DOT_BITS + 1){1'b0}};
    end
endmodule
`default_nettype wire
