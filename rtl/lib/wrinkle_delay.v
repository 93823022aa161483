`default_nettype none
// Carries a word beside a pipeline of RANKS registers; RANKS = 0 is a wire. Latency RANKS. Steered by a wrinkle_pipe.
module wrinkle_delay #(
  parameter WIDTH = 36,
  parameter RANKS = 2
) (
  input  wire             clk,
  input  wire             advance_i,
  input  wire [WIDTH-1:0] data_i,
  output wire [WIDTH-1:0] data_o
);
  genvar k;
  generate
    if (RANKS == 0) begin : none
      wire unused_pins = &{1'b0, clk, advance_i};
      assign data_o = data_i;
    end else begin : some
      for (k = 0; k < RANKS; k = k + 1) begin : rank
        reg [WIDTH-1:0] data_q;
        if (k == 0) begin : first
          always @(posedge clk) if (advance_i) data_q <= data_i;
        end else begin : later
          always @(posedge clk) if (advance_i) data_q <= rank[k-1].data_q;
        end
      end
      assign data_o = rank[RANKS-1].data_q;
    end
  endgenerate
endmodule
`default_nettype wire
