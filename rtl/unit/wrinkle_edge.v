`default_nettype none
// One bound of the walk: floor of a line at each row, exact, by a digital differential analyser with remainder.
//   r += remainder_step;  carry = (r >= 0);  if (carry) r -= denominator;  w += step + carry
// with r in [-denominator, -1] and remainder_step in [0, denominator). Latency 0 from its registers.
module wrinkle_edge #(
  parameter SCREEN_BITS = 10,
  parameter EDGE_BITS   = 20
) (
  input  wire                          clk,
  input  wire                          load_i,
  input  wire                          step_i,
  input  wire [2*SCREEN_BITS+3*EDGE_BITS+4:0] fields_i,  // {denominator, remainder_step, remainder, step, w}
  output wire signed [SCREEN_BITS+1:0] w_o,
  output wire                          carry_o            // the next step moves one pixel more
);
  localparam W_BITS = SCREEN_BITS + 2;

  reg signed [W_BITS-1:0]  w_q, step_q;
  reg signed [EDGE_BITS:0] remainder_q;
  reg [EDGE_BITS-1:0]      remainder_step_q, denominator_q;

  wire signed [EDGE_BITS:0] sum = remainder_q + $signed({1'b0, remainder_step_q});

  assign w_o     = w_q;
  assign carry_o = ~sum[EDGE_BITS];

  always @(posedge clk)
    if (load_i) begin
      {denominator_q, remainder_step_q, remainder_q, step_q, w_q} <= fields_i;
    end else if (step_i) begin
      remainder_q <= carry_o ? sum - $signed({1'b0, denominator_q}) : sum;
      w_q         <= w_q + step_q + $signed({{(W_BITS - 1){1'b0}}, carry_o});
    end
endmodule
`default_nettype wire
