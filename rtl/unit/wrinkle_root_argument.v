`default_nettype none
// T, the leading bits of a sum of squares for wrinkle_compact_rsqrt, and whether its result is to be halved. Combinational.
// NEAR 0: S at least 2^(2 BITS - 2). NEAR 1: lengths of 1/2 to 1 are S from there to 2^(2 BITS); others saturate.
module wrinkle_root_argument #(
  parameter NEAR       = 0,
  parameter BITS       = 10,  // of the magnitudes that were squared
  parameter INPUT_BITS = 12   // SB + 1
) (
  input  wire [2*BITS+1:0]     sum_i,
  output wire [INPUT_BITS-1:0] t_o,
  output wire                  halve_o
);
  wire over = |sum_i[2*BITS+1 -: 2];
  wire [INPUT_BITS-1:0] low = sum_i[2*BITS-1 -: INPUT_BITS];
  wire unused_low = &{1'b0, sum_i};

  generate
    if (NEAR != 0) begin : near_unit
      wire under = ~|low[INPUT_BITS-1 -: 2];
      assign t_o[INPUT_BITS-1]   = low[INPUT_BITS-1] | over;
      assign t_o[INPUT_BITS-2]   = low[INPUT_BITS-2] | over | under;
      assign t_o[INPUT_BITS-3:0] = (low[INPUT_BITS-3:0] & {(INPUT_BITS - 2){~under}}) | {(INPUT_BITS - 2){over}};
      assign halve_o = 1'b0;
    end else begin : any_length
      assign t_o     = over ? sum_i[2*BITS+1 -: INPUT_BITS] : low;
      assign halve_o = over;
    end
  endgenerate
endmodule
`default_nettype wire
