`default_nettype none
// First-in first-out buffer of 2^ADDRESS_BITS entries, control half. One wrinkle_fifo_memory a payload word hangs on
// it. Ready depends on the fill count alone, so the buffer cuts the ready chain. Latency 1, one push and one pop a
// clock; a full buffer does not take a word on the clock it gives one.
module wrinkle_fifo #(
  parameter ADDRESS_BITS = 4
) (
  input  wire                    clk,
  input  wire                    rst,
  input  wire                    push_i,       // only while ready_o
  output wire                    ready_o,
  output wire                    valid_o,
  input  wire                    pop_i,        // only while valid_o
  output wire [ADDRESS_BITS-1:0] write_o,      // where the pushed word goes
  output wire [ADDRESS_BITS-1:0] read_o        // where the oldest word stands
);
  reg [ADDRESS_BITS-1:0] write_q, read_q;
  reg [ADDRESS_BITS:0]   count_q;

  assign ready_o = ~count_q[ADDRESS_BITS];
  assign valid_o = |count_q;
  assign write_o = write_q;
  assign read_o  = read_q;

  always @(posedge clk)
    if (rst) begin
      write_q <= {ADDRESS_BITS{1'b0}};
      read_q  <= {ADDRESS_BITS{1'b0}};
      count_q <= {(ADDRESS_BITS + 1){1'b0}};
    end else begin
      if (push_i) write_q <= write_q + 1'b1;
      if (pop_i) read_q <= read_q + 1'b1;
      if (push_i & ~pop_i) count_q <= count_q + 1'b1;
      if (pop_i & ~push_i) count_q <= count_q - 1'b1;
    end
endmodule
`default_nettype wire
