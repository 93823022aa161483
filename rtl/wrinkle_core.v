`default_nettype none
// Wrinkle: the hardware of "Efficient Bump Mapping Hardware" [Peercy97 fig. 1, 2 and 3], one pixel a clock. This is the
// list of its stages; docs/architecture.md has a heading for each, docs/formats.md the ports and packets. A value that
// a stage hands on is the wire STAGE_NAME, its handshake STAGE_valid and STAGE_ready: the bench reads them under these
// names. What there is to choose, and the widths that follow, are wrinkle_config.vh: only it and this file know choices,
// the stages know widths. STAGE_others is what a stage carries along, unread. Every output depends on registers alone.
module wrinkle_core #(
`define WRINKLE_SECTION_PARAMETERS
`include "wrinkle_config.vh"
`undef WRINKLE_SECTION_PARAMETERS
) (
  clk, rst, packet_valid_i, packet_ready_o, packet_word_i, texel_request_valid_o, texel_request_ready_i,
  texel_request_a_o, texel_request_b_o, texel_response_valid_i, texel_response_ready_o, texel_a00_i, texel_a10_i,
  texel_a01_i, texel_a11_i, texel_b00_i, texel_b10_i, texel_b01_i, texel_b11_i, fragment_valid_o, fragment_ready_i,
  fragment_x_o, fragment_y_o, fragment_z_o, fragment_colour_o, fragment_last_o, fragment_zero_o, idle_o
);
`define WRINKLE_SECTION_DERIVED
`include "wrinkle_config.vh"
`undef WRINKLE_SECTION_DERIVED

  input  wire        clk;
  input  wire        rst;                     // synchronous, valid bits and counters only
  input  wire        packet_valid_i;
  output wire        packet_ready_o;
  input  wire [63:0] packet_word_i;
  output wire        texel_request_valid_o;
  input  wire        texel_request_ready_i;
  output wire [(TEXELS != 0 ? 64 : 1)-1:0]                texel_request_a_o;
  output wire [(TEXELS != 0 && FILTER == 2 ? 64 : 1)-1:0] texel_request_b_o;
  input  wire        texel_response_valid_i;
  output wire        texel_response_ready_o;
  input  wire [(TEXELS != 0 ? TEXELS*TEXEL_BITS : 1)-1:0]               texel_a00_i;
  input  wire [(TEXELS != 0 && FILTER > 0 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_a10_i;
  input  wire [(TEXELS != 0 && FILTER > 0 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_a01_i;
  input  wire [(TEXELS != 0 && FILTER > 0 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_a11_i;
  input  wire [(TEXELS != 0 && FILTER > 1 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_b00_i;
  input  wire [(TEXELS != 0 && FILTER > 1 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_b10_i;
  input  wire [(TEXELS != 0 && FILTER > 1 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_b01_i;
  input  wire [(TEXELS != 0 && FILTER > 1 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_b11_i;
  output wire        fragment_valid_o;
  input  wire        fragment_ready_i;
  output wire [SCREEN_BITS-1:0]       fragment_x_o;
  output wire [SCREEN_BITS-1:0]       fragment_y_o;
  output wire [(Z != 0 ? Z : 1)-1:0]  fragment_z_o;       // u0.Z
  output wire [COUNT*COLOUR_BITS-1:0] fragment_colour_o;  // red in the low bits
  output wire        fragment_last_o;         // of its packet
  output wire        fragment_zero_o;         // a zero vector was met
  output wire        idle_o;                  // no packet held, no fragment in flight

`define WRINKLE_SECTION_RULES
`include "wrinkle_config.vh"
`undef WRINKLE_SECTION_RULES

  // packet: takes the words apart into the draw state and the words of scan and interpolate
  wire [63:0] packet_word;
  wire [PLANE_WORDS-1:0] plane_words;
  wire        scan_shift, plane_shift, triangle_valid, triangle_take, packet_busy;
  wire        draw_bump, draw_textured, draw_shadow, draw_exponent_zero;
  wire [1:0]  draw_wrap_u, draw_wrap_v;
  wire [3:0]  draw_log2_width, draw_log2_height, draw_max_level, draw_squarings;
  wire [11:0] draw_texture;
  wire [COUNT*(COLOUR_BITS+1)-1:0] draw_ambient, draw_diffuse, draw_specular;
  wire [(CONSTANT != 0 ? CONSTANT : 1)-1:0] draw_l;
  wire [(CONSTANT != 0 && GLOSSY != 0 ? CONSTANT : 1)-1:0] draw_h;
  wire scan_busy, perspective_busy, texture_busy, perturb_busy, normalize_busy, light_busy, output_busy;
  wire fragments_busy = scan_busy | perspective_busy | texture_busy | perturb_busy | normalize_busy | light_busy |
                        output_busy;
  assign idle_o = ~(packet_busy | fragments_busy);

  wrinkle_packet #(
    .SCAN_WORDS(SCAN_WORDS), .PLANE_WORDS(PLANE_WORDS), .DRAW_WORDS(DRAW_WORDS), .BUFFERING(BUFFERING),
    .TEXTURED(TEXTURED), .GLOSSY(GLOSSY), .CONSTANT(CONSTANT), .COUNT(COUNT), .COLOUR_BITS(COLOUR_BITS)
  ) packet (
    .clk(clk), .rst(rst), .packet_valid_i(packet_valid_i), .packet_ready_o(packet_ready_o),
    .packet_word_i(packet_word_i), .busy_i(fragments_busy), .walking_i(scan_busy), .word_o(packet_word),
    .scan_shift_o(scan_shift), .plane_shift_o(plane_shift), .plane_words_o(plane_words),
    .triangle_valid_o(triangle_valid), .triangle_take_i(triangle_take),
    .draw_bump_o(draw_bump), .draw_textured_o(draw_textured), .draw_shadow_o(draw_shadow),
    .draw_exponent_zero_o(draw_exponent_zero), .draw_wrap_u_o(draw_wrap_u), .draw_wrap_v_o(draw_wrap_v),
    .draw_log2_width_o(draw_log2_width), .draw_log2_height_o(draw_log2_height), .draw_max_level_o(draw_max_level),
    .draw_texture_o(draw_texture), .draw_squarings_o(draw_squarings), .draw_ambient_o(draw_ambient),
    .draw_diffuse_o(draw_diffuse), .draw_specular_o(draw_specular), .draw_l_o(draw_l), .draw_h_o(draw_h),
    .busy_o(packet_busy));

  // scan: walks the triangle, leads interpolate by walk_*, and hands on the pixel on which it stands
  wire walk_step, walk_carry, walk_span, walk_first, walk_pixel;
  wire scan_valid, scan_ready, scan_last;
  wire [SCREEN_BITS-1:0] scan_x, scan_y;

  wrinkle_scan #(
    .SHARING(SHARING), .BUFFERING(BUFFERING), .SCREEN_BITS(SCREEN_BITS), .SUBPIXEL_BITS(SUBPIXEL_BITS),
    .WORDS(SCAN_WORDS)
  ) scan (
    .clk(clk), .rst(rst), .shift_i(scan_shift), .word_i(packet_word), .triangle_valid_i(triangle_valid),
    .load_o(triangle_take), .step_o(walk_step), .carry_o(walk_carry), .span_o(walk_span), .first_o(walk_first),
    .pixel_o(walk_pixel), .out_valid_o(scan_valid), .out_ready_i(scan_ready), .x_o(scan_x), .y_o(scan_y),
    .last_o(scan_last), .busy_o(scan_busy));

  // interpolate: every plane at that pixel; it moves in step with scan, and so shares its handshake
  wire                    interpolate_valid, interpolate_ready;
  wire [INTERPOLATED-1:0] interpolate_values;  // {q, v, u, lod, frame, h, l, z}
  wire [PERSPECTIVE_CARRY-1:0] interpolate_others;
  wire [(FRAME != 0 ? FRAME : 1)-1:0]       interpolate_frame;
  wire [(L_VECTOR != 0 ? L_VECTOR : 1)-1:0] interpolate_l;
  wire [(H_VECTOR != 0 ? H_VECTOR : 1)-1:0] interpolate_h;
  wire [(UV != 0 ? UV : 1)-1:0]             interpolate_u, interpolate_v;
  wire [(Q != 0 ? Q : 1)-1:0]               interpolate_q;
  wire [(LOD != 0 ? LOD : 1)-1:0]           interpolate_lod;
  wire [(Z != 0 ? Z : 1)-1:0]               interpolate_z;
  wire unused_interpolated = &{1'b0, interpolate_frame, interpolate_l, interpolate_h, interpolate_lod, interpolate_z};

  assign interpolate_valid  = scan_valid;
  assign scan_ready         = interpolate_ready;
  assign interpolate_others = {interpolate_values[INTERPOLATED-2*UV-Q-1:0], scan_last, scan_y, scan_x};

  wrinkle_interpolate #(
    .SHARING(SHARING), .BUFFERING(BUFFERING), .GUARD_BITS(GUARD_BITS), .FIELDS(FIELDS), .ELEMENTS(FIELD_ELEMENTS),
    .WIDTHS(FIELD_WIDTHS), .HELD(FIELD_HELD), .READERS(FIELD_READERS), .WORDS(PLANE_WORDS), .VALUES(INTERPOLATED)
  ) interpolate (
    .clk(clk), .shift_i(plane_shift), .words_i(plane_words), .word_i(packet_word), .load_i(triangle_take),
    .step_i(walk_step), .carry_i(walk_carry), .span_i(walk_span), .first_i(walk_first), .pixel_i(walk_pixel),
    .values_o(interpolate_values));

  wrinkle_field #(.BITS(INTERPOLATED), .AT(0), .WIDTH(Z)) field_z (
    .bus_i(interpolate_values), .field_o(interpolate_z));
  wrinkle_field #(.BITS(INTERPOLATED), .AT(Z), .WIDTH(L_VECTOR)) field_l (
    .bus_i(interpolate_values), .field_o(interpolate_l));
  wrinkle_field #(.BITS(INTERPOLATED), .AT(Z + L_VECTOR), .WIDTH(H_VECTOR)) field_h (
    .bus_i(interpolate_values), .field_o(interpolate_h));
  wrinkle_field #(.BITS(INTERPOLATED), .AT(Z + L_VECTOR + H_VECTOR), .WIDTH(FRAME)) field_frame (
    .bus_i(interpolate_values), .field_o(interpolate_frame));
  wrinkle_field #(.BITS(INTERPOLATED), .AT(INTERPOLATED - Q - 2*UV), .WIDTH(UV)) field_u (
    .bus_i(interpolate_values), .field_o(interpolate_u));
  wrinkle_field #(.BITS(INTERPOLATED), .AT(INTERPOLATED - Q - UV), .WIDTH(UV)) field_v (
    .bus_i(interpolate_values), .field_o(interpolate_v));
  wrinkle_field #(.BITS(INTERPOLATED), .AT(INTERPOLATED - Q), .WIDTH(Q)) field_q (
    .bus_i(interpolate_values), .field_o(interpolate_q));
  wrinkle_level #(.BITS(PERSPECTIVE_CARRY), .PLANE(LOD_PLANE), .HELD(LOD_HELD)) level (
    .bus_i(interpolate_others), .level_o(interpolate_lod));

  // perspective: u and v, divided by q
  wire perspective_valid, perspective_ready;
  wire [(UV != 0 ? UV : 1)-1:0]   perspective_u, perspective_v;
  wire [(LOD != 0 ? LOD : 1)-1:0] perspective_lod;
  wire [PERSPECTIVE_CARRY-1:0]    perspective_others;

  wrinkle_perspective #(.UV(UV), .Q(Q), .RECIPROCAL_BITS(RECIPROCAL_BITS), .CARRY(PERSPECTIVE_CARRY)) perspective (
    .clk(clk), .rst(rst), .in_valid_i(interpolate_valid), .in_ready_o(interpolate_ready), .u_i(interpolate_u),
    .v_i(interpolate_v), .q_i(interpolate_q), .carry_i(interpolate_others), .out_valid_o(perspective_valid),
    .out_ready_i(perspective_ready), .u_o(perspective_u), .v_o(perspective_v), .carry_o(perspective_others),
    .busy_o(perspective_busy));

  wrinkle_level #(.BITS(PERSPECTIVE_CARRY), .PLANE(LOD_PLANE), .HELD(LOD_HELD)) perspective_level (
    .bus_i(perspective_others), .level_o(perspective_lod));

  // texture: asks for texels, decodes and filters them into the bump map, the base colour and the gloss
  wire texture_valid, texture_ready;
  wire [(FRAME != 0 ? FRAME : 1)-1:0]   texture_frame;
  wire [(BUMP != 0 ? BUMP : 1)-1:0]     texture_bump;
  wire [(DECALS != 0 ? DECALS : 1)-1:0] texture_decal;
  wire [(GLOSS_BITS != 0 ? GLOSS_BITS : 1)-1:0] texture_gloss;
  wire [TEXTURE_CARRY-1:0]              texture_carried;
  wire [PERTURB_CARRY-1:0]              texture_others;

  wrinkle_texture #(
    .BUMP_COMPONENTS(BUMP_COMPONENTS), .BUMP_WIDTH(BUMP_WIDTH), .BUMP_FRACTION(BUMP_FRACTION),
    .BUMP_OFFSET(BUMP_OFFSET), .BUMP_SATURATES(BUMP_SATURATES), .COLOURS(COLOURS), .TEXELS(TEXELS),
    .FILTER(FILTER), .UV_INTEGER_BITS(UV_INTEGER_BITS), .UV_BITS(UV_BITS), .LOD_BITS(LOD_BITS),
    .WEIGHT_BITS(WEIGHT_BITS), .TEXEL_BITS(TEXEL_BITS), .TEXTURE_FIFO_BITS(TEXTURE_FIFO_BITS), .CARRY(TEXTURE_CARRY)
  ) texture (
    .clk(clk), .rst(rst), .draw_textured_i(draw_textured), .draw_wrap_u_i(draw_wrap_u), .draw_wrap_v_i(draw_wrap_v),
    .draw_log2_width_i(draw_log2_width), .draw_log2_height_i(draw_log2_height), .draw_max_level_i(draw_max_level),
    .draw_texture_i(draw_texture), .in_valid_i(perspective_valid), .in_ready_o(perspective_ready),
    .u_i(perspective_u), .v_i(perspective_v), .lod_i(perspective_lod),
    .carry_i(perspective_others[TEXTURE_CARRY-1:0]), .texel_request_valid_o(texel_request_valid_o),
    .texel_request_ready_i(texel_request_ready_i), .texel_request_a_o(texel_request_a_o),
    .texel_request_b_o(texel_request_b_o), .texel_response_valid_i(texel_response_valid_i),
    .texel_response_ready_o(texel_response_ready_o), .texel_a00_i(texel_a00_i), .texel_a10_i(texel_a10_i),
    .texel_a01_i(texel_a01_i), .texel_a11_i(texel_a11_i), .texel_b00_i(texel_b00_i), .texel_b10_i(texel_b10_i),
    .texel_b01_i(texel_b01_i), .texel_b11_i(texel_b11_i), .out_valid_o(texture_valid), .out_ready_i(texture_ready),
    .bump_o(texture_bump), .decal_o(texture_decal), .gloss_o(texture_gloss), .carry_o(texture_carried),
    .busy_o(texture_busy));

  wrinkle_field #(.BITS(TEXTURE_CARRY), .AT(TEXTURE_CARRY - FRAME), .WIDTH(FRAME)) field_texture_frame (
    .bus_i(texture_carried), .field_o(texture_frame));

  // What is carried on from here: {h, l, gloss, decal, z, last, y, x}.
  assign texture_others[TAG-1:0] = texture_carried[TAG-1:0];
  generate
    if (DECALS != 0) begin : carry_decal
      assign texture_others[TAG +: DECALS] = texture_decal;
    end else begin : carry_no_decal
      wire unused_decal = texture_decal;
    end
    if (GLOSS_BITS != 0) begin : carry_gloss
      assign texture_others[TAG + DECALS +: GLOSS_BITS] = texture_gloss;
    end else begin : carry_no_gloss
      wire unused_gloss = texture_gloss;
    end
    if (L_VECTOR != 0) begin : carry_light
      assign texture_others[NORMALIZE_CARRY +: L_VECTOR + H_VECTOR] = texture_carried[TAG +: L_VECTOR + H_VECTOR];
    end
  endgenerate

  // perturb: N' of the datapath, from its frame of vectors and the bump map
  wire perturb_valid, perturb_ready;
  wire [(NORMAL != 0 ? NORMAL : 1)-1:0]     perturb_n;
  wire [(L_VECTOR != 0 ? L_VECTOR : 1)-1:0] perturb_l;
  wire [(H_VECTOR != 0 ? H_VECTOR : 1)-1:0] perturb_h;
  wire [PERTURB_CARRY-1:0]                  perturb_others;

