`default_nettype none
// Memory of a first-in first-out buffer, one payload word: written on the clock, read at once. Steered by wrinkle_fifo.
module wrinkle_fifo_memory #(
  parameter ADDRESS_BITS = 4,
  parameter WIDTH = 36
) (
  input  wire                    clk,
  input  wire                    push_i,
  input  wire [ADDRESS_BITS-1:0] write_i,
  input  wire [ADDRESS_BITS-1:0] read_i,
  input  wire [WIDTH-1:0]        data_i,
  output wire [WIDTH-1:0]        data_o
);
  reg [WIDTH-1:0] memory_q [0:(1<<ADDRESS_BITS)-1];

  assign data_o = memory_q[read_i];

  always @(posedge clk)
    if (push_i) memory_q[write_i] <= data_i;
endmodule
`default_nettype wire
