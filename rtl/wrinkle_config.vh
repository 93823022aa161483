// What wrinkle_core can be: its parameters, what follows from them, and which of them are illegal together. Made by
// `./wrinkle generate` from golden/config/*.def and golden/datapath/*.h; change those. The file is included once for each
// of its sections, with the macro defined that selects it:
//
//   WRINKLE_SECTION_PARAMETERS   in a parameter list: every parameter with its default and its range
//   WRINKLE_SECTION_DERIVED      in a module: local parameters, which nobody can override
//   WRINKLE_SECTION_RULES        in a module: an illegal configuration stops the elaboration in every tool, by an
//                                instance of a module that does not exist and whose name says the fault
//   WRINKLE_SECTION_PERTURB      in wrinkle_core: the perturb stage of the datapath

`ifdef WRINKLE_SECTION_PARAMETERS
  parameter DATAPATH           = 1,  // 0 to 4: phong|normal_map|blinn|rotated|offset
  parameter CROSS_PRODUCTS     = 0,  // 0 to 1: interpolated|constant
  parameter LIGHT_VECTORS      = 0,  // 0 to 1: interpolated|constant
  parameter LIGHTING           = 1,  // 0 to 3: diffuse|halfangle|reflection|pixel_halfangle
  parameter NORMALIZER_N       = 1,  // 0 to 4: none|faithful|compact|lite|near
  parameter NORMALIZER_L       = 1,  // 0 to 4: none|faithful|compact|lite|near; normalizer of the light vector
  parameter NORMALIZER_H       = 1,  // 0 to 4: none|faithful|compact|lite|near; normalizer of the half-angle vector
  parameter NORMALIZE_ORDER    = 0,  // 0 to 1: before|after
  parameter SHARING            = 0,  // 0 to 1: off|on
  parameter BUFFERING          = 0,  // 0 to 1: double|single
  parameter SELF_SHADOW        = 1,  // 0 to 2: off|hard|smooth
  parameter FILTER             = 2,  // 0 to 2: nearest|bilinear|trilinear; texture filter
  parameter DECODE             = 0,  // 0 to 1: range|offset
  parameter PERSPECTIVE        = 0,  // 0 to 1: off|on
  parameter DEPTH              = 1,  // 0 to 1: off|on; z interpolated and put out
  parameter DECAL              = 0,  // 0 to 1: off|on; base colour in texel components 3 to 5
  parameter GLOSS_MAP          = 0,  // 0 to 1: off|on; factor of the highlight in the last texel component
  parameter CHANNELS           = 1,  // 0 to 1: one|three; colour channels: grey | red, green, blue
  parameter SCREEN_BITS        = 10, // 4 to 12; X: the screen is at most 2^X by 2^X pixels
  parameter SUBPIXEL_BITS      = 8,  // 2 to 8; S: vertices lie on a grid of 2^-S pixel
  parameter GUARD_BITS         = 10, // 2 to 14; G: extra fraction bits of every interpolator
  parameter VECTOR_BITS        = 9,  // 5 to 18; V: fraction bits of vectors before normalization (s1.V)
  parameter WIDE_BITS          = 16, // 8 to 22; VW: fraction bits of Pu x Pv, Pv x N, N x Pu (s1.VW); blinn only
  parameter GRADIENT_BITS      = 9,  // 6 to 12; GB: fraction bits of fu, fv after filtering (s0.GB); blinn only
  parameter UV_INTEGER_BITS    = 4,  // 1 to 10; UI: integer bits of u and v, sign included (sUI-1.UF)
  parameter UV_BITS            = 18, // 8 to 24; UF: fraction bits of u and v, in repeats of the texture
  parameter Q_BITS             = 18, // 8 to 24; Q: fraction bits of the interpolated 1/w (u0.Q); perspective only
  parameter RECIPROCAL_BITS    = 18, // 8 to 20; R: fraction bits of 1/q (u1.R); at least Q - 1; perspective only
  parameter LOD_BITS           = 5,  // 0 to 8; LB: fraction bits of the level of detail; trilinear only
  parameter WEIGHT_BITS        = 8,  // 1 to 8; B: fraction bits of the bilinear weights
  parameter TEXEL_BITS         = 8,  // 4 to 10; T: bits of a texel component
  parameter UNIT_BITS          = 9,  // 6 to 16; F: fraction bits of unit vectors (s1.F)
  parameter DOT_BITS           = 10, // 6 to 16; DF: fraction bits of N.L and N.H (u1.DF); at most 2F
  parameter POWER_BITS         = 12, // 6 to 18; PF: fraction bits of (N.H)^n (u1.PF); at least DF
  parameter SPECULAR_SQUARINGS = 5,  // 0 to 8; K: exponents 0, 1, 2, 4 ... 2^K; halfangle only
  parameter COLOUR_BITS        = 8,  // 4 to 12; C: bits of a colour channel
  parameter DEPTH_BITS         = 20, // 8 to 24; Z: bits of z (u0.Z)
  parameter TEXTURE_FIFO_BITS  = 4   // 1 to 8; fragments that may wait for texels: 2^bits
`endif

