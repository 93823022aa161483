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
  reg [64*WORDS-1:0] words_q;

  assign words_o = words_q;

  generate
    if (WORDS == 1) begin : single
      always @(posedge clk) if (shift_i) words_q <= word_i;
    end else begin : several
      always @(posedge clk) if (shift_i) words_q <= {word_i, words_q[64*WORDS-1:64]};
    end
  endgenerate
endmodule
`default_nettype wire
