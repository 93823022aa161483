// What wrinkle_core can be: its parameters, what follows from them, and which of them are illegal together. Made by
// `./wrinkle generate` from golden/config/*.def and golden/datapath/*.h; change those. The file is included once for each
// of its sections, with the macro defined that selects it:
//
//   WRINKLE_PARAMETERS   in a parameter list: every parameter with its default
//   WRINKLE_DERIVED      in a module: local parameters, which nobody can override
//   WRINKLE_RULES        in a module: an illegal configuration stops the elaboration in every tool, by an instance of a
//                        module that does not exist and whose name says the fault; a legal one leaves nothing

`ifdef WRINKLE_PARAMETERS
  parameter DATAPATH           = 1,  // phong|normal_map|blinn|rotated
  parameter CROSS_PRODUCTS     = 0,  // interpolated|constant
  parameter LIGHT_VECTORS      = 0,  // interpolated|constant
  parameter LIGHTING           = 1,  // diffuse|halfangle|reflection|pixel_halfangle
  parameter NORMALIZER_N       = 1,  // none|faithful|compact|lite|near
  parameter NORMALIZER_L       = 1,  // none|faithful|compact|lite|near; normalizer of the light vector
  parameter NORMALIZER_H       = 1,  // none|faithful|compact|lite|near; normalizer of the half-angle vector
  parameter NORMALIZE_ORDER    = 0,  // before|after
  parameter SHARING            = 0,  // off|on
  parameter BUFFERING          = 0,  // double|single
  parameter SELF_SHADOW        = 1,  // off|hard|smooth
  parameter FILTER             = 2,  // nearest|bilinear|trilinear; texture filter
  parameter DECODE             = 0,  // range|offset
  parameter PERSPECTIVE        = 0,  // off|on
  parameter DEPTH              = 1,  // off|on; z interpolated and put out
  parameter DECAL              = 0,  // off|on; base colour in texel components 3 to 5
  parameter CHANNELS           = 1,  // one|three; colour channels: grey | red, green, blue
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

`ifdef WRINKLE_DERIVED
  // vectors interpolated in the place of N
  localparam FRAME_VECTORS = DATAPATH == 0 ? 1 : DATAPATH == 1 ? 1 : DATAPATH == 2 ? 3 : 0;
  // bits of an element of such a vector, without guard bits
  localparam FRAME_WIDTH = DATAPATH == 0 ? VECTOR_BITS + 2 : DATAPATH == 1 ? VECTOR_BITS + 2 : DATAPATH == 2 ? WIDE_BITS + 2 : 0;
  // how many of the vectors, the last ones, are held over a triangle
  localparam FRAME_HELD = DATAPATH == 0 ? 0 : DATAPATH == 1 ? 0 : DATAPATH == 2 ? (CROSS_PRODUCTS != 0 ? 2 : 0) : 0;
  // components of the bump map in a texel
  localparam BUMP_ELEMENTS = DATAPATH == 0 ? 0 : DATAPATH == 1 ? 3 : DATAPATH == 2 ? 2 : 0;
  // bits of such a component when it is decoded
  localparam BUMP_WIDTH = DATAPATH == 0 ? 0 : DATAPATH == 1 ? VECTOR_BITS + 2 : DATAPATH == 2 ? GRADIENT_BITS + 1 : 0;
  // its fraction bits
  localparam BUMP_BITS = DATAPATH == 0 ? 0 : DATAPATH == 1 ? VECTOR_BITS : DATAPATH == 2 ? GRADIENT_BITS : 0;
  // code c stands for 2c - (2^T - 1), else for 2c - 2^T, in units of 2^-T
  localparam BUMP_ODD = DATAPATH == 0 ? 0 : DATAPATH == 1 ? (DECODE == 0 ? 1 : 0) : DATAPATH == 2 ? 0 : 0;
  // 1: what is decoded may leave its format by rounding
  localparam BUMP_SATURATES = DATAPATH == 0 ? 0 : DATAPATH == 1 ? 0 : DATAPATH == 2 ? 1 : 0;
  // bits of an element of N'; 0: N' is (0, 0, 1)
  localparam NORMAL_WIDTH = DATAPATH == 0 ? VECTOR_BITS + 2 : DATAPATH == 1 ? VECTOR_BITS + 2 : DATAPATH == 2 ? WIDE_BITS + 3 : 0;
  // V of the unit that normalizes N', which takes s1.V
  localparam NORMAL_INPUT_BITS = DATAPATH == 0 ? VECTOR_BITS : DATAPATH == 1 ? VECTOR_BITS : DATAPATH == 2 ? WIDE_BITS + 1 : 0;
  localparam NORMAL_ANY_LENGTH = DATAPATH == 0 ? 0 : DATAPATH == 1 ? 0 : DATAPATH == 2 ? 1 : 0;  // 1: N' has any length
  // 1: N' has the format of L and H, so that one unit normalizes all three
  localparam NORMAL_LIKE_LIGHT = DATAPATH == 0 ? 1 : DATAPATH == 1 ? 1 : DATAPATH == 2 ? 0 : 0;
  // cosine of the light at the unperturbed surface of a bumped draw: 1: L.z; 0: N.L
  localparam COSINE_OF_LIGHT = DATAPATH == 0 ? 0 : DATAPATH == 1 ? 1 : DATAPATH == 2 ? 0 : 0;
  // 1: L and H may be constants of a draw
  localparam LIGHT_MAY_BE_CONSTANT = DATAPATH == 0 ? 1 : DATAPATH == 1 ? 1 : DATAPATH == 2 ? 1 : 0;
  localparam HAS_SPECULAR = LIGHTING != 0 ? 1 : 0;  // a third vector, H or the view vector E, and with it a highlight
  localparam TEXEL_COMPONENTS = BUMP_ELEMENTS + (DECAL != 0 ? 3 : 0);  // components of a texel: bump map, base colour
  localparam HAS_TEXTURE = TEXEL_COMPONENTS != 0 ? 1 : 0;  // there is a texture unit
`endif

`ifdef WRINKLE_RULES
  generate
    if (DATAPATH < 0 || DATAPATH > 3) begin : datapath_range
      wrinkle_error_datapath_is_not_0_to_3 error ();
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
    if (NORMAL_ANY_LENGTH != 0 && (NORMALIZER_N == 0 || NORMALIZER_N == 4)) begin : normalizer_n_must_take_any_length
      wrinkle_error_normalizer_n_must_take_any_length error ();
    end
    if (LIGHTING == 3 && (NORMALIZER_H == 0 || NORMALIZER_H == 4)) begin : normalizer_h_must_take_any_length
      wrinkle_error_normalizer_h_must_take_any_length error ();
    end
    if (NORMALIZE_ORDER != 0 && (NORMAL_WIDTH == 0 || LIGHT_VECTORS != 0)) begin : normalize_order_after_is_of_vectors
      wrinkle_error_normalize_order_after_is_of_vectors error ();
    end
    if (NORMALIZE_ORDER != 0 && (NORMALIZER_N != 1 || NORMALIZER_L != 1 || (LIGHTING != 0 && NORMALIZER_H != 1))) begin : normalize_order_after_is_faithful
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
    if (SHARING != 0 && (NORMALIZER_N == 0 || NORMALIZER_L != NORMALIZER_N || (LIGHTING != 0 && NORMALIZER_H != NORMALIZER_N))) begin : sharing_is_of_n_l_h_of_one_normalizer
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
