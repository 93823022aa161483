`default_nettype none
// N, L and H to unit length; `zero` tells that one of them had no length. Of three ways one is there: each vector has its
// own unit (wrinkle_separate_units), with SHARING on all take turns in one (wrinkle_shared_units, a fragment in three
// clocks), with NORMALIZE_ORDER after `light` does the scaling, and n, l, h are mantissas, each with its scale
// (wrinkle_deferred_units). Latency is theirs.
module wrinkle_normalize #(
  parameter DATAPATH     = 1,
  parameter LIGHT_VECTORS = 0,
  parameter LIGHTING     = 1,
  parameter NORMALIZER_N = 1,
  parameter NORMALIZER_L = 1,
  parameter NORMALIZER_H = 1,
  parameter NORMALIZE_ORDER = 0,
  parameter SHARING      = 0,
  parameter DEPTH        = 1,
  parameter DECAL        = 0,
  parameter SCREEN_BITS  = 10,
  parameter VECTOR_BITS  = 9,
  parameter WIDE_BITS    = 16,
  parameter TEXEL_BITS   = 8,
  parameter UNIT_BITS    = 9,
  parameter DEPTH_BITS   = 20,
  // Of the above: bits of N', of L, of H or E, of a vector that is handed on, of the scales.
  parameter BUMPED = DATAPATH == 3 ? 1 : DATAPATH == 2 ? 3*(WIDE_BITS+3) : 3*(VECTOR_BITS+2),
  parameter LVEC   = LIGHT_VECTORS != 0 ? 1 : 3*(VECTOR_BITS+2),
  parameter HVEC   = LIGHTING != 0 ? LVEC : 1,
  parameter UNIT   = 3*(UNIT_BITS + (NORMALIZE_ORDER != 0 ? 1 : 2)),
  parameter SCALES = NORMALIZE_ORDER == 0 ? 1 : (LIGHTING != 0 ? 3 : 2) * (UNIT_BITS + (UNIT_BITS == 15 ? 3 : 2))
) (
  input  wire clk,
  input  wire rst,
  input  wire [(LIGHT_VECTORS != 0 ? 3*(UNIT_BITS+2) : 1)-1:0]                  draw_l_i,  // s1.F
  input  wire [(LIGHT_VECTORS != 0 && LIGHTING != 0 ? 3*(UNIT_BITS+2) : 1)-1:0] draw_h_i,  // s1.F, H or E
  input  wire in_valid_i,
  output wire in_ready_o,
  input  wire [BUMPED-1:0]                                    n_i,     // s1.V, with DATAPATH blinn s2.VW
  input  wire [LVEC-1:0]                                      l_i,     // s1.V
  input  wire [HVEC-1:0]                                      h_i,     // s1.V; E where H is made here
  input  wire [(DECAL != 0 ? 3*TEXEL_BITS : 1)-1:0]           decal_i,
  input  wire [2*SCREEN_BITS+(DEPTH != 0 ? DEPTH_BITS : 0):0] tag_i,
  output wire out_valid_o,
  input  wire out_ready_i,
  output wire [UNIT-1:0]                                      n_o,     // s1.F, a mantissa s0.F
  output wire [UNIT-1:0]                                      l_o,
  output wire [(LIGHTING != 0 ? UNIT : 1)-1:0]                h_o,
  output wire [SCALES-1:0]                                    scale_o, // u1.RB each, of N in the low bits
  output wire                                                 zero_o,
  output wire [(DECAL != 0 ? 3*TEXEL_BITS : 1)-1:0]           decal_o,
  output wire [2*SCREEN_BITS+(DEPTH != 0 ? DEPTH_BITS : 0):0] tag_o,
  output wire busy_o
);
  localparam TAG     = 2 * SCREEN_BITS + 1 + (DEPTH != 0 ? DEPTH_BITS : 0);
  localparam DECAL_W = DECAL != 0 ? 3 * TEXEL_BITS : 1;
  localparam CARRIED = TAG + (DECAL != 0 ? DECAL_W : 0);

  wire [TAG+DECAL_W-1:0] carried = {decal_i, tag_i};
  wire [TAG+DECAL_W-1:0] carried_on;
  wire unused_pins = &{1'b0, carried, draw_l_i, draw_h_i};
  assign {decal_o, tag_o} = carried_on;

  generate
    if (DECAL == 0) begin : no_decal
      assign carried_on[TAG] = 1'b0;
    end
    if (NORMALIZE_ORDER == 0) begin : before
      assign scale_o = 1'b0;
    end

    if (SHARING != 0) begin : shared
      wrinkle_shared_units #(
        .NORMALIZER(NORMALIZER_N), .VECTOR_BITS(VECTOR_BITS), .UNIT_BITS(UNIT_BITS), .TAG_BITS(CARRIED)
      ) units (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .in_ready_o(in_ready_o), .n_i(n_i), .l_i(l_i), .h_i(h_i),
        .tag_i(carried[CARRIED-1:0]), .out_valid_o(out_valid_o), .out_ready_i(out_ready_i), .n_o(n_o), .l_o(l_o),
        .h_o(h_o), .zero_o(zero_o), .tag_o(carried_on[CARRIED-1:0]), .busy_o(busy_o));
    end else if (NORMALIZE_ORDER != 0) begin : deferred
      wrinkle_deferred_units #(
        .DATAPATH(DATAPATH), .LIGHTING(LIGHTING), .VECTOR_BITS(VECTOR_BITS), .WIDE_BITS(WIDE_BITS),
        .UNIT_BITS(UNIT_BITS), .TAG_BITS(CARRIED)
      ) units (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .in_ready_o(in_ready_o), .n_i(n_i), .l_i(l_i), .h_i(h_i),
        .tag_i(carried[CARRIED-1:0]), .out_valid_o(out_valid_o), .out_ready_i(out_ready_i), .n_o(n_o), .l_o(l_o),
        .h_o(h_o), .scale_o(scale_o), .zero_o(zero_o), .tag_o(carried_on[CARRIED-1:0]), .busy_o(busy_o));
    end else begin : separate
      wrinkle_separate_units #(
        .DATAPATH(DATAPATH), .LIGHT_VECTORS(LIGHT_VECTORS), .LIGHTING(LIGHTING), .NORMALIZER_N(NORMALIZER_N),
        .NORMALIZER_L(NORMALIZER_L), .NORMALIZER_H(NORMALIZER_H), .VECTOR_BITS(VECTOR_BITS), .WIDE_BITS(WIDE_BITS),
        .UNIT_BITS(UNIT_BITS), .TAG_BITS(CARRIED)
      ) units (
        .clk(clk), .rst(rst), .draw_l_i(draw_l_i), .draw_h_i(draw_h_i), .in_valid_i(in_valid_i),
        .in_ready_o(in_ready_o), .n_i(n_i), .l_i(l_i), .h_i(h_i), .tag_i(carried[CARRIED-1:0]),
        .out_valid_o(out_valid_o), .out_ready_i(out_ready_i), .n_o(n_o), .l_o(l_o), .h_o(h_o), .zero_o(zero_o),
        .tag_o(carried_on[CARRIED-1:0]), .busy_o(busy_o));
    end
  endgenerate
endmodule
`default_nettype wire
