`default_nettype none
// Three magnitudes, shifted up together by the leading zeros of their OR; zero_o when there is none that is set.
// Combinational. A synthesis map may arrange the shifts.
module wrinkle_block_shift #(
  parameter BITS = 10
) (
  input  wire [3*BITS-1:0] m_i,
  output wire [3*BITS-1:0] m_o,
  output wire              zero_o
);
  localparam STAGES = BITS > 16 ? 5 : BITS > 8 ? 4 : 3;

  // All three move as one vector, since only zeros leave one for the next.
  genvar s;
  generate
    for (s = 0; s <= STAGES; s = s + 1) begin : stages
      wire [3*BITS-1:0] m;
      wire [BITS-1:0]   any;
      if (s == 0) begin : first
        assign m   = m_i;
        assign any = m_i[0 +: BITS] | m_i[BITS +: BITS] | m_i[2*BITS +: BITS];
      end else begin : next
        localparam HOP = 1 << (STAGES - s);
        wire move = ~|stages[s-1].any[BITS-1 -: HOP];
        assign m   = move ? stages[s-1].m << HOP : stages[s-1].m;
        assign any = move ? stages[s-1].any << HOP : stages[s-1].any;
      end
    end
  endgenerate

  assign m_o    = stages[STAGES].m;
  assign zero_o = ~stages[STAGES].any[BITS-1];
  wire unused_bits = &{1'b0, stages[STAGES].any};
endmodule
`default_nettype wire
