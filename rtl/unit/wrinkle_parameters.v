`default_nettype none
// Stops the elaboration of an illegal configuration in every tool: it instantiates a module that does not exist and
// whose name says the fault. The rules are those of check() in golden/config.cpp; ranges are golden/parameters.def.
// A legal configuration leaves nothing.
module wrinkle_parameters #(
  parameter DATAPATH           = 1,
  parameter CROSS_PRODUCTS     = 0,
  parameter BLOCK_EXPONENT     = 0,
  parameter LIGHT_VECTORS      = 0,
  parameter LIGHTING           = 1,
  parameter NORMALIZER_N       = 1,
  parameter NORMALIZER_L       = 1,
  parameter NORMALIZER_H       = 1,
  parameter NORMALIZE_ORDER    = 0,
  parameter SHARING            = 0,
  parameter BUFFERING          = 0,
  parameter SELF_SHADOW        = 1,
  parameter FILTER             = 2,
  parameter DECODE             = 0,
  parameter PERSPECTIVE        = 0,
  parameter DEPTH              = 1,
  parameter DECAL              = 0,
  parameter CHANNELS           = 1,
  parameter SCREEN_BITS        = 10,
  parameter SUBPIXEL_BITS      = 8,
  parameter GUARD_BITS         = 10,
  parameter VECTOR_BITS        = 9,
  parameter WIDE_BITS          = 16,
  parameter GRADIENT_BITS      = 9,
  parameter UV_INTEGER_BITS    = 4,
  parameter UV_BITS            = 18,
  parameter Q_BITS             = 18,
  parameter RECIPROCAL_BITS    = 18,
  parameter LOD_BITS           = 5,
  parameter WEIGHT_BITS        = 8,
  parameter TEXEL_BITS         = 8,
  parameter UNIT_BITS          = 9,
  parameter DOT_BITS           = 10,
  parameter POWER_BITS         = 12,
  parameter SPECULAR_SQUARINGS = 5,
  parameter COLOUR_BITS        = 8,
  parameter DEPTH_BITS         = 20,
  parameter TEXTURE_FIFO_BITS  = 4
) ();
  generate
    if (DATAPATH < 0 || DATAPATH > 3) begin : datapath
      wrinkle_error_datapath_is_not_0_to_3 error ();
    end
    if (CROSS_PRODUCTS < 0 || CROSS_PRODUCTS > 1) begin : cross_products
      wrinkle_error_cross_products_is_not_0_to_1 error ();
    end
    if (BLOCK_EXPONENT < 0 || BLOCK_EXPONENT > 1) begin : block_exponent
      wrinkle_error_block_exponent_is_not_0_to_1 error ();
    end
    if (LIGHT_VECTORS < 0 || LIGHT_VECTORS > 1) begin : light_vectors
      wrinkle_error_light_vectors_is_not_0_to_1 error ();
    end
    if (LIGHTING < 0 || LIGHTING > 3) begin : lighting
      wrinkle_error_lighting_is_not_0_to_3 error ();
    end
    if (NORMALIZER_N < 0 || NORMALIZER_N > 4) begin : normalizer_n
      wrinkle_error_normalizer_n_is_not_0_to_4 error ();
    end
    if (NORMALIZER_L < 0 || NORMALIZER_L > 4) begin : normalizer_l
      wrinkle_error_normalizer_l_is_not_0_to_4 error ();
    end
    if (NORMALIZER_H < 0 || NORMALIZER_H > 4) begin : normalizer_h
      wrinkle_error_normalizer_h_is_not_0_to_4 error ();
    end
    if (NORMALIZE_ORDER < 0 || NORMALIZE_ORDER > 1) begin : normalize_order
      wrinkle_error_normalize_order_is_not_0_to_1 error ();
    end
    if (SHARING < 0 || SHARING > 1) begin : sharing
      wrinkle_error_sharing_is_not_0_to_1 error ();
    end
    if (BUFFERING < 0 || BUFFERING > 1) begin : buffering
      wrinkle_error_buffering_is_not_0_to_1 error ();
    end
    if (SELF_SHADOW < 0 || SELF_SHADOW > 2) begin : self_shadow
      wrinkle_error_self_shadow_is_not_0_to_2 error ();
    end
    if (FILTER < 0 || FILTER > 2) begin : filter
      wrinkle_error_filter_is_not_0_to_2 error ();
    end
    if (DECODE < 0 || DECODE > 1) begin : decode
      wrinkle_error_decode_is_not_0_to_1 error ();
    end
    if (PERSPECTIVE < 0 || PERSPECTIVE > 1) begin : perspective
      wrinkle_error_perspective_is_not_0_to_1 error ();
    end
    if (DEPTH < 0 || DEPTH > 1) begin : depth
      wrinkle_error_depth_is_not_0_to_1 error ();
    end
    if (DECAL < 0 || DECAL > 1) begin : decal
      wrinkle_error_decal_is_not_0_to_1 error ();
    end
    if (CHANNELS < 0 || CHANNELS > 1) begin : channels
      wrinkle_error_channels_is_not_0_to_1 error ();
    end
    if (SCREEN_BITS < 4 || SCREEN_BITS > 12) begin : screen_bits
      wrinkle_error_screen_bits_is_not_4_to_12 error ();
    end
    if (SUBPIXEL_BITS < 2 || SUBPIXEL_BITS > 8) begin : subpixel_bits
      wrinkle_error_subpixel_bits_is_not_2_to_8 error ();
    end
    if (GUARD_BITS < 2 || GUARD_BITS > 14) begin : guard_bits
      wrinkle_error_guard_bits_is_not_2_to_14 error ();
    end
    if (VECTOR_BITS < 5 || VECTOR_BITS > 18) begin : vector_bits
      wrinkle_error_vector_bits_is_not_5_to_18 error ();
    end
    if (WIDE_BITS < 8 || WIDE_BITS > 22) begin : wide_bits
      wrinkle_error_wide_bits_is_not_8_to_22 error ();
    end
    if (GRADIENT_BITS < 6 || GRADIENT_BITS > 12) begin : gradient_bits
      wrinkle_error_gradient_bits_is_not_6_to_12 error ();
    end
    if (UV_INTEGER_BITS < 1 || UV_INTEGER_BITS > 10) begin : uv_integer_bits
      wrinkle_error_uv_integer_bits_is_not_1_to_10 error ();
    end
    if (UV_BITS < 8 || UV_BITS > 24) begin : uv_bits
      wrinkle_error_uv_bits_is_not_8_to_24 error ();
    end
    if (Q_BITS < 8 || Q_BITS > 24) begin : q_bits
      wrinkle_error_q_bits_is_not_8_to_24 error ();
    end
    if (RECIPROCAL_BITS < 8 || RECIPROCAL_BITS > 20) begin : reciprocal_bits
      wrinkle_error_reciprocal_bits_is_not_8_to_20 error ();
    end
    if (LOD_BITS < 0 || LOD_BITS > 8) begin : lod_bits
      wrinkle_error_lod_bits_is_not_0_to_8 error ();
    end
    if (WEIGHT_BITS < 1 || WEIGHT_BITS > 8) begin : weight_bits
      wrinkle_error_weight_bits_is_not_1_to_8 error ();
    end
    if (TEXEL_BITS < 4 || TEXEL_BITS > 10) begin : texel_bits
      wrinkle_error_texel_bits_is_not_4_to_10 error ();
    end
    if (UNIT_BITS < 6 || UNIT_BITS > 16) begin : unit_bits
      wrinkle_error_unit_bits_is_not_6_to_16 error ();
    end
    if (DOT_BITS < 6 || DOT_BITS > 16) begin : dot_bits
      wrinkle_error_dot_bits_is_not_6_to_16 error ();
    end
    if (POWER_BITS < 6 || POWER_BITS > 18) begin : power_bits
      wrinkle_error_power_bits_is_not_6_to_18 error ();
    end
    if (SPECULAR_SQUARINGS < 0 || SPECULAR_SQUARINGS > 8) begin : specular_squarings
      wrinkle_error_specular_squarings_is_not_0_to_8 error ();
    end
    if (COLOUR_BITS < 4 || COLOUR_BITS > 12) begin : colour_bits
      wrinkle_error_colour_bits_is_not_4_to_12 error ();
    end
    if (DEPTH_BITS < 8 || DEPTH_BITS > 24) begin : depth_bits
      wrinkle_error_depth_bits_is_not_8_to_24 error ();
    end
    if (TEXTURE_FIFO_BITS < 1 || TEXTURE_FIFO_BITS > 8) begin : texture_fifo_bits
      wrinkle_error_texture_fifo_bits_is_not_1_to_8 error ();
    end
    if (DOT_BITS > 2 * UNIT_BITS) begin : dot
      wrinkle_error_dot_bits_exceeds_twice_unit_bits error ();
    end
    if (POWER_BITS < DOT_BITS) begin : power
      wrinkle_error_power_bits_is_less_than_dot_bits error ();
    end
    if (PERSPECTIVE != 0 && RECIPROCAL_BITS < Q_BITS - 1) begin : reciprocal
      wrinkle_error_reciprocal_bits_is_less_than_q_bits_minus_1 error ();
    end
    if (DATAPATH == 3 && LIGHT_VECTORS != 0) begin : rotated
      wrinkle_error_light_vectors_turn_with_the_rotated_frame error ();
    end
    if (DATAPATH == 2 && (NORMALIZER_N == 0 || NORMALIZER_N == 4)) begin : blinn
      wrinkle_error_normalizer_n_must_take_any_length error ();
    end
    if (LIGHTING == 3 && (NORMALIZER_H == 0 || NORMALIZER_H == 4)) begin : pixel_halfangle
      wrinkle_error_normalizer_h_must_take_any_length error ();
    end
    if (NORMALIZE_ORDER != 0 && (DATAPATH == 3 || LIGHT_VECTORS != 0 || NORMALIZER_N != 1 || NORMALIZER_L != 1 ||
                                 (LIGHTING != 0 && NORMALIZER_H != 1) || LIGHTING > 1 || SELF_SHADOW != 0)) begin : after
      wrinkle_error_normalize_order_after_scales_dot_products_of_faithful_vectors_without_self_shadow error ();
    end
    if (SHARING != 0 && (DATAPATH > 1 || LIGHT_VECTORS != 0 || NORMALIZER_N == 0 || NORMALIZER_L != NORMALIZER_N ||
                         NORMALIZER_H != NORMALIZER_N || LIGHTING != 1 || NORMALIZE_ORDER != 0)) begin : shared
      wrinkle_error_sharing_is_of_n_l_h_with_one_kind_of_normalizer_and_halfangle_lighting error ();
    end
  endgenerate
endmodule
`default_nettype wire
