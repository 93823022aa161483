`default_nettype none
// A vector that is normalized after its dot products: mantissa, of the F leading bits of each shifted magnitude, and
// scale, the reciprocal of the mantissa's length. Zero has a mantissa of zero and a scale as any other. Latency 4.
// [docs/architecture.md]
module wrinkle_deferred_vector #(
  parameter VECTOR_BITS = 9,  // V
  parameter UNIT_BITS   = 9,  // F
  parameter SCALE_BITS  = UNIT_BITS == 15 ? 17 : UNIT_BITS + 1  // RB, of the above
) (
  input  wire                         clk,
  input  wire                         advance_i,
  input  wire [3*(VECTOR_BITS+2)-1:0] vector_i,    // s1.V each, x in the low bits
  output wire [3*(UNIT_BITS+1)-1:0]   mantissa_o,  // s0.F each, the greatest at least 1/2
  output wire [SCALE_BITS:0]          scale_o,     // u1.RB
  output wire                         zero_o
);
  localparam N = UNIT_BITS + 1;
  localparam M = VECTOR_BITS < UNIT_BITS ? VECTOR_BITS + 1 : UNIT_BITS;

  wire [3*M-1:0]      m;
  wire [2:0]          negative;
  wire [SCALE_BITS:0] r;
  wire                halve;

  wrinkle_reciprocal_length #(
    .VECTOR_BITS(VECTOR_BITS), .UNIT_BITS(UNIT_BITS), .MANTISSA_BITS(M), .COMPLEMENT(1),
    .OUTPUT_BITS(SCALE_BITS)
  ) reciprocal_length (
    .clk(clk), .advance_i(advance_i), .vector_i(vector_i), .m_o(m), .negative_o(negative), .r_o(r), .halve_o(halve),
    .zero_o(zero_o));

  assign scale_o = halve ? {1'b0, r[SCALE_BITS:1]} : r;

  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : component
      if (M < UNIT_BITS) begin : padded
        assign mantissa_o[k*N +: N] = {negative[k], m[k*M +: M], {(UNIT_BITS - M){1'b0}}};
      end else begin : whole
        assign mantissa_o[k*N +: N] = {negative[k], m[k*M +: M]};
      end
    end
  endgenerate
endmodule
`default_nettype wire
