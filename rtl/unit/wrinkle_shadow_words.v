`default_nettype none
// Shadow register of a packet: words shift in at the top, and after WORDS of them every field stands at its place, the
// first word in the low bits. Not reset: whoever shifts counts the words.
module wrinkle_shadow_words #(
  parameter WORDS = 5
) (
  input  wire                clk,
  input  wire                shift_i,
  input  wire [63:0]         word_i,
  output wire [64*WORDS-1:0] words_o
);
  genvar k;
  generate
    for (k = 0; k < WORDS; k = k + 1) begin : word
      reg [63:0] word_q;
      assign words_o[64*k +: 64] = word_q;
      if (k == WORDS - 1) begin : entry
        always @(posedge clk) if (shift_i) word_q <= word_i;
      end else begin : from_above
        always @(posedge clk) if (shift_i) word_q <= word[k+1].word_q;
      end
    end
  endgenerate
endmodule
`default_nettype wire
