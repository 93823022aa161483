`default_nettype none
// rtl/lib/wrinkle_table.v as a read-only memory, which Yosys maps well.
module wrinkle_table #(
  parameter INDEX_BITS = 5,
  parameter ENTRY_BITS = 32,
  parameter [(ENTRY_BITS<<INDEX_BITS)-1:0] CONTENT = 0
) (
  input  wire [INDEX_BITS-1:0] index_i,
  output wire [ENTRY_BITS-1:0] entry_o
);
  reg [ENTRY_BITS-1:0] memory_q [0:(1<<INDEX_BITS)-1];
  integer i;
  initial for (i = 0; i < 1 << INDEX_BITS; i = i + 1) memory_q[i] = CONTENT[i*ENTRY_BITS +: ENTRY_BITS];

  assign entry_o = memory_q[index_i];
endmodule
`default_nettype wire
