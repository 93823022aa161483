`default_nettype none
// N.L and N.H (or R.E), its power by successive squaring, self-shadow.
//   shadow factor g of s = the cosine of the unperturbed surface:  hard (s > 0);  smooth min(8 s, 1)
//   diffuse = nl * g, specular = nl > 0 ? power * g : 0;  without shadow diffuse = nl, specular = power
// s is N.L, or L.z in a draw with a bump map where SURFACE_IS_Z says so.
// A unit for each product (wrinkle_separate_light), or with SHARING on one dot product for N.H and N.L in turn and
// squarers that are used up to three times (wrinkle_shared_light, a fragment in three clocks). Latency is theirs.
module wrinkle_light #(
  parameter LIGHTING           = 1,
  parameter NORMALIZE_ORDER    = 0,
  parameter SHARING            = 0,
  parameter SELF_SHADOW        = 1,
  parameter NORMAL_IS_Z        = 0,   // N = (0, 0, 1)
  parameter SURFACE_IS_Z       = 1,   // the surface of a bumped draw has its normal along z
  parameter UNIT_BITS          = 9,   // F
  parameter DOT_BITS           = 10,  // DF
  parameter POWER_BITS         = 12,  // PF
  parameter SPECULAR_SQUARINGS = 5,   // K
  parameter UNIT               = 33,  // bits of N, of L and of H or E
  parameter SCALE              = 11,  // bits of a scale
  parameter SCALES             = 0,   // ... of all of them; 0: none
  parameter CARRY              = 42
) (
  input  wire       clk,
  input  wire       rst,
  input  wire       draw_bump_i,
  input  wire       draw_shadow_i,
  input  wire       draw_exponent_zero_i,
  input  wire [3:0] draw_squarings_i,
  input  wire       in_valid_i,
  output wire       in_ready_o,
  input  wire       ahead_i,                                // SHARING: see wrinkle_shared_units; else 0
  input  wire [UNIT-1:0]                       n_i,         // s1.F, a mantissa s0.F
  input  wire [UNIT-1:0]                       l_i,
  input  wire [(LIGHTING != 0 ? UNIT : 1)-1:0] h_i,
  input  wire [(SCALES != 0 ? SCALES : 1)-1:0] scale_i,     // u1.RB each, of N in the low bits
  input  wire [CARRY-1:0]                      carry_i,
  output wire       out_valid_o,
  input  wire       out_ready_i,
  output wire [DOT_BITS:0]                         nl_o,        // u1.DF
  output wire [(LIGHTING != 0 ? DOT_BITS : 0):0]   nh_o,        // u1.DF
  output wire [DOT_BITS:0]                         diffuse_o,   // u1.DF
  output wire [(LIGHTING != 0 ? POWER_BITS : 0):0] specular_o,  // u1.PF
  output wire [CARRY-1:0]                          carry_o,
  output wire       busy_o
);
  wire unused_pins = &{1'b0, scale_i, ahead_i};

  generate
    if (SHARING != 0) begin : shared
      wrinkle_shared_light #(
        .SURFACE_IS_Z(SURFACE_IS_Z), .SELF_SHADOW(SELF_SHADOW), .UNIT_BITS(UNIT_BITS), .DOT_BITS(DOT_BITS),
        .POWER_BITS(POWER_BITS), .SPECULAR_SQUARINGS(SPECULAR_SQUARINGS), .CARRY(CARRY)
      ) light (
        .clk(clk), .rst(rst), .draw_bump_i(draw_bump_i), .draw_shadow_i(draw_shadow_i),
        .draw_exponent_zero_i(draw_exponent_zero_i), .draw_squarings_i(draw_squarings_i), .in_valid_i(in_valid_i),
        .in_ready_o(in_ready_o), .ahead_i(ahead_i), .n_i(n_i), .l_i(l_i), .h_i(h_i), .carry_i(carry_i),
        .out_valid_o(out_valid_o), .out_ready_i(out_ready_i), .nl_o(nl_o), .nh_o(nh_o), .diffuse_o(diffuse_o),
        .specular_o(specular_o), .carry_o(carry_o), .busy_o(busy_o));
    end else begin : separate
      wrinkle_separate_light #(
        .LIGHTING(LIGHTING), .NORMALIZE_ORDER(NORMALIZE_ORDER), .SELF_SHADOW(SELF_SHADOW), .NORMAL_IS_Z(NORMAL_IS_Z),
        .SURFACE_IS_Z(SURFACE_IS_Z), .UNIT_BITS(UNIT_BITS), .DOT_BITS(DOT_BITS), .POWER_BITS(POWER_BITS),
        .SPECULAR_SQUARINGS(SPECULAR_SQUARINGS), .UNIT(UNIT), .SCALE(SCALE), .SCALES(SCALES), .CARRY(CARRY)
      ) light (
        .clk(clk), .rst(rst), .draw_bump_i(draw_bump_i), .draw_shadow_i(draw_shadow_i),
        .draw_exponent_zero_i(draw_exponent_zero_i), .draw_squarings_i(draw_squarings_i), .in_valid_i(in_valid_i),
        .in_ready_o(in_ready_o), .n_i(n_i), .l_i(l_i), .h_i(h_i), .scale_i(scale_i), .carry_i(carry_i),
        .out_valid_o(out_valid_o), .out_ready_i(out_ready_i), .nl_o(nl_o), .nh_o(nh_o), .diffuse_o(diffuse_o),
        .specular_o(specular_o), .carry_o(carry_o), .busy_o(busy_o));
    end
  endgenerate
endmodule
`default_nettype wire
