`default_nettype none
// Interpolates the fields of a packet: one list, each entry of which has elements of one width, either planes, with a
// digital differential analyser an element, or held over the triangle. The walk of wrinkle_scan leads them. Values are
// those of the pixel on which the scan stands: latency 0, no handshake of its own. They come out in one vector: the
// fields whose first reader is the latest stage stand in the low bits, then in the order of the list, so that what a
// stage carries along is one part of it. BUFFERING double: the next packet shifts into a shadow while this one is
// drawn; single: into the interpolators, when it is drawn. Does not correct for perspective: there u and v are u*q and
// v*q.
module wrinkle_interpolate #(
  parameter SHARING    = 0,
  parameter BUFFERING  = 0,
  parameter GUARD_BITS = 10,  // G
  parameter FIELDS     = 1,
  parameter [32*FIELDS-1:0] ELEMENTS = 32'd3,   // the first field in the low bits
  parameter [32*FIELDS-1:0] WIDTHS   = 32'd11,  // bits of an element, without guard bits
  parameter [32*FIELDS-1:0] HELD     = 32'd0,
  parameter [32*FIELDS-1:0] READERS  = 32'd3,   // number of the stage that reads it first
  parameter WORDS      = 3,                     // of the planes part of a packet
  parameter VALUES     = 33                     // bits of all elements
) (
  input  wire              clk,
  input  wire              shift_i,   // word_i is of the planes part of a packet
  input  wire [WORDS-1:0]  words_i,   // single: the bit of which word it is
  input  wire [63:0]       word_i,
  input  wire              load_i,    // the walk: see wrinkle_dda
  input  wire              step_i,
  input  wire              carry_i,
  input  wire              span_i,
  input  wire              first_i,
  input  wire              pixel_i,
  output wire [VALUES-1:0] values_o
);
  localparam G = GUARD_BITS;

  // Bits of the packet before field `field`.
  function integer packet_bits_before;
    input integer field;
    integer i;
    begin
      packet_bits_before = 0;
      for (i = 0; i < field; i = i + 1)
        packet_bits_before = packet_bits_before +
          ELEMENTS[32*i +: 32] * (HELD[32*i +: 32] != 0 ? WIDTHS[32*i +: 32] : 3 * (WIDTHS[32*i +: 32] + G));
    end
  endfunction

  // Bits of the values below field `field`.
  function integer value_bits_below;
    input integer field;
    integer i;
    begin
      value_bits_below = 0;
      for (i = 0; i < FIELDS; i = i + 1)
        if (READERS[32*i +: 32] > READERS[32*field +: 32] ||
            (READERS[32*i +: 32] == READERS[32*field +: 32] && i < field))
          value_bits_below = value_bits_below + ELEMENTS[32*i +: 32] * WIDTHS[32*i +: 32];
    end
  endfunction

  // double: the shadow, through which the words of a packet shift. single: each word is written where it belongs, in the
  // registers that the interpolators and the held fields have themselves.
  wire [64*WORDS-1:0] packet;
  wire unused_bits = &{1'b0, shift_i, words_i, packet};

  genvar k, e;
  generate
    if (BUFFERING != 0) begin : in_place
      assign packet = {64*WORDS{1'b0}};
    end else begin : shadowed
      wrinkle_shadow_words #(.WORDS(WORDS)) shadow (.clk(clk), .shift_i(shift_i), .word_i(word_i), .words_o(packet));
    end

    for (k = 0; k < FIELDS; k = k + 1) begin : field
      localparam [31:0] COUNT = ELEMENTS[32*k +: 32];
      localparam [31:0] WIDTH = WIDTHS[32*k +: 32];
      localparam FROM = packet_bits_before(k);
      localparam TO   = value_bits_below(k);
      for (e = 0; e < COUNT; e = e + 1) begin : element
        if (HELD[32*k +: 32] != 0) begin : held
          localparam AT = FROM + e * WIDTH;
          wrinkle_held #(.WIDTH(WIDTH), .BUFFERING(BUFFERING), .WORDS(WORDS), .PLACE(AT)) register (
            .clk(clk), .load_i(load_i), .take_i(span_i & first_i), .shadow_i(packet[AT +: WIDTH]), .words_i(words_i),
            .word_i(word_i), .value_o(values_o[TO + e*WIDTH +: WIDTH]));
        end else begin : plane
          localparam BITS_OF_PLANE = 3 * (WIDTH + G);
          localparam AT = FROM + e * BITS_OF_PLANE;
          wrinkle_plane #(
            .WIDTH(WIDTH), .GUARD(G), .SHARING(SHARING), .BUFFERING(BUFFERING), .WORDS(WORDS), .PLACE(AT)
          ) dda (
            .clk(clk), .load_i(load_i), .step_i(step_i), .carry_i(carry_i), .span_i(span_i), .first_i(first_i),
            .pixel_i(pixel_i), .shadow_i(packet[AT +: BITS_OF_PLANE]), .words_i(words_i), .word_i(word_i),
            .value_o(values_o[TO + e*WIDTH +: WIDTH]));
        end
      end
    end
  endgenerate
endmodule
`default_nettype wire