`ifdef WRINKLE_SECTION_DERIVED
  // bits of an element of the first vector interpolated in the place of N, without guard bits; 0: there is none
  localparam FRAME_0_WIDTH = DATAPATH == 0 ? VECTOR_BITS + 2 : DATAPATH == 1 ? VECTOR_BITS + 2 : DATAPATH == 2 ?
    WIDE_BITS + 2 : DATAPATH == 3 ? 0 : VECTOR_BITS + 2;
  localparam FRAME_0_HELD = 0;  // 1: it is held over a triangle
  // bits of an element of the second vector interpolated in the place of N, without guard bits; 0: there is none
  localparam FRAME_1_WIDTH = DATAPATH == 0 ? 0 : DATAPATH == 1 ? 0 : DATAPATH == 2 ? WIDE_BITS + 2 : DATAPATH == 3 ? 0 :
    0;
  // 1: it is held over a triangle
  localparam FRAME_1_HELD = DATAPATH == 0 ? 0 : DATAPATH == 1 ? 0 : DATAPATH == 2 ? (CROSS_PRODUCTS != 0 ? 1 : 0) :
    DATAPATH == 3 ? 0 : 0;
  // bits of an element of the third vector interpolated in the place of N, without guard bits; 0: there is none
  localparam FRAME_2_WIDTH = DATAPATH == 0 ? 0 : DATAPATH == 1 ? 0 : DATAPATH == 2 ? WIDE_BITS + 2 : DATAPATH == 3 ? 0 :
    0;
  // 1: it is held over a triangle
  localparam FRAME_2_HELD = DATAPATH == 0 ? 0 : DATAPATH == 1 ? 0 : DATAPATH == 2 ? (CROSS_PRODUCTS != 0 ? 1 : 0) :
    DATAPATH == 3 ? 0 : 0;
  // components of the bump map in a texel
  localparam BUMP_COMPONENTS = DATAPATH == 0 ? 0 : DATAPATH == 1 ? 3 : DATAPATH == 2 ? 2 : DATAPATH == 3 ? 0 : 2;
  // bits of such a component when it is decoded
  localparam BUMP_WIDTH = DATAPATH == 0 ? 0 : DATAPATH == 1 ? VECTOR_BITS + 2 : DATAPATH == 2 ? GRADIENT_BITS + 1 :
    DATAPATH == 3 ? 0 : VECTOR_BITS + 1;
  // its fraction bits
  localparam BUMP_FRACTION = DATAPATH == 0 ? 0 : DATAPATH == 1 ? VECTOR_BITS : DATAPATH == 2 ? GRADIENT_BITS : DATAPATH
    == 3 ? 0 : VECTOR_BITS;
  // code c stands for 2c less so much, in units of 2^-T
  localparam BUMP_OFFSET = DATAPATH == 0 ? 0 : DATAPATH == 1 ? ((1 << TEXEL_BITS) - (DECODE == 0 ? 1 : 0)) : DATAPATH ==
    2 ? 1 << TEXEL_BITS : DATAPATH == 3 ? 0 : 1 << TEXEL_BITS;
  // 1: what is decoded may leave its format by rounding
  localparam BUMP_SATURATES = DATAPATH == 0 ? 0 : DATAPATH == 1 ? 0 : DATAPATH == 2 ? 1 : DATAPATH == 3 ? 0 : 1;
  // bits of an element of N'; 0: N' is (0, 0, 1)
  localparam NORMAL_WIDTH = DATAPATH == 0 ? VECTOR_BITS + 2 : DATAPATH == 1 ? VECTOR_BITS + 2 : DATAPATH == 2 ?
    WIDE_BITS + 3 : DATAPATH == 3 ? 0 : VECTOR_BITS + 2;
  // V of the unit that normalizes N', which takes s1.V
  localparam NORMAL_INPUT_BITS = DATAPATH == 0 ? VECTOR_BITS : DATAPATH == 1 ? VECTOR_BITS : DATAPATH == 2 ? WIDE_BITS +
    1 : DATAPATH == 3 ? 0 : VECTOR_BITS;
  // 1: N' has any length
  localparam NORMAL_ANY_LENGTH = DATAPATH == 0 ? 0 : DATAPATH == 1 ? 0 : DATAPATH == 2 ? 1 : DATAPATH == 3 ? 0 : 1;
  // 1: N' has the format of L and H, so that one unit normalizes all three
  localparam NORMAL_LIKE_LIGHT = DATAPATH == 0 ? 1 : DATAPATH == 1 ? 1 : DATAPATH == 2 ? 0 : DATAPATH == 3 ? 0 : 1;
  // cosine of the light at the unperturbed surface of a bumped draw: L.z, else N.L
  localparam SURFACE_IS_Z = DATAPATH == 0 ? 0 : DATAPATH == 1 ? 1 : DATAPATH == 2 ? 0 : DATAPATH == 3 ? 0 : 1;
  // 1: L and H may be constants of a draw
  localparam LIGHT_MAY_BE_CONSTANT = DATAPATH == 0 ? 1 : DATAPATH == 1 ? 1 : DATAPATH == 2 ? 1 : DATAPATH == 3 ? 0 : 0;
  // bits of what is interpolated in the place of N
  localparam FRAME = 3 * (FRAME_0_WIDTH + FRAME_1_WIDTH + FRAME_2_WIDTH);
  localparam NORMAL = 3 * NORMAL_WIDTH;  // bits of N'
  localparam GLOSSY = LIGHTING != 0 ? 1 : 0;  // 1: a third vector, H or the view vector E, and with it a highlight
  // bits of an element of L and H before normalization, s1.V; 0: constants of the draw
  localparam LIGHT_WIDTH = LIGHT_VECTORS == 0 ? VECTOR_BITS + 2 : 0;
  localparam L_VECTOR = 3 * LIGHT_WIDTH;  // bits of L
  localparam H_VECTOR = GLOSSY * L_VECTOR;  // bits of H, or of E
  localparam COLOURS = DECAL != 0 ? 3 : 0;  // components of the base colour
  localparam TEXELS = BUMP_COMPONENTS + COLOURS + GLOSS_MAP;  // components of a texel: bump map, base colour, gloss
  localparam TEXTURED = TEXELS != 0 ? 1 : 0;  // 1: there is a texture unit
  localparam BUMP = BUMP_COMPONENTS * BUMP_WIDTH;  // bits of the decoded bump map
  localparam DECALS = COLOURS * TEXEL_BITS;  // bits of the base colour
  localparam GLOSS_BITS = GLOSS_MAP * TEXEL_BITS;  // bits of the gloss
  localparam UV = TEXTURED != 0 ? UV_INTEGER_BITS + UV_BITS : 0;  // bits of u, of v
  localparam Q = PERSPECTIVE != 0 && TEXTURED != 0 ? Q_BITS : 0;  // bits of the interpolated 1/w; 0: no division
  localparam LOD = TEXTURED == 0 ? 0 : FILTER == 2 ? 6 + LOD_BITS : 6;  // bits of the level of detail
  localparam LOD_PLANE = Q != 0 ? LOD : 0;  // the same where it is interpolated
  // the same where it is held over a triangle: without a sign, and below 16
  localparam LOD_HELD = Q == 0 && LOD != 0 ? LOD - 2 : 0;
  localparam Z = DEPTH != 0 ? DEPTH_BITS : 0;  // bits of z
  localparam COUNT = CHANNELS != 0 ? 3 : 1;  // colour channels
  // bits of N, of L and of H as `normalize` hands them on: unit vectors s1.F, or mantissas s0.F
  localparam UNIT = 3 * (NORMALIZE_ORDER != 0 ? UNIT_BITS + 1 : UNIT_BITS + 2);
  localparam SCALE = UNIT_BITS == 15 ? 18 : UNIT_BITS + 2;  // bits of a reciprocal length, u1.RB
  localparam SCALES = NORMALIZE_ORDER != 0 ? (GLOSSY + 2) * SCALE : 0;  // bits of those of all vectors
  // bits of a light vector that is constant over a draw
  localparam CONSTANT = LIGHT_VECTORS != 0 ? 3 * (UNIT_BITS + 2) : 0;
  localparam TAG = 2 * SCREEN_BITS + 1 + Z;  // what every stage carries along: {z, last, y, x}
  // bits that go past `texture`: the tag, and what later stages read
  localparam TEXTURE_CARRY = TAG + L_VECTOR + H_VECTOR + FRAME;
  localparam PERSPECTIVE_CARRY = TEXTURE_CARRY + LOD_PLANE + LOD_HELD;  // bits that go past `perspective`
  localparam INTERPOLATED = PERSPECTIVE_CARRY - TAG + Z + 2 * UV + Q;  // bits that `interpolate` hands on
  localparam NORMALIZE_CARRY = TAG + DECALS + GLOSS_BITS;  // bits that go past `normalize`
  localparam PERTURB_CARRY = NORMALIZE_CARRY + L_VECTOR + H_VECTOR;  // bits that go past `perturb`
  localparam LIGHT_CARRY = NORMALIZE_CARRY + 1;  // bits that go past `light`
  localparam EDGE_BITS = SCREEN_BITS + SUBPIXEL_BITS + 2;  // bits of the denominator of an edge
  // bits of the scan part of a packet
  localparam SCAN_BITS = 5 + SCREEN_BITS + 2 * (SCREEN_BITS + 1) + 3 * (2 * (SCREEN_BITS + 2) + 3 * EDGE_BITS + 1);
  localparam SCAN_WORDS = (SCAN_BITS + 63) / 64;  // its words
  localparam DRAW_WORDS = LIGHT_VECTORS != 0 ? 6 : 4;  // words of a draw packet
  // L and the third vector interpolated and normalized; else constants of the draw
  localparam HAS_LIGHT_PLANES = LIGHT_VECTORS == 0 ? 1 : 0;
  localparam DIVIDES = Q != 0 ? 1 : 0;  // u and v are divided by q
  localparam LOD_FRACTION_BITS = FILTER == 2 ? LOD_BITS : 0;  // fraction bits of the level of detail as it is used
  localparam VECTOR_WIDTH = VECTOR_BITS + 2;  // bits of vectors before normalization, s1.V
  localparam UV_WIDTH = UV_INTEGER_BITS + UV_BITS;  // bits of u and v
  // The list of wrinkle_interpolate: of each field the number of elements, the bits of one, whether it is held over
  // a triangle, and how many stages further on it is first read.
  localparam FIELDS = 11;
  localparam FIELD_FRAME_0_ELEMENTS = FRAME_0_WIDTH != 0 ? 3 : 0;
  localparam FIELD_FRAME_0_WIDTH = FRAME_0_WIDTH;
  localparam FIELD_FRAME_1_ELEMENTS = FRAME_1_WIDTH != 0 ? 3 : 0;
  localparam FIELD_FRAME_1_WIDTH = FRAME_1_WIDTH;
  localparam FIELD_FRAME_2_ELEMENTS = FRAME_2_WIDTH != 0 ? 3 : 0;
  localparam FIELD_FRAME_2_WIDTH = FRAME_2_WIDTH;
  localparam FIELD_L_ELEMENTS = HAS_LIGHT_PLANES != 0 ? 3 : 0;
  localparam FIELD_L_WIDTH = VECTOR_WIDTH;
  localparam FIELD_H_ELEMENTS = GLOSSY != 0 && HAS_LIGHT_PLANES != 0 ? 3 : 0;
  localparam FIELD_H_WIDTH = VECTOR_WIDTH;
  localparam FIELD_U_ELEMENTS = TEXTURED != 0 ? 1 : 0;
  localparam FIELD_U_WIDTH = UV_WIDTH;
  localparam FIELD_V_ELEMENTS = TEXTURED != 0 ? 1 : 0;
  localparam FIELD_V_WIDTH = UV_WIDTH;
  localparam FIELD_Q_ELEMENTS = DIVIDES != 0 ? 1 : 0;
  localparam FIELD_Q_WIDTH = Q_BITS;
  localparam FIELD_LOD_ELEMENTS = TEXTURED != 0 && DIVIDES != 0 ? 1 : 0;
  localparam FIELD_LOD_WIDTH = 6 + LOD_FRACTION_BITS;
  localparam FIELD_Z_ELEMENTS = DEPTH != 0 ? 1 : 0;
  localparam FIELD_Z_WIDTH = DEPTH_BITS;
  localparam FIELD_LOD_HELD_ELEMENTS = TEXTURED != 0 && DIVIDES == 0 ? 1 : 0;
  localparam FIELD_LOD_HELD_WIDTH = 6 + LOD_FRACTION_BITS - 2;
  // bits of the planes part of a packet
  localparam PLANE_BITS = FIELD_FRAME_0_ELEMENTS * (FRAME_0_HELD != 0 ? FIELD_FRAME_0_WIDTH : 3 * (FIELD_FRAME_0_WIDTH +
    GUARD_BITS)) + FIELD_FRAME_1_ELEMENTS * (FRAME_1_HELD != 0 ? FIELD_FRAME_1_WIDTH : 3 * (FIELD_FRAME_1_WIDTH +
    GUARD_BITS)) + FIELD_FRAME_2_ELEMENTS * (FRAME_2_HELD != 0 ? FIELD_FRAME_2_WIDTH : 3 * (FIELD_FRAME_2_WIDTH +
    GUARD_BITS)) + FIELD_L_ELEMENTS * 3 * (FIELD_L_WIDTH + GUARD_BITS) + FIELD_H_ELEMENTS * 3 * (FIELD_H_WIDTH +
    GUARD_BITS) + FIELD_U_ELEMENTS * 3 * (FIELD_U_WIDTH + GUARD_BITS) + FIELD_V_ELEMENTS * 3 * (FIELD_V_WIDTH +
    GUARD_BITS) + FIELD_Q_ELEMENTS * 3 * (FIELD_Q_WIDTH + GUARD_BITS) + FIELD_LOD_ELEMENTS * 3 * (FIELD_LOD_WIDTH +
    GUARD_BITS) + FIELD_Z_ELEMENTS * 3 * (FIELD_Z_WIDTH + GUARD_BITS) + FIELD_LOD_HELD_ELEMENTS * FIELD_LOD_HELD_WIDTH;
  localparam PLANE_WORDS = (PLANE_BITS + 63) / 64;  // its words
  localparam [32*FIELDS-1:0] FIELD_ELEMENTS = {
    32'd0 | FIELD_LOD_HELD_ELEMENTS[31:0],
    32'd0 | FIELD_Z_ELEMENTS[31:0],
    32'd0 | FIELD_LOD_ELEMENTS[31:0],
    32'd0 | FIELD_Q_ELEMENTS[31:0],
    32'd0 | FIELD_V_ELEMENTS[31:0],
    32'd0 | FIELD_U_ELEMENTS[31:0],
    32'd0 | FIELD_H_ELEMENTS[31:0],
    32'd0 | FIELD_L_ELEMENTS[31:0],
    32'd0 | FIELD_FRAME_2_ELEMENTS[31:0],
    32'd0 | FIELD_FRAME_1_ELEMENTS[31:0],
    32'd0 | FIELD_FRAME_0_ELEMENTS[31:0]};
  localparam [32*FIELDS-1:0] FIELD_WIDTHS = {
    32'd0 | FIELD_LOD_HELD_WIDTH[31:0],
    32'd0 | FIELD_Z_WIDTH[31:0],
    32'd0 | FIELD_LOD_WIDTH[31:0],
    32'd0 | FIELD_Q_WIDTH[31:0],
    32'd0 | FIELD_V_WIDTH[31:0],
    32'd0 | FIELD_U_WIDTH[31:0],
    32'd0 | FIELD_H_WIDTH[31:0],
    32'd0 | FIELD_L_WIDTH[31:0],
    32'd0 | FIELD_FRAME_2_WIDTH[31:0],
    32'd0 | FIELD_FRAME_1_WIDTH[31:0],
    32'd0 | FIELD_FRAME_0_WIDTH[31:0]};
  localparam [32*FIELDS-1:0] FIELD_HELD = {
    32'd1,
    32'd0,
    32'd0,
    32'd0,
    32'd0,
    32'd0,
    32'd0,
    32'd0,
    32'd0 | FRAME_2_HELD[31:0],
    32'd0 | FRAME_1_HELD[31:0],
    32'd0 | FRAME_0_HELD[31:0]};
  localparam [32*FIELDS-1:0] FIELD_READERS = {
    32'd2,
    32'd6,
    32'd2,
    32'd1,
    32'd1,
    32'd1,
    32'd4,
    32'd4,
    32'd3,
    32'd3,
    32'd3};
`endif

