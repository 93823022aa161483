`default_nettype none
// Wrinkle: the hardware of "Efficient Bump Mapping Hardware" [Peercy97 fig. 1, 2 and 3], one pixel a clock. This is the
// list of its stages; docs/architecture.md has a heading for each, docs/formats.md the ports and packets. A value that
// a stage hands on is the wire STAGE_NAME, its handshake STAGE_valid and STAGE_ready: the bench reads them under these
// names. The parameters are golden/parameters.def. Every output depends on registers alone.
module wrinkle_core #(
  parameter DATAPATH           = 1,  // phong|tangent|blinn|rotated
  parameter CROSS_PRODUCTS     = 0,  // interpolated|constant; blinn only
  parameter BLOCK_EXPONENT     = 0,  // triangle|draw: of set-up alone, the hardware is the same; blinn only
  parameter LIGHT_VECTORS      = 0,  // interpolated|constant
  parameter LIGHTING           = 1,  // diffuse|halfangle|reflection|pixel_halfangle
  parameter NORMALIZER_N       = 1,  // none|faithful|compact|lite|near
  parameter NORMALIZER_L       = 1,  // none|faithful|compact|lite|near
  parameter NORMALIZER_H       = 1,  // none|faithful|compact|lite|near
  parameter NORMALIZE_ORDER    = 0,  // before|after
  parameter SHARING            = 0,  // off|on
  parameter BUFFERING          = 0,  // double|single
  parameter SELF_SHADOW        = 1,  // off|hard|smooth
  parameter FILTER             = 2,  // nearest|bilinear|trilinear
  parameter DECODE             = 0,  // range|offset
  parameter PERSPECTIVE        = 0,  // off|on
  parameter DEPTH              = 1,  // off|on
  parameter DECAL              = 0,  // off|on
  parameter CHANNELS           = 1,  // one|three
  parameter SCREEN_BITS        = 10, // X: the screen is at most 2^X by 2^X pixels
  parameter SUBPIXEL_BITS      = 8,  // S: vertices lie on a grid of 2^-S pixel
  parameter GUARD_BITS         = 10, // G: extra fraction bits of every interpolator
  parameter VECTOR_BITS        = 9,  // V: fraction bits of vectors before normalization (s1.V)
  parameter WIDE_BITS          = 16, // VW: fraction bits of Pu x Pv, Pv x N, N x Pu (s1.VW); blinn only
  parameter GRADIENT_BITS      = 9,  // GB: fraction bits of fu, fv after filtering (s0.GB); blinn only
  parameter UV_INTEGER_BITS    = 4,  // UI: integer bits of u and v, sign included (sUI-1.UF)
  parameter UV_BITS            = 18, // UF: fraction bits of u and v, in repeats of the texture
  parameter Q_BITS             = 18, // Q: fraction bits of the interpolated 1/w (u0.Q); perspective only
  parameter RECIPROCAL_BITS    = 18, // R: fraction bits of 1/q (u1.R); at least Q - 1; perspective only
  parameter LOD_BITS           = 5,  // LB: fraction bits of the level of detail; trilinear only
  parameter WEIGHT_BITS        = 8,  // B: fraction bits of the bilinear weights
  parameter TEXEL_BITS         = 8,  // T: bits of a texel component
  parameter UNIT_BITS          = 9,  // F: fraction bits of unit vectors (s1.F)
  parameter DOT_BITS           = 10, // DF: fraction bits of N.L and N.H (u1.DF); at most 2F
  parameter POWER_BITS         = 12, // PF: fraction bits of (N.H)^n (u1.PF); at least DF
  parameter SPECULAR_SQUARINGS = 5,  // K: exponents 0, 1, 2, 4 ... 2^K; halfangle only
  parameter COLOUR_BITS        = 8,  // C: bits of a colour channel
  parameter DEPTH_BITS         = 20, // Z: bits of z (u0.Z)
  parameter TEXTURE_FIFO_BITS  = 4,  // fragments that may wait for texels: 2^bits
  parameter TEXELS = (DATAPATH == 1 ? 3 : DATAPATH == 2 ? 2 : 0) + 3*DECAL  // of the above: components of a texel
) (
  input  wire        clk,
  input  wire        rst,                     // synchronous, valid bits and counters only
  input  wire        packet_valid_i,
  output wire        packet_ready_o,
  input  wire [63:0] packet_word_i,
  output wire        texel_request_valid_o,
  input  wire        texel_request_ready_i,
  output wire [(TEXELS != 0 ? 64 : 1)-1:0]                texel_request_a_o,
  output wire [(TEXELS != 0 && FILTER == 2 ? 64 : 1)-1:0] texel_request_b_o,
  input  wire        texel_response_valid_i,
  output wire        texel_response_ready_o,
  input  wire [(TEXELS != 0 ? TEXELS*TEXEL_BITS : 1)-1:0]               texel_a00_i,
  input  wire [(TEXELS != 0 && FILTER > 0 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_a10_i,
  input  wire [(TEXELS != 0 && FILTER > 0 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_a01_i,
  input  wire [(TEXELS != 0 && FILTER > 0 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_a11_i,
  input  wire [(TEXELS != 0 && FILTER > 1 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_b00_i,
  input  wire [(TEXELS != 0 && FILTER > 1 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_b10_i,
  input  wire [(TEXELS != 0 && FILTER > 1 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_b01_i,
  input  wire [(TEXELS != 0 && FILTER > 1 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_b11_i,
  output wire        fragment_valid_o,
  input  wire        fragment_ready_i,
  output wire [SCREEN_BITS-1:0]                         fragment_x_o,
  output wire [SCREEN_BITS-1:0]                         fragment_y_o,
  output wire [(DEPTH != 0 ? DEPTH_BITS : 1)-1:0]       fragment_z_o,       // u0.Z
  output wire [(CHANNELS != 0 ? 3 : 1)*COLOUR_BITS-1:0] fragment_colour_o,  // red in the low bits
  output wire        fragment_last_o,         // of its packet
  output wire        fragment_zero_o,         // a zero vector was met
  output wire        idle_o                   // no packet held, no fragment in flight
);
  localparam BLINN  = DATAPATH == 2 ? 1 : 0;
  localparam HALF   = LIGHTING != 0 ? 1 : 0;
  localparam TEX    = TEXELS != 0 ? 1 : 0;
  localparam VEC    = 3 * (VECTOR_BITS + 2);
  localparam WIDE   = BLINN != 0 ? 3 * (WIDE_BITS + 2) : 1;                              // A, B, C each
  localparam SMOOTH = DATAPATH == 3 ? 1 : BLINN != 0 ? 3 * WIDE : VEC;                   // N or {C, B, A}
  localparam BUMPED = DATAPATH == 3 ? 1 : BLINN != 0 ? 3 * (WIDE_BITS + 3) : VEC;        // N'
  localparam LVEC   = LIGHT_VECTORS != 0 ? 1 : VEC;
  localparam HVEC   = HALF != 0 ? LVEC : 1;
  localparam UNIT   = 3 * (UNIT_BITS + (NORMALIZE_ORDER != 0 ? 1 : 2));                  // N, L, H normalized
  localparam SCALES = NORMALIZE_ORDER == 0 ? 1 : (HALF + 2) * (UNIT_BITS + (UNIT_BITS == 15 ? 3 : 2));
  localparam UV     = TEX != 0 ? UV_INTEGER_BITS + UV_BITS : 1;
  localparam LOD    = TEX == 0 ? 1 : FILTER == 2 ? 6 + LOD_BITS : 6;
  localparam COUNT  = CHANNELS != 0 ? 3 : 1;
  localparam Z      = DEPTH != 0 ? DEPTH_BITS : 1;
  localparam TAG    = 2 * SCREEN_BITS + 1 + (DEPTH != 0 ? DEPTH_BITS : 0);  // {z, last, y, x}, carried along
  localparam DECALS = DECAL != 0 ? 3 * TEXEL_BITS : 1;

  wrinkle_parameters #(
    .DATAPATH(DATAPATH), .CROSS_PRODUCTS(CROSS_PRODUCTS), .BLOCK_EXPONENT(BLOCK_EXPONENT),
    .LIGHT_VECTORS(LIGHT_VECTORS), .LIGHTING(LIGHTING), .NORMALIZER_N(NORMALIZER_N), .NORMALIZER_L(NORMALIZER_L),
    .NORMALIZER_H(NORMALIZER_H), .NORMALIZE_ORDER(NORMALIZE_ORDER), .SHARING(SHARING), .BUFFERING(BUFFERING),
    .SELF_SHADOW(SELF_SHADOW), .FILTER(FILTER), .DECODE(DECODE), .PERSPECTIVE(PERSPECTIVE), .DEPTH(DEPTH),
    .DECAL(DECAL), .CHANNELS(CHANNELS), .SCREEN_BITS(SCREEN_BITS), .SUBPIXEL_BITS(SUBPIXEL_BITS),
    .GUARD_BITS(GUARD_BITS), .VECTOR_BITS(VECTOR_BITS), .WIDE_BITS(WIDE_BITS), .GRADIENT_BITS(GRADIENT_BITS),
    .UV_INTEGER_BITS(UV_INTEGER_BITS), .UV_BITS(UV_BITS), .Q_BITS(Q_BITS), .RECIPROCAL_BITS(RECIPROCAL_BITS),
    .LOD_BITS(LOD_BITS), .WEIGHT_BITS(WEIGHT_BITS), .TEXEL_BITS(TEXEL_BITS), .UNIT_BITS(UNIT_BITS),
    .DOT_BITS(DOT_BITS), .POWER_BITS(POWER_BITS), .SPECULAR_SQUARINGS(SPECULAR_SQUARINGS), .COLOUR_BITS(COLOUR_BITS),
    .DEPTH_BITS(DEPTH_BITS), .TEXTURE_FIFO_BITS(TEXTURE_FIFO_BITS)
  ) parameters ();

  // packet
  wire [63:0] packet_word;
  wire        scan_shift, plane_shift, plane_last, triangle_valid, triangle_take, packet_busy;
  wire        draw_bump, draw_textured, draw_shadow, draw_exponent_zero;
  wire [1:0]  draw_wrap_u, draw_wrap_v;
  wire [3:0]  draw_log2_width, draw_log2_height, draw_max_level, draw_squarings;
  wire [11:0] draw_texture;
  wire [COUNT*(COLOUR_BITS+1)-1:0] draw_ambient, draw_diffuse, draw_specular;
  wire [(LIGHT_VECTORS != 0 ? UNIT : 1)-1:0] draw_l;
  wire [(LIGHT_VECTORS != 0 && HALF != 0 ? UNIT : 1)-1:0] draw_h;
  wire scan_busy, perspective_busy, texture_busy, perturb_busy, normalize_busy, light_busy, output_busy;
  wire fragments_busy = scan_busy | perspective_busy | texture_busy | perturb_busy | normalize_busy | light_busy |
                        output_busy;
  assign idle_o = ~(packet_busy | fragments_busy);

  wrinkle_packet #(
    .DATAPATH(DATAPATH), .CROSS_PRODUCTS(CROSS_PRODUCTS), .LIGHT_VECTORS(LIGHT_VECTORS), .LIGHTING(LIGHTING),
    .FILTER(FILTER), .PERSPECTIVE(PERSPECTIVE), .DEPTH(DEPTH), .DECAL(DECAL), .BUFFERING(BUFFERING),
    .CHANNELS(CHANNELS), .SCREEN_BITS(SCREEN_BITS), .SUBPIXEL_BITS(SUBPIXEL_BITS), .GUARD_BITS(GUARD_BITS),
    .VECTOR_BITS(VECTOR_BITS), .WIDE_BITS(WIDE_BITS), .UV_INTEGER_BITS(UV_INTEGER_BITS), .UV_BITS(UV_BITS),
    .Q_BITS(Q_BITS), .LOD_BITS(LOD_BITS), .UNIT_BITS(UNIT_BITS), .COLOUR_BITS(COLOUR_BITS), .DEPTH_BITS(DEPTH_BITS)
  ) packet (
    .clk(clk), .rst(rst), .packet_valid_i(packet_valid_i), .packet_ready_o(packet_ready_o),
    .packet_word_i(packet_word_i), .busy_i(fragments_busy), .walking_i(scan_busy), .word_o(packet_word),
    .scan_shift_o(scan_shift), .plane_shift_o(plane_shift), .plane_last_o(plane_last),
    .triangle_valid_o(triangle_valid), .triangle_take_i(triangle_take),
    .draw_bump_o(draw_bump), .draw_textured_o(draw_textured), .draw_shadow_o(draw_shadow),
    .draw_exponent_zero_o(draw_exponent_zero), .draw_wrap_u_o(draw_wrap_u), .draw_wrap_v_o(draw_wrap_v),
    .draw_log2_width_o(draw_log2_width), .draw_log2_height_o(draw_log2_height), .draw_max_level_o(draw_max_level),
    .draw_texture_o(draw_texture), .draw_squarings_o(draw_squarings), .draw_ambient_o(draw_ambient),
    .draw_diffuse_o(draw_diffuse), .draw_specular_o(draw_specular), .draw_l_o(draw_l), .draw_h_o(draw_h),
    .busy_o(packet_busy));

  // scan: the walk it takes, and the pixel on which it stands
  wire walk_step, walk_carry, walk_span, walk_first, walk_pixel;
  wire scan_valid, scan_ready, scan_last;
  wire [SCREEN_BITS-1:0] scan_x, scan_y;

  wrinkle_scan #(
    .SHARING(SHARING), .BUFFERING(BUFFERING), .SCREEN_BITS(SCREEN_BITS), .SUBPIXEL_BITS(SUBPIXEL_BITS)
  ) scan (
    .clk(clk), .rst(rst), .shift_i(scan_shift), .word_i(packet_word), .triangle_valid_i(triangle_valid),
    .load_o(triangle_take), .step_o(walk_step), .carry_o(walk_carry), .span_o(walk_span), .first_o(walk_first),
    .pixel_o(walk_pixel), .out_valid_o(scan_valid), .out_ready_i(scan_ready), .x_o(scan_x), .y_o(scan_y),
    .last_o(scan_last), .busy_o(scan_busy));

  // interpolate: moves in step with scan, and so shares its handshake
  wire                   interpolate_valid, interpolate_ready;
  wire [SCREEN_BITS-1:0] interpolate_x, interpolate_y;
  wire                   interpolate_last;
  wire [(DATAPATH < 2 ? VEC : 1)-1:0] interpolate_n;
  wire [WIDE-1:0]        interpolate_a, interpolate_b, interpolate_c;
  wire [SMOOTH-1:0]      interpolate_smooth;
  wire [LVEC-1:0]        interpolate_l;
  wire [HVEC-1:0]        interpolate_h;
  wire [UV-1:0]          interpolate_u, interpolate_v;
  wire [(TEX != 0 && PERSPECTIVE != 0 ? Q_BITS : 1)-1:0] interpolate_q;
  wire [LOD-1:0]         interpolate_lod;
  wire [Z-1:0]           interpolate_z;
  wire [TAG-1:0]         interpolate_tag;

  assign interpolate_valid = scan_valid;
  assign scan_ready        = interpolate_ready;
  assign interpolate_x     = scan_x;
  assign interpolate_y     = scan_y;
  assign interpolate_last  = scan_last;
  generate
    if (DEPTH != 0) begin : tag_with_z
      assign interpolate_tag = {interpolate_z, interpolate_last, interpolate_y, interpolate_x};
    end else begin : tag_without_z
      wire unused_z = interpolate_z;
      assign interpolate_tag = {interpolate_last, interpolate_y, interpolate_x};
    end
    if (BLINN != 0) begin : smooth_products
      wire unused_n = interpolate_n;
      assign interpolate_smooth = {interpolate_c, interpolate_b, interpolate_a};
    end else begin : smooth_n
      wire unused_products = &{1'b0, interpolate_a, interpolate_b, interpolate_c};
      assign interpolate_smooth = interpolate_n;
    end
  endgenerate

  wrinkle_interpolate #(
    .DATAPATH(DATAPATH), .CROSS_PRODUCTS(CROSS_PRODUCTS), .LIGHT_VECTORS(LIGHT_VECTORS), .LIGHTING(LIGHTING),
    .FILTER(FILTER), .PERSPECTIVE(PERSPECTIVE), .DEPTH(DEPTH), .DECAL(DECAL), .SHARING(SHARING), .BUFFERING(BUFFERING),
    .GUARD_BITS(GUARD_BITS), .VECTOR_BITS(VECTOR_BITS), .WIDE_BITS(WIDE_BITS), .UV_INTEGER_BITS(UV_INTEGER_BITS),
    .UV_BITS(UV_BITS), .Q_BITS(Q_BITS), .LOD_BITS(LOD_BITS), .DEPTH_BITS(DEPTH_BITS)
  ) interpolate (
    .clk(clk), .shift_i(plane_shift), .last_i(plane_last), .word_i(packet_word), .load_i(triangle_take),
    .step_i(walk_step),
    .carry_i(walk_carry), .span_i(walk_span), .first_i(walk_first), .pixel_i(walk_pixel), .n_o(interpolate_n),
    .a_o(interpolate_a), .b_o(interpolate_b), .c_o(interpolate_c), .l_o(interpolate_l), .h_o(interpolate_h),
    .u_o(interpolate_u), .v_o(interpolate_v), .q_o(interpolate_q), .lod_o(interpolate_lod), .z_o(interpolate_z));

  // perspective
  wire           perspective_valid, perspective_ready;
  wire [SMOOTH-1:0] perspective_smooth;
  wire [LVEC-1:0] perspective_l;
  wire [HVEC-1:0] perspective_h;
  wire [UV-1:0]  perspective_u, perspective_v;
  wire [LOD-1:0] perspective_lod;
  wire [TAG-1:0] perspective_tag;

  wrinkle_perspective #(
    .DATAPATH(DATAPATH), .LIGHT_VECTORS(LIGHT_VECTORS), .LIGHTING(LIGHTING), .FILTER(FILTER),
    .PERSPECTIVE(PERSPECTIVE), .DEPTH(DEPTH), .DECAL(DECAL), .SCREEN_BITS(SCREEN_BITS), .VECTOR_BITS(VECTOR_BITS),
    .WIDE_BITS(WIDE_BITS), .UV_INTEGER_BITS(UV_INTEGER_BITS), .UV_BITS(UV_BITS), .Q_BITS(Q_BITS),
    .RECIPROCAL_BITS(RECIPROCAL_BITS), .LOD_BITS(LOD_BITS), .DEPTH_BITS(DEPTH_BITS)
  ) perspective (
    .clk(clk), .rst(rst), .in_valid_i(interpolate_valid), .in_ready_o(interpolate_ready),
    .smooth_i(interpolate_smooth), .l_i(interpolate_l), .h_i(interpolate_h), .u_i(interpolate_u),
    .v_i(interpolate_v), .q_i(interpolate_q), .lod_i(interpolate_lod), .tag_i(interpolate_tag),
    .out_valid_o(perspective_valid), .out_ready_i(perspective_ready), .smooth_o(perspective_smooth),
    .l_o(perspective_l), .h_o(perspective_h), .u_o(perspective_u), .v_o(perspective_v), .lod_o(perspective_lod),
    .tag_o(perspective_tag), .busy_o(perspective_busy));

  // texture
  wire              texture_valid, texture_ready;
  wire [SMOOTH-1:0] texture_smooth;
  wire [LVEC-1:0]   texture_l;
  wire [(DATAPATH == 1 ? VEC : 1)-1:0] texture_n;
  wire [(BLINN != 0 ? 2*(GRADIENT_BITS+1) : 1)-1:0] texture_gradient;
  wire [DECALS-1:0] texture_decal;
  wire [HVEC-1:0]   texture_h;
  wire [TAG-1:0]    texture_tag;

  wrinkle_texture #(
    .DATAPATH(DATAPATH), .LIGHT_VECTORS(LIGHT_VECTORS), .LIGHTING(LIGHTING), .FILTER(FILTER), .DECODE(DECODE),
    .DEPTH(DEPTH), .DECAL(DECAL), .SCREEN_BITS(SCREEN_BITS), .VECTOR_BITS(VECTOR_BITS), .WIDE_BITS(WIDE_BITS),
    .GRADIENT_BITS(GRADIENT_BITS), .UV_INTEGER_BITS(UV_INTEGER_BITS), .UV_BITS(UV_BITS), .LOD_BITS(LOD_BITS),
    .WEIGHT_BITS(WEIGHT_BITS), .TEXEL_BITS(TEXEL_BITS), .DEPTH_BITS(DEPTH_BITS), .TEXTURE_FIFO_BITS(TEXTURE_FIFO_BITS)
  ) texture (
    .clk(clk), .rst(rst), .draw_textured_i(draw_textured), .draw_wrap_u_i(draw_wrap_u), .draw_wrap_v_i(draw_wrap_v),
    .draw_log2_width_i(draw_log2_width), .draw_log2_height_i(draw_log2_height), .draw_max_level_i(draw_max_level),
    .draw_texture_i(draw_texture), .in_valid_i(perspective_valid), .in_ready_o(perspective_ready),
    .smooth_i(perspective_smooth), .l_i(perspective_l), .h_i(perspective_h), .u_i(perspective_u), .v_i(perspective_v),
    .lod_i(perspective_lod), .tag_i(perspective_tag), .texel_request_valid_o(texel_request_valid_o),
    .texel_request_ready_i(texel_request_ready_i), .texel_request_a_o(texel_request_a_o),
    .texel_request_b_o(texel_request_b_o), .texel_response_valid_i(texel_response_valid_i),
    .texel_response_ready_o(texel_response_ready_o), .texel_a00_i(texel_a00_i), .texel_a10_i(texel_a10_i),
    .texel_a01_i(texel_a01_i), .texel_a11_i(texel_a11_i), .texel_b00_i(texel_b00_i), .texel_b10_i(texel_b10_i),
    .texel_b01_i(texel_b01_i), .texel_b11_i(texel_b11_i), .out_valid_o(texture_valid), .out_ready_i(texture_ready),
    .smooth_o(texture_smooth), .n_o(texture_n), .gradient_o(texture_gradient), .decal_o(texture_decal),
    .l_o(texture_l), .h_o(texture_h), .tag_o(texture_tag), .busy_o(texture_busy));

  // perturb
  wire              perturb_valid, perturb_ready;
  wire [BUMPED-1:0] perturb_n;
  wire [LVEC-1:0]   perturb_l;
  wire [HVEC-1:0]   perturb_h;
  wire [DECALS-1:0] perturb_decal;
  wire [TAG-1:0]    perturb_tag;

  wrinkle_perturb #(
    .DATAPATH(DATAPATH), .LIGHT_VECTORS(LIGHT_VECTORS), .LIGHTING(LIGHTING), .DEPTH(DEPTH), .DECAL(DECAL),
    .SCREEN_BITS(SCREEN_BITS), .VECTOR_BITS(VECTOR_BITS), .WIDE_BITS(WIDE_BITS), .GRADIENT_BITS(GRADIENT_BITS),
    .TEXEL_BITS(TEXEL_BITS), .DEPTH_BITS(DEPTH_BITS)
  ) perturb (
    .clk(clk), .rst(rst), .draw_bump_i(draw_bump), .in_valid_i(texture_valid), .in_ready_o(texture_ready),
    .smooth_i(texture_smooth), .texture_n_i(texture_n), .gradient_i(texture_gradient), .decal_i(texture_decal),
    .l_i(texture_l), .h_i(texture_h), .tag_i(texture_tag), .out_valid_o(perturb_valid), .out_ready_i(perturb_ready),
    .n_o(perturb_n), .decal_o(perturb_decal), .l_o(perturb_l), .h_o(perturb_h), .tag_o(perturb_tag),
    .busy_o(perturb_busy));

  // normalize
  wire              normalize_valid, normalize_ready, normalize_zero;
  wire [UNIT-1:0]   normalize_n, normalize_l;
  wire [(HALF != 0 ? UNIT : 1)-1:0] normalize_h;
  wire [SCALES-1:0] normalize_scale;
  wire [DECALS-1:0] normalize_decal;
  wire [TAG-1:0]    normalize_tag;

  wrinkle_normalize #(
    .DATAPATH(DATAPATH), .LIGHT_VECTORS(LIGHT_VECTORS), .LIGHTING(LIGHTING), .NORMALIZER_N(NORMALIZER_N),
    .NORMALIZER_L(NORMALIZER_L), .NORMALIZER_H(NORMALIZER_H), .NORMALIZE_ORDER(NORMALIZE_ORDER), .SHARING(SHARING),
    .DEPTH(DEPTH), .DECAL(DECAL), .SCREEN_BITS(SCREEN_BITS), .VECTOR_BITS(VECTOR_BITS), .WIDE_BITS(WIDE_BITS),
    .TEXEL_BITS(TEXEL_BITS), .UNIT_BITS(UNIT_BITS), .DEPTH_BITS(DEPTH_BITS)
  ) normalize (
    .clk(clk), .rst(rst), .draw_l_i(draw_l), .draw_h_i(draw_h), .in_valid_i(perturb_valid), .in_ready_o(perturb_ready),
    .n_i(perturb_n), .l_i(perturb_l), .h_i(perturb_h), .decal_i(perturb_decal), .tag_i(perturb_tag),
    .out_valid_o(normalize_valid), .out_ready_i(normalize_ready), .n_o(normalize_n), .l_o(normalize_l),
    .h_o(normalize_h), .scale_o(normalize_scale), .zero_o(normalize_zero), .decal_o(normalize_decal), .tag_o(normalize_tag),
    .busy_o(normalize_busy));

  // light
  wire              light_valid, light_ready, light_zero;
  wire [DOT_BITS:0] light_nl, light_diffuse;
  wire [(HALF != 0 ? DOT_BITS : 0):0]   light_nh;
  wire [(HALF != 0 ? POWER_BITS : 0):0] light_specular;
  wire [DECALS-1:0] light_decal;
  wire [TAG-1:0]    light_tag;
  wire unused_but_observed = &{1'b0, light_nl, light_nh};

  wrinkle_light #(
    .DATAPATH(DATAPATH), .LIGHTING(LIGHTING), .NORMALIZE_ORDER(NORMALIZE_ORDER), .SHARING(SHARING),
    .SELF_SHADOW(SELF_SHADOW), .DEPTH(DEPTH), .DECAL(DECAL), .SCREEN_BITS(SCREEN_BITS), .TEXEL_BITS(TEXEL_BITS),
    .UNIT_BITS(UNIT_BITS), .DOT_BITS(DOT_BITS), .POWER_BITS(POWER_BITS), .SPECULAR_SQUARINGS(SPECULAR_SQUARINGS),
    .DEPTH_BITS(DEPTH_BITS)
  ) light (
    .clk(clk), .rst(rst), .draw_bump_i(draw_bump), .draw_shadow_i(draw_shadow),
    .draw_exponent_zero_i(draw_exponent_zero), .draw_squarings_i(draw_squarings), .in_valid_i(normalize_valid),
    .in_ready_o(normalize_ready), .n_i(normalize_n), .l_i(normalize_l), .h_i(normalize_h), .scale_i(normalize_scale),
    .zero_i(normalize_zero),
    .decal_i(normalize_decal), .tag_i(normalize_tag), .out_valid_o(light_valid), .out_ready_i(light_ready),
    .nl_o(light_nl), .nh_o(light_nh), .diffuse_o(light_diffuse), .specular_o(light_specular), .zero_o(light_zero),
    .decal_o(light_decal), .tag_o(light_tag), .busy_o(light_busy));

  // output
  wire output_valid, output_ready;
  wire [COUNT*COLOUR_BITS-1:0] output_colour;
  assign output_ready      = fragment_ready_i;
  assign fragment_valid_o  = output_valid;
  assign fragment_colour_o = output_colour;

  wrinkle_output #(
    .LIGHTING(LIGHTING), .DEPTH(DEPTH), .DECAL(DECAL), .CHANNELS(CHANNELS), .SCREEN_BITS(SCREEN_BITS),
    .TEXEL_BITS(TEXEL_BITS), .DOT_BITS(DOT_BITS), .POWER_BITS(POWER_BITS), .COLOUR_BITS(COLOUR_BITS),
    .DEPTH_BITS(DEPTH_BITS)
  ) outputs (
    .clk(clk), .rst(rst), .draw_ambient_i(draw_ambient), .draw_diffuse_i(draw_diffuse),
    .draw_specular_i(draw_specular), .in_valid_i(light_valid), .in_ready_o(light_ready), .diffuse_i(light_diffuse),
    .specular_i(light_specular), .zero_i(light_zero), .decal_i(light_decal), .tag_i(light_tag),
    .out_valid_o(output_valid), .out_ready_i(output_ready), .colour_o(output_colour), .x_o(fragment_x_o),
    .y_o(fragment_y_o), .z_o(fragment_z_o), .last_o(fragment_last_o), .zero_o(fragment_zero_o), .busy_o(output_busy));
endmodule
`default_nettype wire
