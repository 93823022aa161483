`default_nettype none
// Valid bits of an elastic pipeline of RANKS registers. All ranks move together on `advance_o`: whenever the last one
// is empty or is being taken. Data registers beside it load on advance_o and need no reset. Latency RANKS. Does not cut
// the ready path (wrinkle_skid does) and does not close gaps between fragments.
module wrinkle_pipe #(
  parameter RANKS = 2
) (
  input  wire clk,
  input  wire rst,
  input  wire in_valid_i,
  output wire advance_o,   // also the ready of the input
  output wire out_valid_o,
  input  wire out_ready_i,
  output wire busy_o
);
  reg [RANKS-1:0] valid_q;

  assign advance_o   = out_ready_i | ~valid_q[RANKS-1];
  assign out_valid_o = valid_q[RANKS-1];
  assign busy_o      = |valid_q;

  generate
    if (RANKS == 1) begin : single
      always @(posedge clk)
        if (rst) valid_q <= 1'b0;
        else if (advance_o) valid_q <= in_valid_i;
    end else begin : several
      always @(posedge clk)
        if (rst) valid_q <= {RANKS{1'b0}};
        else if (advance_o) valid_q <= {valid_q[RANKS-2:0], in_valid_i};
    end
  endgenerate
endmodule
`default_nettype wire
