`default_nettype none
// One column of a bit heap: COUNT bits of one weight become one bit of it and COUNT/2 carries, by full adders and at
// most one half adder, the oldest bits first. The adders are cells from here on: no later pass has to find them among
// gates. Combinational.
module wrinkle_bit_heap_column #(
  parameter COUNT = 5
) (
  input  wire [COUNT-1:0]                          bits_i,
  output wire                                      sum_o,
  output wire [(COUNT > 1 ? COUNT / 2 : 1)-1:0]    carry_o
);
  localparam ADDERS = COUNT / 2;

  // Bit number e of the queue: the COUNT bits that came, then the sums of the adders. Adder j takes three, or, as the
  // last one of an even count, the two that are left.
  genvar j;
  generate
    for (j = 0; j < ADDERS; j = j + 1) begin : adders
      wire a, b, c, sum;
      if (3 * j < COUNT)          assign a = bits_i[3*j];
      else                        assign a = adders[3*j-COUNT].sum;
      if (3 * j + 1 < COUNT)      assign b = bits_i[3*j+1];
      else                        assign b = adders[3*j+1-COUNT].sum;
      if (3 * j + 2 >= COUNT + ADDERS - (COUNT % 2 == 0 ? 1 : 0)) assign c = 1'b0;
      else if (3 * j + 2 < COUNT) assign c = bits_i[3*j+2];
      else                        assign c = adders[3*j+2-COUNT].sum;
      \$fa #(.WIDTH(1)) adder (.A(a), .B(b), .C(c), .X(carry_o[j]), .Y(sum));
    end
    if (ADDERS == 0) begin : single
      assign sum_o = bits_i[0];
      assign carry_o = 1'b0;
    end else begin : last
      assign sum_o = adders[ADDERS-1].sum;
    end
  endgenerate
endmodule
`default_nettype wire
