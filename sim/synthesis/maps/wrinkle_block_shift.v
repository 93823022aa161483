`default_nettype none
// rtl/unit/wrinkle_block_shift.v, arranged: the zeros are counted and shifted out stage by stage. A stage moves by HOP
// places when the top HOP bits of all three are 0: where a moved bit meets one of those, an OR takes the place of the
// multiplexer.
module wrinkle_block_shift #(
  parameter BITS = 10
) (
  input  wire [3*BITS-1:0] m_i,
  output wire [3*BITS-1:0] m_o,
  output wire              zero_o
);
  localparam STAGES = BITS > 16 ? 5 : BITS > 8 ? 4 : 3;

  genvar s, i, k;
  generate
    for (s = 0; s <= STAGES; s = s + 1) begin : stages
      wire [4*BITS-1:0] m;  // the three and their OR
      if (s == 0) begin : first
        assign m = {m_i[0 +: BITS] | m_i[BITS +: BITS] | m_i[2*BITS +: BITS], m_i};
      end else begin : next
        localparam HOP = 1 << (STAGES - s);
        wire move = ~|stages[s-1].m[4*BITS-1 -: HOP];
        for (k = 0; k < 4; k = k + 1) begin : value
          for (i = 0; i < BITS; i = i + 1) begin : place
            if (i >= HOP && i >= BITS - HOP) begin : top
              assign m[k*BITS+i] = stages[s-1].m[k*BITS+i] | (move & stages[s-1].m[k*BITS+i-HOP]);
            end else if (i >= HOP) begin : middle
              assign m[k*BITS+i] = move ? stages[s-1].m[k*BITS+i-HOP] : stages[s-1].m[k*BITS+i];
            end else begin : bottom
              assign m[k*BITS+i] = ~move & stages[s-1].m[k*BITS+i];
            end
          end
        end
      end
    end
  endgenerate

  assign m_o    = stages[STAGES].m[3*BITS-1:0];
  assign zero_o = ~stages[STAGES].m[4*BITS-1];
  wire unused_or = &{1'b0, stages[STAGES].m};
endmodule
`default_nettype wire
