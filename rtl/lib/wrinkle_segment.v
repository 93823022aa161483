`default_nettype none
// One linear segment of a table: min(((base << N) - slope * dx) >> (N + GUARD), 2^(RESULT_BITS) - 1), the result u1.
// Combinational, one multiplier; N = 0 has none. [golden/pixel/rsqrt.h, golden/pixel/reciprocal.h]
module wrinkle_segment #(
  parameter BASE_BITS   = 12,
  parameter SLOPE_BITS  = 7,
  parameter N           = 5,
  parameter GUARD       = 1,
  parameter RESULT_BITS = 10
) (
  input  wire [BASE_BITS-1:0]       base_i,
  input  wire [SLOPE_BITS-1:0]      slope_i,
  input  wire [(N > 0 ? N : 1)-1:0] dx_i,
  output wire [RESULT_BITS-1:0]     result_o
);
  wire [BASE_BITS+N-1:0] line;

  generate
    if (N > 0) begin : slanted
      localparam EXTRA = BASE_BITS - SLOPE_BITS;
      wire [SLOPE_BITS+N-1:0] fall;
      wrinkle_multiply_unsigned #(.A_BITS(SLOPE_BITS), .B_BITS(N)) multiply (
        .a_i(slope_i), .b_i(dx_i), .product_o(fall));
      assign line = {base_i, {N{1'b0}}} - {{EXTRA{1'b0}}, fall};
    end else begin : flat
      wire unused_pins = &{1'b0, slope_i, dx_i};
      assign line = base_i;
    end
  endgenerate

  wire over = |line[BASE_BITS+N-1 : N+GUARD+RESULT_BITS];
  wire unused_low = &{1'b0, line};
  assign result_o = over ? {RESULT_BITS{1'b1}} : line[N+GUARD +: RESULT_BITS];
endmodule
`default_nettype wire