`define WRINKLE_SECTION_PERTURB
`include "wrinkle_config.vh"
`undef WRINKLE_SECTION_PERTURB

  wrinkle_field #(.BITS(PERTURB_CARRY), .AT(NORMALIZE_CARRY), .WIDTH(L_VECTOR)) field_perturb_l (
    .bus_i(perturb_others), .field_o(perturb_l));
  wrinkle_field #(.BITS(PERTURB_CARRY), .AT(NORMALIZE_CARRY + L_VECTOR), .WIDTH(H_VECTOR)) field_perturb_h (
    .bus_i(perturb_others), .field_o(perturb_h));

  // normalize: N, L and H of unit length, or mantissas with their scales
  wire normalize_valid, normalize_ready, normalize_zero, normalize_ahead;
  wire [UNIT-1:0]                         normalize_n, normalize_l;
  wire [(GLOSSY != 0 ? UNIT : 1)-1:0]     normalize_h;
  wire [(SCALES != 0 ? SCALES : 1)-1:0]   normalize_scale;
  wire [NORMALIZE_CARRY-1:0]              normalize_others;

  wrinkle_normalize #(
    .LIGHTING(LIGHTING), .NORMALIZER_N(NORMALIZER_N), .NORMALIZER_L(NORMALIZER_L), .NORMALIZER_H(NORMALIZER_H),
    .NORMALIZE_ORDER(NORMALIZE_ORDER), .SHARING(SHARING), .NORMAL(NORMAL), .NORMAL_INPUT_BITS(NORMAL_INPUT_BITS),
    .L_VECTOR(L_VECTOR), .VECTOR_BITS(VECTOR_BITS), .UNIT_BITS(UNIT_BITS), .UNIT(UNIT), .SCALE(SCALE),
    .SCALES(SCALES), .CARRY(NORMALIZE_CARRY)
  ) normalize (
    .clk(clk), .rst(rst), .draw_l_i(draw_l), .draw_h_i(draw_h), .in_valid_i(perturb_valid), .in_ready_o(perturb_ready),
    .n_i(perturb_n), .l_i(perturb_l), .h_i(perturb_h), .carry_i(perturb_others[NORMALIZE_CARRY-1:0]),
    .out_valid_o(normalize_valid), .out_ready_i(normalize_ready), .n_o(normalize_n), .l_o(normalize_l),
    .h_o(normalize_h), .scale_o(normalize_scale), .zero_o(normalize_zero), .ahead_o(normalize_ahead),
    .carry_o(normalize_others), .busy_o(normalize_busy));

  // light: N.L and N.H, the power, self-shadow
  wire light_valid, light_ready;
  wire [DOT_BITS:0] light_nl, light_diffuse;
  wire [(GLOSSY != 0 ? DOT_BITS : 0):0]   light_nh;
  wire [(GLOSSY != 0 ? POWER_BITS : 0):0] light_specular;
  wire [LIGHT_CARRY-1:0]                  light_others;  // {zero, gloss, decal, z, last, y, x}
  wire [(DECALS != 0 ? DECALS : 1)-1:0]   light_decal;
  wire [(GLOSS_BITS != 0 ? GLOSS_BITS : 1)-1:0] light_gloss;
  wire unused_but_observed = &{1'b0, light_nl, light_nh};

  wrinkle_light #(
    .LIGHTING(LIGHTING), .NORMALIZE_ORDER(NORMALIZE_ORDER), .SHARING(SHARING), .SELF_SHADOW(SELF_SHADOW),
    .NORMAL_IS_Z(NORMAL == 0 ? 1 : 0), .SURFACE_IS_Z(SURFACE_IS_Z), .UNIT_BITS(UNIT_BITS), .DOT_BITS(DOT_BITS),
    .POWER_BITS(POWER_BITS), .SPECULAR_SQUARINGS(SPECULAR_SQUARINGS), .UNIT(UNIT), .SCALE(SCALE), .SCALES(SCALES),
    .CARRY(LIGHT_CARRY)
  ) light (
    .clk(clk), .rst(rst), .draw_bump_i(draw_bump), .draw_shadow_i(draw_shadow),
    .draw_exponent_zero_i(draw_exponent_zero), .draw_squarings_i(draw_squarings), .in_valid_i(normalize_valid),
    .in_ready_o(normalize_ready), .ahead_i(normalize_ahead), .n_i(normalize_n), .l_i(normalize_l), .h_i(normalize_h),
    .scale_i(normalize_scale), .carry_i({normalize_zero, normalize_others}), .out_valid_o(light_valid),
    .out_ready_i(light_ready), .nl_o(light_nl), .nh_o(light_nh), .diffuse_o(light_diffuse),
    .specular_o(light_specular), .carry_o(light_others), .busy_o(light_busy));

  wrinkle_field #(.BITS(LIGHT_CARRY), .AT(TAG), .WIDTH(DECALS)) field_light_decal (
    .bus_i(light_others), .field_o(light_decal));
  wrinkle_field #(.BITS(LIGHT_CARRY), .AT(TAG + DECALS), .WIDTH(GLOSS_BITS)) field_light_gloss (
    .bus_i(light_others), .field_o(light_gloss));

  // output: the colour, and with it all that was carried along
  wire output_valid, output_ready;
  wire [COUNT*COLOUR_BITS-1:0] output_colour;
  wire [TAG:0]                 output_others;  // {zero, z, last, y, x}
  assign output_ready      = fragment_ready_i;
  assign fragment_valid_o  = output_valid;
  assign fragment_colour_o = output_colour;
  assign {fragment_zero_o, fragment_last_o} = {output_others[TAG], output_others[2*SCREEN_BITS]};
  assign {fragment_y_o, fragment_x_o} = output_others[2*SCREEN_BITS-1:0];

  wrinkle_output #(
    .GLOSSY(GLOSSY), .COLOURS(COLOURS), .GLOSS_MAP(GLOSS_MAP), .COUNT(COUNT), .TEXEL_BITS(TEXEL_BITS),
    .DOT_BITS(DOT_BITS), .POWER_BITS(POWER_BITS), .COLOUR_BITS(COLOUR_BITS), .CARRY(TAG + 1)
  ) outputs (
    .clk(clk), .rst(rst), .draw_ambient_i(draw_ambient), .draw_diffuse_i(draw_diffuse),
    .draw_specular_i(draw_specular), .in_valid_i(light_valid), .in_ready_o(light_ready), .diffuse_i(light_diffuse),
    .specular_i(light_specular), .decal_i(light_decal), .gloss_i(light_gloss),
    .carry_i({light_others[LIGHT_CARRY-1], light_others[TAG-1:0]}),
    .out_valid_o(output_valid), .out_ready_i(output_ready), .colour_o(output_colour), .carry_o(output_others),
    .busy_o(output_busy));

  wrinkle_field #(.BITS(TAG + 1), .AT(2*SCREEN_BITS + 1), .WIDTH(Z)) field_fragment_z (
    .bus_i(output_others), .field_o(fragment_z_o));
endmodule
`default_nettype wire
