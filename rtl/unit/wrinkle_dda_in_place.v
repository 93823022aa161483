`default_nettype none
// One interpolated component whose packet fields are its registers: a digital differential analyser like wrinkle_dda
// without a second set of them, so that the next packet comes only after the last pixel of this one. Its fields
// {dw, row, value of the row} start in bit PLACE of the planes part; beside them stands the value at the pixel.
// SHARING 0: an adder for each sum. 1: one adder, and the walk of wrinkle_scan tells at most one of its sums a clock:
// `step` adds row to the row's value, `carry` dw, `pixel` dw to the pixel's value, `span` nothing to the row's value.
// All values modulo 2^(WIDTH + GUARD). Latency 0 from its registers. Does not clamp. The sums are functions, since a
// simulator makes those only in the clocks that take them.
module wrinkle_dda_in_place #(
  parameter WIDTH   = 12,
  parameter GUARD   = 10,
  parameter SHARING = 0,
  parameter WORDS   = 3,
  parameter PLACE   = 0
) (
  input  wire             clk,
  input  wire [WORDS-1:0] words_i,  // the bit of a word of the planes part, which word_i is, never during a walk
  input  wire [63:0]      word_i,
  input  wire             step_i,   // the walk
  input  wire             carry_i,
  input  wire             span_i,
  input  wire             pixel_i,
  output wire [WIDTH-1:0] value_o
);
  localparam BITS = WIDTH + GUARD;

`include "wrinkle_written.vh"

  reg [BITS-1:0] row_value_q, row_q, dw_q, value_q;
  wire           to_row   = SHARING != 0 ? (step_i | carry_i) & ~pixel_i : step_i;
  wire           to_pixel = span_i | pixel_i;
  wire unused_guard = &{1'b0, value_q};
  assign value_o = value_q[BITS-1:GUARD];

  function [BITS-1:0] row_sum;
    input step, carry;
    if (SHARING != 0) row_sum = row_value_q + (({BITS{step}} & row_q) | ({BITS{carry}} & dw_q));
    else row_sum = row_value_q + row_q + (carry ? dw_q : {BITS{1'b0}});
  endfunction

  function [BITS-1:0] pixel_sum;
    input span, pixel, step, carry;
    if (SHARING != 0)
      pixel_sum = (pixel ? value_q : row_value_q) + (({BITS{step}} & row_q) | ({BITS{carry | pixel}} & dw_q));
    else pixel_sum = span ? row_value_q : value_q + dw_q;
  endfunction

  always @(posedge clk) if (to_pixel) value_q <= pixel_sum(span_i, pixel_i, step_i, carry_i);
  always @(posedge clk) begin
    if (to_row | (|words_i))
      row_value_q <= written(to_row ? row_sum(step_i, carry_i) : row_value_q, PLACE, {1'b0, words_i}, word_i);
    if (|words_i) begin
      row_q <= written(row_q, PLACE + BITS, {1'b0, words_i}, word_i);
      dw_q  <= written(dw_q, PLACE + 2 * BITS, {1'b0, words_i}, word_i);
    end
  end
endmodule
`default_nettype wire