`ifdef WRINKLE_SECTION_RULES
  generate
    if (DATAPATH < 0 || DATAPATH > 4) begin : datapath_range
      wrinkle_error_datapath_is_not_0_to_4 error ();
    end
    if (CROSS_PRODUCTS < 0 || CROSS_PRODUCTS > 1) begin : cross_products_range
      wrinkle_error_cross_products_is_not_0_to_1 error ();
    end
    if (LIGHT_VECTORS < 0 || LIGHT_VECTORS > 1) begin : light_vectors_range
      wrinkle_error_light_vectors_is_not_0_to_1 error ();
    end
    if (LIGHTING < 0 || LIGHTING > 3) begin : lighting_range
      wrinkle_error_lighting_is_not_0_to_3 error ();
    end
    if (NORMALIZER_N < 0 || NORMALIZER_N > 4) begin : normalizer_n_range
      wrinkle_error_normalizer_n_is_not_0_to_4 error ();
    end
    if (NORMALIZER_L < 0 || NORMALIZER_L > 4) begin : normalizer_l_range
      wrinkle_error_normalizer_l_is_not_0_to_4 error ();
    end
    if (NORMALIZER_H < 0 || NORMALIZER_H > 4) begin : normalizer_h_range
      wrinkle_error_normalizer_h_is_not_0_to_4 error ();
    end
    if (NORMALIZE_ORDER < 0 || NORMALIZE_ORDER > 1) begin : normalize_order_range
      wrinkle_error_normalize_order_is_not_0_to_1 error ();
    end
    if (SHARING < 0 || SHARING > 1) begin : sharing_range
      wrinkle_error_sharing_is_not_0_to_1 error ();
    end
    if (BUFFERING < 0 || BUFFERING > 1) begin : buffering_range
      wrinkle_error_buffering_is_not_0_to_1 error ();
    end
    if (SELF_SHADOW < 0 || SELF_SHADOW > 2) begin : self_shadow_range
      wrinkle_error_self_shadow_is_not_0_to_2 error ();
    end
    if (FILTER < 0 || FILTER > 2) begin : filter_range
      wrinkle_error_filter_is_not_0_to_2 error ();
    end
    if (DECODE < 0 || DECODE > 1) begin : decode_range
      wrinkle_error_decode_is_not_0_to_1 error ();
    end
    if (PERSPECTIVE < 0 || PERSPECTIVE > 1) begin : perspective_range
      wrinkle_error_perspective_is_not_0_to_1 error ();
    end
    if (DEPTH < 0 || DEPTH > 1) begin : depth_range
      wrinkle_error_depth_is_not_0_to_1 error ();
    end
    if (DECAL < 0 || DECAL > 1) begin : decal_range
      wrinkle_error_decal_is_not_0_to_1 error ();
    end
    if (GLOSS_MAP < 0 || GLOSS_MAP > 1) begin : gloss_map_range
      wrinkle_error_gloss_map_is_not_0_to_1 error ();
    end
    if (CHANNELS < 0 || CHANNELS > 1) begin : channels_range
      wrinkle_error_channels_is_not_0_to_1 error ();
    end
    if (SCREEN_BITS < 4 || SCREEN_BITS > 12) begin : screen_bits_range
      wrinkle_error_screen_bits_is_not_4_to_12 error ();
    end
    if (SUBPIXEL_BITS < 2 || SUBPIXEL_BITS > 8) begin : subpixel_bits_range
      wrinkle_error_subpixel_bits_is_not_2_to_8 error ();
    end
    if (GUARD_BITS < 2 || GUARD_BITS > 14) begin : guard_bits_range
      wrinkle_error_guard_bits_is_not_2_to_14 error ();
    end
    if (VECTOR_BITS < 5 || VECTOR_BITS > 18) begin : vector_bits_range
      wrinkle_error_vector_bits_is_not_5_to_18 error ();
    end
    if (WIDE_BITS < 8 || WIDE_BITS > 22) begin : wide_bits_range
      wrinkle_error_wide_bits_is_not_8_to_22 error ();
    end
    if (GRADIENT_BITS < 6 || GRADIENT_BITS > 12) begin : gradient_bits_range
      wrinkle_error_gradient_bits_is_not_6_to_12 error ();
    end
    if (UV_INTEGER_BITS < 1 || UV_INTEGER_BITS > 10) begin : uv_integer_bits_range
      wrinkle_error_uv_integer_bits_is_not_1_to_10 error ();
    end
    if (UV_BITS < 8 || UV_BITS > 24) begin : uv_bits_range
      wrinkle_error_uv_bits_is_not_8_to_24 error ();
    end
    if (Q_BITS < 8 || Q_BITS > 24) begin : q_bits_range
      wrinkle_error_q_bits_is_not_8_to_24 error ();
    end
    if (RECIPROCAL_BITS < 8 || RECIPROCAL_BITS > 20) begin : reciprocal_bits_range
      wrinkle_error_reciprocal_bits_is_not_8_to_20 error ();
    end
    if (LOD_BITS < 0 || LOD_BITS > 8) begin : lod_bits_range
      wrinkle_error_lod_bits_is_not_0_to_8 error ();
    end
    if (WEIGHT_BITS < 1 || WEIGHT_BITS > 8) begin : weight_bits_range
      wrinkle_error_weight_bits_is_not_1_to_8 error ();
    end
    if (TEXEL_BITS < 4 || TEXEL_BITS > 10) begin : texel_bits_range
      wrinkle_error_texel_bits_is_not_4_to_10 error ();
    end
    if (UNIT_BITS < 6 || UNIT_BITS > 16) begin : unit_bits_range
      wrinkle_error_unit_bits_is_not_6_to_16 error ();
    end
    if (DOT_BITS < 6 || DOT_BITS > 16) begin : dot_bits_range
      wrinkle_error_dot_bits_is_not_6_to_16 error ();
    end
    if (POWER_BITS < 6 || POWER_BITS > 18) begin : power_bits_range
      wrinkle_error_power_bits_is_not_6_to_18 error ();
    end
    if (SPECULAR_SQUARINGS < 0 || SPECULAR_SQUARINGS > 8) begin : specular_squarings_range
      wrinkle_error_specular_squarings_is_not_0_to_8 error ();
    end
    if (COLOUR_BITS < 4 || COLOUR_BITS > 12) begin : colour_bits_range
      wrinkle_error_colour_bits_is_not_4_to_12 error ();
    end
    if (DEPTH_BITS < 8 || DEPTH_BITS > 24) begin : depth_bits_range
      wrinkle_error_depth_bits_is_not_8_to_24 error ();
    end
    if (TEXTURE_FIFO_BITS < 1 || TEXTURE_FIFO_BITS > 8) begin : texture_fifo_bits_range
      wrinkle_error_texture_fifo_bits_is_not_1_to_8 error ();
    end
    if (DOT_BITS > 2 * UNIT_BITS) begin : dot_bits_exceeds_twice_unit_bits
      wrinkle_error_dot_bits_exceeds_twice_unit_bits error ();
    end
    if (POWER_BITS < DOT_BITS) begin : power_bits_is_less_than_dot_bits
      wrinkle_error_power_bits_is_less_than_dot_bits error ();
    end
    if (PERSPECTIVE != 0 && RECIPROCAL_BITS < Q_BITS - 1) begin : reciprocal_bits_is_less_than_q_bits_minus_1
      wrinkle_error_reciprocal_bits_is_less_than_q_bits_minus_1 error ();
    end
    if (LIGHT_VECTORS != 0 && LIGHT_MAY_BE_CONSTANT == 0) begin : light_vectors_turn_with_the_frame
      wrinkle_error_light_vectors_turn_with_the_frame error ();
    end
    if (GLOSS_MAP != 0 && LIGHTING == 0) begin : gloss_map_needs_a_highlight
      wrinkle_error_gloss_map_needs_a_highlight error ();
    end
    if (NORMAL_ANY_LENGTH != 0 && (NORMALIZER_N == 0 || NORMALIZER_N == 4)) begin : normalizer_n_must_take_any_length
      wrinkle_error_normalizer_n_must_take_any_length error ();
    end
    if (LIGHTING == 3 && (NORMALIZER_H == 0 || NORMALIZER_H == 4)) begin : normalizer_h_must_take_any_length
      wrinkle_error_normalizer_h_must_take_any_length error ();
    end
    if (NORMALIZE_ORDER != 0 && (NORMAL_WIDTH == 0 || LIGHT_VECTORS != 0)) begin : normalize_order_after_is_of_vectors
      wrinkle_error_normalize_order_after_is_of_vectors error ();
    end
    if (NORMALIZE_ORDER != 0 && (NORMALIZER_N != 1 || NORMALIZER_L != 1 || (LIGHTING != 0 && NORMALIZER_H != 1))) begin
    : normalize_order_after_is_faithful
      wrinkle_error_normalize_order_after_is_faithful error ();
    end
    if (NORMALIZE_ORDER != 0 && LIGHTING > 1) begin : normalize_order_after_has_no_view_vector
      wrinkle_error_normalize_order_after_has_no_view_vector error ();
    end
    if (NORMALIZE_ORDER != 0 && SELF_SHADOW != 0) begin : normalize_order_after_has_no_self_shadow
      wrinkle_error_normalize_order_after_has_no_self_shadow error ();
    end
    if (SHARING != 0 && (NORMAL_LIKE_LIGHT == 0 || LIGHT_VECTORS != 0)) begin : sharing_is_of_n_l_h_of_one_format
      wrinkle_error_sharing_is_of_n_l_h_of_one_format error ();
    end
    if (SHARING != 0 && (NORMALIZER_N == 0 || NORMALIZER_L != NORMALIZER_N || (LIGHTING != 0 && NORMALIZER_H !=
    NORMALIZER_N))) begin : sharing_is_of_n_l_h_of_one_normalizer
      wrinkle_error_sharing_is_of_n_l_h_of_one_normalizer error ();
    end
    if (SHARING != 0 && LIGHTING != 1) begin : sharing_is_of_n_l_h_with_halfangle
      wrinkle_error_sharing_is_of_n_l_h_with_halfangle error ();
    end
    if (SHARING != 0 && NORMALIZE_ORDER != 0) begin : sharing_is_of_unit_vectors
      wrinkle_error_sharing_is_of_unit_vectors error ();
    end
  endgenerate
`endif

