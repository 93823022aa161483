`default_nettype none
// x to the power of two 2^squarings, or to the power of zero: one squarer a rank, SQUARINGS of them, each rounded.
// Latency SQUARINGS.
module wrinkle_power #(
  parameter POWER_BITS = 12,  // PF
  parameter SQUARINGS  = 5    // K
) (
  input  wire                clk,
  input  wire                advance_i,
  input  wire [3:0]          squarings_i,      // draw state, at most K
  input  wire                exponent_zero_i,
  input  wire [POWER_BITS:0] x_i,              // u1.PF, at most one
  output wire [POWER_BITS:0] power_o           // u1.PF, at most one
);
  genvar k;
  wire [POWER_BITS:0] power;
  generate
    if (SQUARINGS == 0) begin : none
      wire unused_pins = &{1'b0, clk, advance_i, squarings_i};
      assign power = x_i;
    end else begin : some
      for (k = 0; k < SQUARINGS; k = k + 1) begin : rank
        wire [POWER_BITS:0] p, squared;
        reg [POWER_BITS:0]  p_q;
        if (k == 0) begin : first
          assign p = x_i;
        end else begin : later
          assign p = rank[k-1].p_q;
        end
        wrinkle_scale #(.BITS(POWER_BITS + 1), .FRACTION_BITS(POWER_BITS)) square (
          .a_i(p), .b_i(p), .result_o(squared));
        always @(posedge clk) if (advance_i) p_q <= squarings_i > k ? squared : p;
      end
      assign power = rank[SQUARINGS-1].p_q;
    end
  endgenerate

  assign power_o = exponent_zero_i ? {1'b1, {POWER_BITS{1'b0}}} : power;
endmodule
`default_nettype wire
