`default_nettype none
// value / q, with r the reciprocal of q << zeros: round_half_up(value * r, R - zeros), modulo 2^WIDTH.
// Shifting the product up by `zeros` first leaves one constant rounding. Latency 2. `zeros` is at most R.
module wrinkle_quotient #(
  parameter WIDTH           = 22,
  parameter RECIPROCAL_BITS = 18  // R
) (
  input  wire                     clk,
  input  wire                     advance_i,
  input  wire signed [WIDTH-1:0]  value_i,
  input  wire [RECIPROCAL_BITS:0] r_i,      // u1.R
  input  wire [4:0]               zeros_i,
  output wire [WIDTH-1:0]         quotient_o
);
  localparam PRODUCT = WIDTH + RECIPROCAL_BITS + 2;

  wire signed [PRODUCT-1:0] product;
  reg signed [PRODUCT-1:0]  product_q;
  reg [4:0]                 zeros_q;
  reg [WIDTH-1:0]           quotient_q;
  wire [WIDTH-1:0]          quotient;

  wrinkle_multiply #(.A_BITS(WIDTH), .B_BITS(RECIPROCAL_BITS + 2)) multiply (
    .a_i(value_i), .b_i({1'b0, r_i}), .product_o(product));
  wrinkle_round_half_up #(.VALUE_BITS(PRODUCT), .SHIFT(RECIPROCAL_BITS), .RESULT_BITS(WIDTH)) round (
    .value_i(product_q << zeros_q), .result_o(quotient));

  assign quotient_o = quotient_q;

  always @(posedge clk)
    if (advance_i) begin
      product_q  <= product;
      zeros_q    <= zeros_i;
      quotient_q <= quotient;
    end
endmodule
`default_nettype wire
