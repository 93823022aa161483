`default_nettype none
// The perturbed normal. DATAPATH tangent: the multiplexer of [Peercy97 fig. 3], the texture's normal where the draw
// says so, else the interpolated one. DATAPATH blinn [Peercy97 fig. 2]: two vector scalings and an addition,
//   N' = saturate(round_half_up((A << GB) - fu B - fv C, GB)) in s2.VW, with fu = fv = 0 where the draw has no bump.
// phong [Peercy97 fig. 1] and rotated: a wire. Latency 0, with blinn 2. Does not normalize.
module wrinkle_perturb #(
  parameter DATAPATH      = 1,
  parameter LIGHT_VECTORS = 0,
  parameter LIGHTING      = 1,
  parameter DEPTH         = 1,
  parameter DECAL         = 0,
  parameter SCREEN_BITS   = 10,
  parameter VECTOR_BITS   = 9,
  parameter WIDE_BITS     = 16,
  parameter GRADIENT_BITS = 9,
  parameter TEXEL_BITS    = 8,
  parameter DEPTH_BITS    = 20,
  // Of the above: bits of N or {C, B, A}, of N', of L, of H or E.
  parameter SMOOTH = DATAPATH == 3 ? 1 : DATAPATH == 2 ? 9*(WIDE_BITS+2) : 3*(VECTOR_BITS+2),
  parameter BUMPED = DATAPATH == 3 ? 1 : DATAPATH == 2 ? 3*(WIDE_BITS+3) : 3*(VECTOR_BITS+2),
  parameter LVEC   = LIGHT_VECTORS != 0 ? 1 : 3*(VECTOR_BITS+2),
  parameter HVEC   = LIGHTING != 0 ? LVEC : 1
) (
  input  wire clk,
  input  wire rst,
  input  wire draw_bump_i,
  input  wire in_valid_i,
  output wire in_ready_o,
  input  wire [SMOOTH-1:0] smooth_i,                                       // interpolated
  input  wire [(DATAPATH == 1 ? 3*(VECTOR_BITS+2) : 1)-1:0]   texture_n_i, // s1.V
  input  wire [(DATAPATH == 2 ? 2*(GRADIENT_BITS+1) : 1)-1:0] gradient_i,  // {fv, fu} in s0.GB
  input  wire [(DECAL != 0 ? 3*TEXEL_BITS : 1)-1:0]           decal_i,
  input  wire [LVEC-1:0] l_i,
  input  wire [HVEC-1:0] h_i,
  input  wire [2*SCREEN_BITS+(DEPTH != 0 ? DEPTH_BITS : 0):0] tag_i,
  output wire out_valid_o,
  input  wire out_ready_i,
  output wire [BUMPED-1:0] n_o,                                            // s1.V, with blinn s2.VW
  output wire [(DECAL != 0 ? 3*TEXEL_BITS : 1)-1:0]           decal_o,
  output wire [LVEC-1:0] l_o,
  output wire [HVEC-1:0] h_o,
  output wire [2*SCREEN_BITS+(DEPTH != 0 ? DEPTH_BITS : 0):0] tag_o,
  output wire busy_o
);
  localparam TAG     = 2 * SCREEN_BITS + 1 + (DEPTH != 0 ? DEPTH_BITS : 0);
  localparam DECAL_W = DECAL != 0 ? 3 * TEXEL_BITS : 1;
  localparam HAS_L   = LIGHT_VECTORS == 0 ? 1 : 0;
  localparam HAS_H   = LIGHTING != 0 ? HAS_L : 0;
  localparam GRAD    = GRADIENT_BITS + 1;
  localparam WW      = WIDE_BITS + 2;

  genvar k;
  generate
    if (DATAPATH == 2) begin : fig2
      wire advance;
      wire [GRAD-1:0] fu = draw_bump_i ? gradient_i[0 +: GRAD] : {GRAD{1'b0}};
      wire [GRAD-1:0] fv = draw_bump_i ? gradient_i[GRAD +: GRAD] : {GRAD{1'b0}};
      wire unused_pins = texture_n_i;

      wrinkle_pipe #(.RANKS(2)) pipe (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .advance_o(advance), .out_valid_o(out_valid_o),
        .out_ready_i(out_ready_i), .busy_o(busy_o));
      assign in_ready_o = advance;

      for (k = 0; k < 3; k = k + 1) begin : component
        wrinkle_perturbed #(.WIDE_BITS(WIDE_BITS), .GRADIENT_BITS(GRADIENT_BITS)) perturbed (
          .clk(clk), .advance_i(advance), .a_i(smooth_i[k*WW +: WW]), .b_i(smooth_i[(3+k)*WW +: WW]),
          .c_i(smooth_i[(6+k)*WW +: WW]), .fu_i(fu), .fv_i(fv), .n_o(n_o[k*(WW+1) +: WW+1]));
      end
      wrinkle_delay #(.WIDTH(LVEC), .RANKS(2 * HAS_L)) delay_l (
        .clk(clk), .advance_i(advance), .data_i(l_i), .data_o(l_o));
      wrinkle_delay #(.WIDTH(HVEC), .RANKS(2 * HAS_H)) delay_h (
        .clk(clk), .advance_i(advance), .data_i(h_i), .data_o(h_o));
      wrinkle_delay #(.WIDTH(DECAL_W), .RANKS(DECAL != 0 ? 2 : 0)) delay_decal (
        .clk(clk), .advance_i(advance), .data_i(decal_i), .data_o(decal_o));
      wrinkle_delay #(.WIDTH(TAG), .RANKS(2)) delay_tag (
        .clk(clk), .advance_i(advance), .data_i(tag_i), .data_o(tag_o));
    end else begin : at_once
      wire unused_pins = &{1'b0, clk, rst, gradient_i};
      assign in_ready_o  = out_ready_i;
      assign out_valid_o = in_valid_i;
      assign decal_o     = decal_i;
      assign l_o         = l_i;
      assign h_o         = h_i;
      assign tag_o       = tag_i;
      assign busy_o      = 1'b0;
      if (DATAPATH == 1) begin : fig3
        assign n_o = draw_bump_i ? texture_n_i : smooth_i;
      end else begin : fig1
        wire unused_bump = &{1'b0, draw_bump_i, texture_n_i};
        assign n_o = smooth_i;
      end
    end
  endgenerate
endmodule
`default_nettype wire
