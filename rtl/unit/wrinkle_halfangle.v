`default_nettype none
// The half-angle vector of a pixel: H = L + E in s2.F, to unit length by a normalizer of V = F + 1. Latency 6: one for the
// sum, then the normalizer's.
module wrinkle_halfangle #(
  parameter NORMALIZER = 1,
  parameter UNIT_BITS  = 9   // F
) (
  input  wire                       clk,
  input  wire                       advance_i,
  input  wire [3*(UNIT_BITS+2)-1:0] l_i,  // s1.F, x in the low bits
  input  wire [3*(UNIT_BITS+2)-1:0] e_i,
  output wire [3*(UNIT_BITS+2)-1:0] h_o   // s1.F
);
  localparam N = UNIT_BITS + 2;

  wire [3*(N+1)-1:0] sum;
  reg [3*(N+1)-1:0]  sum_q;
  wire unused_zero;

  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : component
      wire signed [N-1:0] l = l_i[k*N +: N];
      wire signed [N-1:0] e = e_i[k*N +: N];
      assign sum[k*(N+1) +: N+1] = {l[N-1], l} + {e[N-1], e};
    end
  endgenerate

  always @(posedge clk) if (advance_i) sum_q <= sum;

  wrinkle_unit_vector #(
    .NORMALIZER(NORMALIZER), .VECTOR_BITS(UNIT_BITS + 1), .UNIT_BITS(UNIT_BITS), .RANKS(5)
  ) unit_h (.clk(clk), .advance_i(advance_i), .vector_i(sum_q), .unit_o(h_o), .zero_o(unused_zero));
endmodule
`default_nettype wire
