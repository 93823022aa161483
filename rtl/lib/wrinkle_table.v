`default_nettype none
// A table of constants: entry number index of CONTENT, that of index 0 in the low bits. Combinational. A synthesis map
// may make a read-only memory of it.
module wrinkle_table #(
  parameter INDEX_BITS = 5,
  parameter ENTRY_BITS = 32,
  parameter [(ENTRY_BITS<<INDEX_BITS)-1:0] CONTENT = 0
) (
  input  wire [INDEX_BITS-1:0] index_i,
  output wire [ENTRY_BITS-1:0] entry_o
);
  wire [ENTRY_BITS-1:0] entries [0:(1<<INDEX_BITS)-1];
  genvar i;
  generate
    for (i = 0; i < 1 << INDEX_BITS; i = i + 1) begin : entry
      assign entries[i] = CONTENT[i*ENTRY_BITS +: ENTRY_BITS];
    end
  endgenerate

  assign entry_o = entries[index_i];
endmodule
`default_nettype wire
