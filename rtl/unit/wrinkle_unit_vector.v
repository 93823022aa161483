`default_nettype none
// One vector of the normalize stage: NORMALIZER 1 by wrinkle_normalizer, 2 to 4 by a wrinkle_compact_normalizer of that
// kind; 0 only rounded to s1.F and saturated, for a vector that is of unit length already. Latency RANKS, at least 5
// with a normalizer and 1 without; or 2 with a normalizer, three steps of about the same length.
module wrinkle_unit_vector #(
  parameter NORMALIZER  = 1,
  parameter VECTOR_BITS = 9,  // V
  parameter UNIT_BITS   = 9,   // F
  parameter RANKS       = 5
) (
  input  wire                         clk,
  input  wire                         advance_i,
  input  wire [3*(VECTOR_BITS+2)-1:0] vector_i,  // s1.V, x in the low bits
  output wire [3*(UNIT_BITS+2)-1:0]   unit_o,    // s1.F
  output wire                         zero_o     // the vector was zero
);
  localparam W = VECTOR_BITS + 2;
  localparam N = UNIT_BITS + 2;
  localparam LIMIT = 1 << (UNIT_BITS + 1);
  localparam ROUNDED = (VECTOR_BITS > UNIT_BITS ? W : N) + 1;

  genvar k;
  generate
    if (NORMALIZER != 0) begin : normalized
      wire [3*N-1:0] unit;
      wire           zero;
      if (NORMALIZER == 1) begin : faithful
        wrinkle_normalizer #(
          .VECTOR_BITS(VECTOR_BITS), .UNIT_BITS(UNIT_BITS), .PIPELINED(RANKS > 2 ? 1 : 2)
        ) normalizer (
          .clk(clk), .advance_i(advance_i), .vector_i(vector_i), .unit_o(unit), .zero_o(zero));
      end else begin : compact
        wrinkle_compact_normalizer #(
          .KIND(NORMALIZER), .VECTOR_BITS(VECTOR_BITS), .UNIT_BITS(UNIT_BITS), .PIPELINED(RANKS > 2 ? 1 : 2)
        ) normalizer (
          .clk(clk), .advance_i(advance_i), .vector_i(vector_i), .unit_o(unit), .zero_o(zero));
      end
      wrinkle_delay #(.WIDTH(3*N + 1), .RANKS(RANKS > 2 ? RANKS - 5 : 0)) delay (
        .clk(clk), .advance_i(advance_i), .data_i({zero, unit}), .data_o({zero_o, unit_o}));
    end else begin : none
      wire [3*N-1:0] unit;
      for (k = 0; k < 3; k = k + 1) begin : component
        wire signed [ROUNDED-1:0] rounded;
        wrinkle_round_half_up #(
          .VALUE_BITS(W), .SHIFT(VECTOR_BITS - UNIT_BITS), .RESULT_BITS(ROUNDED)
        ) round (.value_i(vector_i[k*W +: W]), .result_o(rounded));
        wrinkle_saturate #(
          .VALUE_BITS(ROUNDED), .RESULT_BITS(N), .MINIMUM(-LIMIT), .MAXIMUM(LIMIT - 1)
        ) saturate (.value_i(rounded), .result_o(unit[k*N +: N]));
      end
      wrinkle_delay #(.WIDTH(3*N + 1), .RANKS(RANKS)) delay (
        .clk(clk), .advance_i(advance_i), .data_i({~|vector_i, unit}), .data_o({zero_o, unit_o}));
    end
  endgenerate
endmodule
`default_nettype wire
