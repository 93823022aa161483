`default_nettype none
// N.L and N.H (or R.E), its power by successive squaring, self-shadow.
//   shadow factor g of s = bump ? L.z : N.L:  hard (s > 0);  smooth min(8 s, 1)
//   diffuse = nl * g, specular = nl > 0 ? power * g : 0;  without shadow diffuse = nl, specular = power
// A unit for each product (wrinkle_separate_light), or with SHARING on one dot product for N.H and N.L in turn and
// squarers that are used up to three times (wrinkle_shared_light, a fragment in three clocks). Latency is theirs.
module wrinkle_light #(
  parameter DATAPATH           = 1,
  parameter LIGHTING           = 1,
  parameter NORMALIZE_ORDER    = 0,
  parameter SHARING            = 0,
  parameter SELF_SHADOW        = 1,
  parameter DEPTH              = 1,
  parameter DECAL              = 0,
  parameter SCREEN_BITS        = 10,
  parameter TEXEL_BITS         = 8,
  parameter UNIT_BITS          = 9,   // F
  parameter DOT_BITS           = 10,  // DF
  parameter POWER_BITS         = 12,  // PF
  parameter SPECULAR_SQUARINGS = 5,   // K
  parameter DEPTH_BITS         = 20,
  // Of the above: bits of N, of the scales.
  parameter UNIT   = 3*(UNIT_BITS + (NORMALIZE_ORDER != 0 ? 1 : 2)),
  parameter SCALES = NORMALIZE_ORDER == 0 ? 1 : (LIGHTING != 0 ? 3 : 2) * (UNIT_BITS + (UNIT_BITS == 15 ? 3 : 2))
) (
  input  wire       clk,
  input  wire       rst,
  input  wire       draw_bump_i,
  input  wire       draw_shadow_i,
  input  wire       draw_exponent_zero_i,
  input  wire [3:0] draw_squarings_i,
  input  wire       in_valid_i,
  output wire       in_ready_o,
  input  wire [UNIT-1:0]                                      n_i,         // s1.F, a mantissa s0.F
  input  wire [UNIT-1:0]                                      l_i,
  input  wire [(LIGHTING != 0 ? UNIT : 1)-1:0]                h_i,
  input  wire [SCALES-1:0]                                    scale_i,     // u1.RB each, of N in the low bits
  input  wire                                                 zero_i,
  input  wire [(DECAL != 0 ? 3*TEXEL_BITS : 1)-1:0]           decal_i,
  input  wire [2*SCREEN_BITS+(DEPTH != 0 ? DEPTH_BITS : 0):0] tag_i,
  output wire       out_valid_o,
  input  wire       out_ready_i,
  output wire [DOT_BITS:0]                                    nl_o,        // u1.DF
  output wire [(LIGHTING != 0 ? DOT_BITS : 0):0]              nh_o,        // u1.DF
  output wire [DOT_BITS:0]                                    diffuse_o,   // u1.DF
  output wire [(LIGHTING != 0 ? POWER_BITS : 0):0]            specular_o,  // u1.PF
  output wire                                                 zero_o,
  output wire [(DECAL != 0 ? 3*TEXEL_BITS : 1)-1:0]           decal_o,
  output wire [2*SCREEN_BITS+(DEPTH != 0 ? DEPTH_BITS : 0):0] tag_o,
  output wire       busy_o
);
  localparam TAG     = 2 * SCREEN_BITS + 1 + (DEPTH != 0 ? DEPTH_BITS : 0);
  localparam DECAL_W = DECAL != 0 ? 3 * TEXEL_BITS : 1;
  localparam CARRIED = TAG + 1 + (DECAL != 0 ? DECAL_W : 0);

  wire [TAG+DECAL_W:0] carried = {decal_i, zero_i, tag_i};
  wire [TAG+DECAL_W:0] carried_on;
  wire unused_pins = &{1'b0, carried, scale_i};
  assign {decal_o, zero_o, tag_o} = carried_on;

  generate
    if (DECAL == 0) begin : no_decal
      assign carried_on[TAG+1] = 1'b0;
    end

    if (SHARING != 0) begin : shared
      wrinkle_shared_light #(
        .DATAPATH(DATAPATH), .SELF_SHADOW(SELF_SHADOW), .UNIT_BITS(UNIT_BITS), .DOT_BITS(DOT_BITS),
        .POWER_BITS(POWER_BITS), .SPECULAR_SQUARINGS(SPECULAR_SQUARINGS), .TAG_BITS(CARRIED)
      ) light (
        .clk(clk), .rst(rst), .draw_bump_i(draw_bump_i), .draw_shadow_i(draw_shadow_i),
        .draw_exponent_zero_i(draw_exponent_zero_i), .draw_squarings_i(draw_squarings_i), .in_valid_i(in_valid_i),
        .in_ready_o(in_ready_o), .n_i(n_i), .l_i(l_i), .h_i(h_i), .tag_i(carried[CARRIED-1:0]),
        .out_valid_o(out_valid_o), .out_ready_i(out_ready_i), .nl_o(nl_o), .nh_o(nh_o), .diffuse_o(diffuse_o),
        .specular_o(specular_o), .tag_o(carried_on[CARRIED-1:0]), .busy_o(busy_o));
    end else begin : separate
      wrinkle_separate_light #(
        .DATAPATH(DATAPATH), .LIGHTING(LIGHTING), .NORMALIZE_ORDER(NORMALIZE_ORDER), .SELF_SHADOW(SELF_SHADOW),
        .UNIT_BITS(UNIT_BITS), .DOT_BITS(DOT_BITS), .POWER_BITS(POWER_BITS), .SPECULAR_SQUARINGS(SPECULAR_SQUARINGS),
        .TAG_BITS(CARRIED)
      ) light (
        .clk(clk), .rst(rst), .draw_bump_i(draw_bump_i), .draw_shadow_i(draw_shadow_i),
        .draw_exponent_zero_i(draw_exponent_zero_i), .draw_squarings_i(draw_squarings_i), .in_valid_i(in_valid_i),
        .in_ready_o(in_ready_o), .n_i(n_i), .l_i(l_i), .h_i(h_i), .scale_i(scale_i), .tag_i(carried[CARRIED-1:0]),
        .out_valid_o(out_valid_o), .out_ready_i(out_ready_i), .nl_o(nl_o), .nh_o(nh_o), .diffuse_o(diffuse_o),
        .specular_o(specular_o), .tag_o(carried_on[CARRIED-1:0]), .busy_o(busy_o));
    end
  endgenerate
endmodule
`default_nettype wire
