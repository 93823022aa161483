`default_nettype none
// One interpolated component with its part of the packet, {dw, row, value}, from bit PLACE of the planes part.
// BUFFERING double: the part is a shadow, from which a wrinkle_dda loads; single: the part is the interpolator itself,
// a wrinkle_dda_in_place, with one adder where SHARING leaves it a clock for each sum. Latency and modulus of those.
module wrinkle_plane #(
  parameter WIDTH     = 12,
  parameter GUARD     = 10,
  parameter SHARING   = 0,
  parameter BUFFERING = 0,
  parameter WORDS     = 3,
  parameter PLACE     = 0
) (
  input  wire                       clk,
  input  wire                       load_i,    // the walk: see wrinkle_dda
  input  wire                       step_i,
  input  wire                       carry_i,
  input  wire                       span_i,
  input  wire                       first_i,
  input  wire                       pixel_i,
  input  wire [3*(WIDTH+GUARD)-1:0] shadow_i,  // double: this part of the shadow
  input  wire [WORDS-1:0]           words_i,   // single: the bit of a word of the planes part, which word_i is
  input  wire [63:0]                word_i,
  output wire [WIDTH-1:0]           value_o
);
  localparam BITS = WIDTH + GUARD;

  generate
    if (BUFFERING != 0) begin : single
      wire unused_pins = &{1'b0, load_i, first_i, shadow_i};
      wrinkle_dda_in_place #(
        .WIDTH(WIDTH), .GUARD(GUARD), .SHARING(SHARING), .WORDS(WORDS), .PLACE(PLACE)
      ) dda (
        .clk(clk), .words_i(words_i), .word_i(word_i), .step_i(step_i), .carry_i(carry_i), .span_i(span_i),
        .pixel_i(pixel_i), .value_o(value_o));
    end else begin : double
      wire unused_pins = &{1'b0, words_i, word_i};
      wrinkle_dda #(.WIDTH(WIDTH), .GUARD(GUARD)) dda (
        .clk(clk), .load_i(load_i), .step_i(step_i), .carry_i(carry_i), .span_i(span_i), .first_i(first_i),
        .pixel_i(pixel_i), .value_i(shadow_i[0 +: BITS]), .row_i(shadow_i[BITS +: BITS]),
        .dw_i(shadow_i[2*BITS +: BITS]), .value_o(value_o));
    end
  endgenerate
endmodule
`default_nettype wire
