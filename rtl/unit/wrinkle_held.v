`default_nettype none
// A packet field that is held over a triangle: it has the same value at every pixel. BUFFERING double: the field is
// copied from the shadow to the row engine when that takes the packet, and to the pixel engine with the packet's first
// row, since the pixel engine may still draw the triangle before. single: the field's part of the packet is its
// register, and stays until the last pixel. Latency 0 from its registers.
module wrinkle_held #(
  parameter WIDTH     = 9,
  parameter BUFFERING = 0,
  parameter WORDS     = 3,
  parameter PLACE     = 0  // of its part of the packet in the planes part
) (
  input  wire             clk,
  input  wire             load_i,    // the row engine takes the packet
  input  wire             take_i,    // the pixel engine takes its first row
  input  wire [WIDTH-1:0] shadow_i,  // double: this part of the shadow
  input  wire [WORDS-1:0] words_i,   // single: the bit of a word of the planes part, which word_i is
  input  wire [63:0]      word_i,
  output wire [WIDTH-1:0] value_o
);
  reg [WIDTH-1:0] value_q;
  assign value_o = value_q;

  generate
    if (BUFFERING != 0) begin : single
      wire unused_pins = &{1'b0, load_i, take_i, shadow_i};
      localparam BITS = WIDTH;
`include "wrinkle_written.vh"
      always @(posedge clk) if (|words_i) value_q <= written(value_q, PLACE, {1'b0, words_i}, word_i);
    end else begin : double
      reg [WIDTH-1:0] row_value_q;
      wire unused_pins = &{1'b0, words_i, word_i};
      always @(posedge clk) begin
        if (load_i) row_value_q <= shadow_i;
        if (take_i) value_q <= row_value_q;
      end
    end
  endgenerate
endmodule
`default_nettype wire
