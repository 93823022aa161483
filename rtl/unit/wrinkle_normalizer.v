`default_nettype none
// A vector to unit length, faithfully rounded (< 1 ulp), odd-symmetric, exact on the axes; zero stays zero. Each
// component is the product of mantissa and reciprocal length by wrinkle_reciprocal_length, rounded, with its sign put
// back. Latency 5, or 2 with PIPELINED 2. [docs/architecture.md, golden/pixel/rsqrt.h]
module wrinkle_normalizer #(
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
  localparam F           = UNIT_BITS;
  localparam P           = VECTOR_BITS + 1;
  localparam OUTPUT_BITS = F == 15 ? 17 : F + 1;

  // Ranks 1 to 4.
  wire [3*P-1:0]       m4;
  wire [2:0]           negative4;
  wire [OUTPUT_BITS:0] r4;
  wire                 e4, zero4;

  wrinkle_reciprocal_length #(
    .VECTOR_BITS(VECTOR_BITS), .UNIT_BITS(F), .MANTISSA_BITS(P), .PIPELINED(PIPELINED), .OUTPUT_BITS(OUTPUT_BITS)
  ) reciprocal_length (
    .clk(clk), .advance_i(advance_i), .vector_i(vector_i), .m_o(m4), .negative_o(negative4), .r_o(r4), .halve_o(e4),
    .zero_o(zero4));

  // Rank 5: the products, rounded.
  wire [3*(F+2)-1:0] unit;

  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : component
      wire [P+OUTPUT_BITS:0] product;
      wire signed [F+1:0]    rounded;
      wrinkle_multiply_unsigned #(.A_BITS(P), .B_BITS(OUTPUT_BITS + 1)) multiply (
        .a_i(m4[k*P +: P]), .b_i(r4), .product_o(product));
      wrinkle_round_half_up #(
        .VALUE_BITS(P + OUTPUT_BITS + 3), .SHIFT(P + 1 + OUTPUT_BITS - F), .RESULT_BITS(F + 2)
      ) round (.value_i(e4 ? {2'b00, product} : {1'b0, product, 1'b0}), .result_o(rounded));
      assign unit[k*(F+2) +: F+2] = negative4[k] ? -rounded : rounded;
    end
  endgenerate

  wrinkle_delay #(.WIDTH(3*(F+2) + 1), .RANKS(PIPELINED == 1 ? 1 : 0)) rank5 (
    .clk(clk), .advance_i(advance_i), .data_i({zero4, unit}), .data_o({zero_o, unit_o}));
endmodule
`default_nettype wire
