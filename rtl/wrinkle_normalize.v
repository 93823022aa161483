`default_nettype none
// N, L and H to unit length, each by its own unit; `zero` tells that one of them had no length.
// Latency 5, or 1 when no vector has a normalizer.
module wrinkle_normalize #(
  parameter LIGHTING     = 1,
  parameter NORMALIZER_N = 1,
  parameter NORMALIZER_L = 1,
  parameter NORMALIZER_H = 1,
  parameter DEPTH        = 1,
  parameter DECAL        = 0,
  parameter SCREEN_BITS  = 10,
  parameter VECTOR_BITS  = 9,
  parameter TEXEL_BITS   = 8,
  parameter UNIT_BITS    = 9,
  parameter DEPTH_BITS   = 20
) (
  input  wire clk,
  input  wire rst,
  input  wire in_valid_i,
  output wire in_ready_o,
  input  wire [3*(VECTOR_BITS+2)-1:0]                         n_i,     // s1.V
  input  wire [3*(VECTOR_BITS+2)-1:0]                         l_i,
  input  wire [(LIGHTING != 0 ? 3*(VECTOR_BITS+2) : 1)-1:0]   h_i,
  input  wire [(DECAL != 0 ? 3*TEXEL_BITS : 1)-1:0]           decal_i,
  input  wire [2*SCREEN_BITS+(DEPTH != 0 ? DEPTH_BITS : 0):0] tag_i,
  output wire out_valid_o,
  input  wire out_ready_i,
  output wire [3*(UNIT_BITS+2)-1:0]                           n_o,     // s1.F
  output wire [3*(UNIT_BITS+2)-1:0]                           l_o,
  output wire [(LIGHTING != 0 ? 3*(UNIT_BITS+2) : 1)-1:0]     h_o,
  output wire                                                 zero_o,
  output wire [(DECAL != 0 ? 3*TEXEL_BITS : 1)-1:0]           decal_o,
  output wire [2*SCREEN_BITS+(DEPTH != 0 ? DEPTH_BITS : 0):0] tag_o,
  output wire busy_o
);
  localparam TAG       = 2 * SCREEN_BITS + 1 + (DEPTH != 0 ? DEPTH_BITS : 0);
  localparam DECAL_W   = DECAL != 0 ? 3 * TEXEL_BITS : 1;
  localparam RANKS     = NORMALIZER_N != 0 || NORMALIZER_L != 0 || (LIGHTING != 0 && NORMALIZER_H != 0) ? 5 : 1;

  wire advance, zero_n, zero_l;

  wrinkle_pipe #(.RANKS(RANKS)) pipe (
    .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .advance_o(advance), .out_valid_o(out_valid_o),
    .out_ready_i(out_ready_i), .busy_o(busy_o));
  assign in_ready_o = advance;

  wrinkle_unit_vector #(
    .NORMALIZER(NORMALIZER_N), .VECTOR_BITS(VECTOR_BITS), .UNIT_BITS(UNIT_BITS), .RANKS(RANKS)
  ) unit_n (.clk(clk), .advance_i(advance), .vector_i(n_i), .unit_o(n_o), .zero_o(zero_n));
  wrinkle_unit_vector #(
    .NORMALIZER(NORMALIZER_L), .VECTOR_BITS(VECTOR_BITS), .UNIT_BITS(UNIT_BITS), .RANKS(RANKS)
  ) unit_l (.clk(clk), .advance_i(advance), .vector_i(l_i), .unit_o(l_o), .zero_o(zero_l));

  generate
    if (LIGHTING != 0) begin : halfangle
      wire zero_h;
      wrinkle_unit_vector #(
        .NORMALIZER(NORMALIZER_H), .VECTOR_BITS(VECTOR_BITS), .UNIT_BITS(UNIT_BITS), .RANKS(RANKS)
      ) unit_h (.clk(clk), .advance_i(advance), .vector_i(h_i), .unit_o(h_o), .zero_o(zero_h));
      assign zero_o = zero_n | zero_l | zero_h;
    end else begin : diffuse
      wire unused_pins = h_i;
      assign h_o = 1'b0;
      assign zero_o = zero_n | zero_l;
    end
  endgenerate

  wrinkle_delay #(.WIDTH(DECAL_W), .RANKS(DECAL != 0 ? RANKS : 0)) delay_decal (
    .clk(clk), .advance_i(advance), .data_i(decal_i), .data_o(decal_o));
  wrinkle_delay #(.WIDTH(TAG), .RANKS(RANKS)) delay_tag (
    .clk(clk), .advance_i(advance), .data_i(tag_i), .data_o(tag_o));
endmodule
`default_nettype wire