`ifdef WRINKLE_SECTION_PERTURB
  generate
    if (DATAPATH == 0) begin : phong
      wrinkle_perturb_phong #(.FRAME(FRAME), .BUMP(BUMP), .NORMAL(NORMAL), .CARRY(PERTURB_CARRY)) perturb (
        .clk(clk), .rst(rst), .draw_bump_i(draw_bump), .in_valid_i(texture_valid), .in_ready_o(texture_ready),
        .frame_i(texture_frame), .bump_i(texture_bump), .carry_i(texture_others), .out_valid_o(perturb_valid),
        .out_ready_i(perturb_ready), .n_o(perturb_n), .carry_o(perturb_others), .busy_o(perturb_busy));
    end else if (DATAPATH == 1) begin : normal_map
      wrinkle_perturb_normal_map #(.FRAME(FRAME), .BUMP(BUMP), .NORMAL(NORMAL), .CARRY(PERTURB_CARRY)) perturb (
        .clk(clk), .rst(rst), .draw_bump_i(draw_bump), .in_valid_i(texture_valid), .in_ready_o(texture_ready),
        .frame_i(texture_frame), .bump_i(texture_bump), .carry_i(texture_others), .out_valid_o(perturb_valid),
        .out_ready_i(perturb_ready), .n_o(perturb_n), .carry_o(perturb_others), .busy_o(perturb_busy));
    end else if (DATAPATH == 2) begin : blinn
      wrinkle_perturb_blinn #(.FRAME(FRAME), .BUMP(BUMP), .NORMAL(NORMAL), .CARRY(PERTURB_CARRY)) perturb (
        .clk(clk), .rst(rst), .draw_bump_i(draw_bump), .in_valid_i(texture_valid), .in_ready_o(texture_ready),
        .frame_i(texture_frame), .bump_i(texture_bump), .carry_i(texture_others), .out_valid_o(perturb_valid),
        .out_ready_i(perturb_ready), .n_o(perturb_n), .carry_o(perturb_others), .busy_o(perturb_busy));
    end else if (DATAPATH == 3) begin : rotated
      wrinkle_perturb_rotated #(.FRAME(FRAME), .BUMP(BUMP), .NORMAL(NORMAL), .CARRY(PERTURB_CARRY)) perturb (
        .clk(clk), .rst(rst), .draw_bump_i(draw_bump), .in_valid_i(texture_valid), .in_ready_o(texture_ready),
        .frame_i(texture_frame), .bump_i(texture_bump), .carry_i(texture_others), .out_valid_o(perturb_valid),
        .out_ready_i(perturb_ready), .n_o(perturb_n), .carry_o(perturb_others), .busy_o(perturb_busy));
    end else if (DATAPATH == 4) begin : offset
      wrinkle_perturb_offset #(.FRAME(FRAME), .BUMP(BUMP), .NORMAL(NORMAL), .CARRY(PERTURB_CARRY)) perturb (
        .clk(clk), .rst(rst), .draw_bump_i(draw_bump), .in_valid_i(texture_valid), .in_ready_o(texture_ready),
        .frame_i(texture_frame), .bump_i(texture_bump), .carry_i(texture_others), .out_valid_o(perturb_valid),
        .out_ready_i(perturb_ready), .n_o(perturb_n), .carry_o(perturb_others), .busy_o(perturb_busy));
    end
  endgenerate
`endif
