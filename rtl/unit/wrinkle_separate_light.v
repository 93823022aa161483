`default_nettype none
// The light stage with a dot product for N.L, another for N.H (or R.E, by wrinkle_reflection) and a squarer for each
// squaring. With NORMAL_IS_Z N is (0, 0, 1): its dot products are components of L and H. With NORMALIZE_ORDER after they
// are of mantissas, and wrinkle_scaled_dot scales them.
// Latency 2, with NORMAL_IS_Z 1, with LIGHTING reflection 4, with NORMALIZE_ORDER after 3; SPECULAR_SQUARINGS more
// where there is a highlight, with SELF_SHADOW 1 more.
module wrinkle_separate_light #(
  parameter LIGHTING           = 1,
  parameter NORMALIZE_ORDER    = 0,
  parameter SELF_SHADOW        = 1,
  parameter NORMAL_IS_Z        = 0,
  parameter SURFACE_IS_Z       = 1,
  parameter UNIT_BITS          = 9,   // F
  parameter DOT_BITS           = 10,  // DF
  parameter POWER_BITS         = 12,  // PF
  parameter SPECULAR_SQUARINGS = 5,   // K
  parameter UNIT               = 33,
  parameter SCALE              = 11,  // bits of a scale
  parameter SCALES             = 0,   // ... of all of them; 0: none
  parameter CARRY              = 37
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
  input  wire [(SCALES != 0 ? SCALES : 1)-1:0]                scale_i,     // u1.RB each, of N in the low bits
  input  wire [CARRY-1:0]                                  carry_i,
  output wire       out_valid_o,
  input  wire       out_ready_i,
  output wire [DOT_BITS:0]                                    nl_o,        // u1.DF
  output wire [(LIGHTING != 0 ? DOT_BITS : 0):0]              nh_o,        // u1.DF
  output wire [DOT_BITS:0]                                    diffuse_o,   // u1.DF
  output wire [(LIGHTING != 0 ? POWER_BITS : 0):0]            specular_o,  // u1.PF
  output wire [CARRY-1:0]                                  carry_o,
  output wire       busy_o
);
  localparam N       = UNIT_BITS + 2;
  localparam K       = LIGHTING != 0 ? SPECULAR_SQUARINGS : 0;
  localparam SHADOW  = SELF_SHADOW != 0 ? 1 : 0;
  localparam AFTER   = NORMALIZE_ORDER != 0 ? 1 : 0;
  localparam DOT     = NORMAL_IS_Z != 0 ? 1 : AFTER != 0 ? 3 : 2;  // latency of a dot product
  localparam DOTS    = LIGHTING == 2 ? 4 : DOT;       // ... of what goes to the power
  localparam RANKS   = DOTS + K + SHADOW;

  wire              advance;
  wire [DOT_BITS:0] nl_early, nl;  // after the dot product and after the power

  wrinkle_pipe #(.RANKS(RANKS)) pipe (
    .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .advance_o(advance), .out_valid_o(out_valid_o),
    .out_ready_i(out_ready_i), .busy_o(busy_o));
  assign in_ready_o = advance;

  generate
    if (NORMAL_IS_Z != 0) begin : z_of_l
      wire [DOT_BITS:0] lz;
      wire unused_pins = &{1'b0, n_i, l_i[2*N-1:0]};
      wrinkle_clamped #(.UNIT_BITS(UNIT_BITS), .DOT_BITS(DOT_BITS)) clamp (
        .value_i(l_i[2*N +: N]), .clamped_o(lz));
      wrinkle_delay #(.WIDTH(DOT_BITS + 1), .RANKS(DOT)) dot_nl (
        .clk(clk), .advance_i(advance), .data_i(lz), .data_o(nl_early));
    end else if (AFTER != 0) begin : deferred
      wrinkle_scaled_dot #(.UNIT_BITS(UNIT_BITS), .DOT_BITS(DOT_BITS), .SCALE_BITS(SCALE - 1)) dot_nl (
        .clk(clk), .advance_i(advance), .a_i(n_i), .b_i(l_i), .scale_a_i(scale_i[0 +: SCALE]),
        .scale_b_i(scale_i[SCALE +: SCALE]), .dot_o(nl_early));
    end else begin : general
      wrinkle_clamped_dot #(.UNIT_BITS(UNIT_BITS), .DOT_BITS(DOT_BITS)) dot_nl (
        .clk(clk), .advance_i(advance), .a_i(n_i), .b_i(l_i), .dot_o(nl_early));
    end
  endgenerate
  generate
    if (AFTER == 0) begin : before
      wire unused_scale = scale_i;
    end
  endgenerate
  wrinkle_delay #(.WIDTH(DOT_BITS + 1), .RANKS(DOTS - DOT + K)) delay_nl (
    .clk(clk), .advance_i(advance), .data_i(nl_early), .data_o(nl));

  // The shadow factor, for the last rank.
  wire [DOT_BITS:0] factor;
  generate
    if (SHADOW != 0) begin : shadowed
      wire [DOT_BITS:0] source;
      if (SURFACE_IS_Z != 0) begin : from_l
        wire [DOT_BITS:0] lz, lz_late;
        wrinkle_clamped #(.UNIT_BITS(UNIT_BITS), .DOT_BITS(DOT_BITS)) clamp (
          .value_i(l_i[2*N +: N]), .clamped_o(lz));
        wrinkle_delay #(.WIDTH(DOT_BITS + 1), .RANKS(DOTS + K)) delay_lz (
          .clk(clk), .advance_i(advance), .data_i(lz), .data_o(lz_late));
        assign source = draw_bump_i ? lz_late : nl;
      end else begin : from_nl
        wire unused_bump = draw_bump_i;
        assign source = nl;
      end
      wrinkle_shadow_factor #(.SELF_SHADOW(SELF_SHADOW), .DOT_BITS(DOT_BITS)) shadow (
        .source_i(source), .off_i(~draw_shadow_i), .factor_o(factor));

      wire [DOT_BITS:0] diffuse;
      reg [DOT_BITS:0]  diffuse_q;
      wrinkle_scale #(.BITS(DOT_BITS + 1), .FRACTION_BITS(DOT_BITS)) scale (
        .a_i(nl), .b_i(factor), .result_o(diffuse));
      assign diffuse_o = diffuse_q;
      always @(posedge clk) if (advance) diffuse_q <= diffuse;
    end else begin : unshadowed
      wire unused_pins = &{1'b0, draw_bump_i, draw_shadow_i};
      assign factor    = {1'b1, {DOT_BITS{1'b0}}};
      assign diffuse_o = nl;
    end

    if (LIGHTING != 0) begin : glossy
      wire [DOT_BITS:0]   nh;
      wire [POWER_BITS:0] power;
      if (LIGHTING == 2) begin : reflected
        wrinkle_reflection #(.NORMAL_IS_Z(NORMAL_IS_Z), .UNIT_BITS(UNIT_BITS), .DOT_BITS(DOT_BITS)) reflection (
          .clk(clk), .advance_i(advance), .n_i(n_i), .l_i(l_i), .e_i(h_i), .re_o(nh));
      end else if (NORMAL_IS_Z != 0) begin : z_of_h
        wire [DOT_BITS:0] hz;
        wire unused_h = &{1'b0, h_i[2*N-1:0]};
        wrinkle_clamped #(.UNIT_BITS(UNIT_BITS), .DOT_BITS(DOT_BITS)) clamp (
          .value_i(h_i[2*N +: N]), .clamped_o(hz));
        wrinkle_delay #(.WIDTH(DOT_BITS + 1), .RANKS(DOT)) dot_nh (
          .clk(clk), .advance_i(advance), .data_i(hz), .data_o(nh));
      end else if (AFTER != 0) begin : deferred_h
        wrinkle_scaled_dot #(.UNIT_BITS(UNIT_BITS), .DOT_BITS(DOT_BITS), .SCALE_BITS(SCALE - 1)) dot_nh (
          .clk(clk), .advance_i(advance), .a_i(n_i), .b_i(h_i), .scale_a_i(scale_i[0 +: SCALE]),
          .scale_b_i(scale_i[2*SCALE +: SCALE]), .dot_o(nh));
      end else begin : general_h
        wrinkle_clamped_dot #(.UNIT_BITS(UNIT_BITS), .DOT_BITS(DOT_BITS)) dot_nh (
          .clk(clk), .advance_i(advance), .a_i(n_i), .b_i(h_i), .dot_o(nh));
      end
      wrinkle_power #(.POWER_BITS(POWER_BITS), .SQUARINGS(K)) powers (
        .clk(clk), .advance_i(advance), .squarings_i(draw_squarings_i), .exponent_zero_i(draw_exponent_zero_i),
        .x_i({nh, {(POWER_BITS - DOT_BITS){1'b0}}}), .power_o(power));
      wrinkle_delay #(.WIDTH(DOT_BITS + 1), .RANKS(K + SHADOW)) delay_nh (
        .clk(clk), .advance_i(advance), .data_i(nh), .data_o(nh_o));
      if (SHADOW != 0) begin : shadowed_specular
        wire [POWER_BITS:0] scaled;
        reg [POWER_BITS:0]  specular_q;
        wrinkle_scale #(.BITS(POWER_BITS + 1), .FRACTION_BITS(DOT_BITS)) scale (
          .a_i(power), .b_i(factor), .result_o(scaled));
        assign specular_o = specular_q;
        always @(posedge clk)
          if (advance) specular_q <= ~draw_shadow_i ? power : |nl ? scaled : {(POWER_BITS + 1){1'b0}};
      end else begin : plain_specular
        wire unused_factor = &{1'b0, factor};
        assign specular_o = power;
      end
    end else begin : diffuse_only
      wire unused_pins = &{1'b0, h_i, draw_exponent_zero_i, draw_squarings_i, factor};
      assign nh_o       = 1'b0;
      assign specular_o = 1'b0;
    end
  endgenerate

  wrinkle_delay #(.WIDTH(DOT_BITS + 1), .RANKS(SHADOW)) delay_nl_out (
    .clk(clk), .advance_i(advance), .data_i(nl), .data_o(nl_o));
  wrinkle_carry #(.BITS(CARRY), .RANKS(RANKS)) carry (
    .clk(clk), .advance_i(advance), .push_i(1'b0), .write_i(1'b0), .read_i(1'b0), .late_advance_i(1'b0),
    .data_i(carry_i), .data_o(carry_o));
endmodule
`default_nettype wire
