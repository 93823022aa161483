`default_nettype none
// rtl/unit/wrinkle_dda_in_place.v with its sums as wires, of which one adder makes those that share it, and without the
// condition that a word comes, which a gate does not need.
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
  wire [BITS-1:0] next_row_value, next_value;
  wire            to_row, to_pixel;

  wire unused_guard = &{1'b0, value_q};
  assign value_o  = value_q[BITS-1:GUARD];

  generate
    if (SHARING != 0) begin : one_adder
      wire [BITS-1:0] from  = pixel_i ? value_q : row_value_q;
      wire [BITS-1:0] delta = ({BITS{step_i}} & row_q) | ({BITS{carry_i | pixel_i}} & dw_q);
      wire [BITS-1:0] sum   = from + delta;
      assign next_row_value = sum;
      assign next_value     = sum;
      assign to_row         = (step_i | carry_i) & ~pixel_i;
      assign to_pixel       = span_i | pixel_i;
    end else begin : adders
      assign next_row_value = row_value_q + row_q + (carry_i ? dw_q : {BITS{1'b0}});
      assign next_value     = span_i ? row_value_q : value_q + dw_q;
      assign to_row         = step_i;
      assign to_pixel       = span_i | pixel_i;
    end
  endgenerate

  always @(posedge clk) begin
    row_value_q <= written(to_row ? next_row_value : row_value_q, PLACE, {1'b0, words_i}, word_i);
    row_q       <= written(row_q, PLACE + BITS, {1'b0, words_i}, word_i);
    dw_q        <= written(dw_q, PLACE + 2 * BITS, {1'b0, words_i}, word_i);
    if (to_pixel) value_q <= next_value;
  end
endmodule
`default_nettype wire
