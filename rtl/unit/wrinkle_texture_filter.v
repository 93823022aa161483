`default_nettype none
// Filters every component of the texels to f in uT.D, then decodes: the components of the bump map, the first ones, to
// BUMP_FRACTION bits, those of the decal and the gloss behind them to u0.T.
//   bump = round_half_up(2f - BUMP_OFFSET 2^D, D + T - BUMP_FRACTION), with BUMP_SATURATES to BUMP_WIDTH bits
//   decal, gloss = round_half_up(f, D)
// A bump is at most 1, a decal or gloss at most 2^T - 1, so that only a bump without an integer bit can leave its format.
// Latency FILTER + 2. Without texels (`textured_i` off) the bump is 0, the decal white, the gloss full.
module wrinkle_texture_filter #(
  parameter BUMP_COMPONENTS = 3,
  parameter BUMP_WIDTH      = 11,
  parameter BUMP_FRACTION   = 9,
  parameter BUMP_OFFSET     = 255,
  parameter BUMP_SATURATES  = 0,
  parameter COLOURS         = 0,
  parameter TEXELS          = 3,
  parameter FILTER          = 2,
  parameter LOD_BITS        = 5,  // LB, 0 unless trilinear
  parameter WEIGHT_BITS     = 8,  // B, 0 with nearest
  parameter TEXEL_BITS      = 8   // T
) (
  input  wire clk,
  input  wire advance_i,
  input  wire textured_i,
  input  wire [(FILTER == 2 ? 4 : 2)*(WEIGHT_BITS > 0 ? WEIGHT_BITS : 1)+(LOD_BITS > 0 ? LOD_BITS : 1)-1:0] weights_i,
  input  wire [TEXELS*TEXEL_BITS-1:0]                    a00_i,
  input  wire [(FILTER > 0 ? TEXELS*TEXEL_BITS : 1)-1:0] a10_i,
  input  wire [(FILTER > 0 ? TEXELS*TEXEL_BITS : 1)-1:0] a01_i,
  input  wire [(FILTER > 0 ? TEXELS*TEXEL_BITS : 1)-1:0] a11_i,
  input  wire [(FILTER > 1 ? TEXELS*TEXEL_BITS : 1)-1:0] b00_i,
  input  wire [(FILTER > 1 ? TEXELS*TEXEL_BITS : 1)-1:0] b10_i,
  input  wire [(FILTER > 1 ? TEXELS*TEXEL_BITS : 1)-1:0] b01_i,
  input  wire [(FILTER > 1 ? TEXELS*TEXEL_BITS : 1)-1:0] b11_i,
  output wire [(BUMP_COMPONENTS != 0 ? BUMP_COMPONENTS*BUMP_WIDTH : 1)-1:0] bump_o,
  output wire [(COLOURS != 0 ? COLOURS*TEXEL_BITS : 1)-1:0]                decal_o,
  output wire [(TEXELS != BUMP_COMPONENTS + COLOURS ? TEXEL_BITS : 1)-1:0]  gloss_o
);
  localparam T  = TEXEL_BITS;
  localparam W  = BUMP_WIDTH;
  localparam BW = WEIGHT_BITS > 0 ? WEIGHT_BITS : 1;
  localparam LW = LOD_BITS > 0 ? LOD_BITS : 1;
  localparam LEVELS = FILTER == 2 ? 2 : 1;
  localparam D = 2 * WEIGHT_BITS + LOD_BITS;
  localparam [31:0] OFFSET = BUMP_OFFSET;

  // Weights by rank: x at once, y one rank later, level two ranks later.
  wire [2*BW-1:0] weights_x, weights_y_early, weights_y;
  wire [LW-1:0]   weight_level;
  assign weights_x[0 +: BW]       = weights_i[0 +: BW];
  assign weights_y_early[0 +: BW] = weights_i[BW +: BW];
  wrinkle_delay #(.WIDTH(2*BW), .RANKS(FILTER > 0 ? 1 : 0)) delay_y (
    .clk(clk), .advance_i(advance_i), .data_i(weights_y_early), .data_o(weights_y));
  wrinkle_delay #(.WIDTH(LW), .RANKS(LOD_BITS > 0 ? 2 : 0)) delay_level (
    .clk(clk), .advance_i(advance_i), .data_i(weights_i[2*BW*LEVELS +: LW]), .data_o(weight_level));

  genvar k;
  generate
    if (LEVELS == 2) begin : two
      assign weights_x[BW +: BW]       = weights_i[2*BW +: BW];
      assign weights_y_early[BW +: BW] = weights_i[3*BW +: BW];
    end else begin : one
      assign weights_x[BW +: BW]       = {BW{1'b0}};
      assign weights_y_early[BW +: BW] = {BW{1'b0}};
    end
    if (FILTER == 0) begin : no_neighbours
      wire unused_texels = &{1'b0, a10_i, a01_i, a11_i};
    end
    if (FILTER < 2) begin : no_second_level
      wire unused_texels = &{1'b0, b00_i, b10_i, b01_i, b11_i};
    end

    for (k = 0; k < TEXELS; k = k + 1) begin : component
      wire [4*T-1:0] quad_a, quad_b;
      wire [T+D-1:0] f;
      assign quad_a[0 +: T] = a00_i[k*T +: T];
      if (FILTER > 0) begin : quad
        assign quad_a[T +: 3*T] = {a11_i[k*T +: T], a01_i[k*T +: T], a10_i[k*T +: T]};
      end else begin : single
        assign quad_a[T +: 3*T] = {3*T{1'b0}};
      end
      if (FILTER > 1) begin : second
        assign quad_b = {b11_i[k*T +: T], b01_i[k*T +: T], b10_i[k*T +: T], b00_i[k*T +: T]};
      end else begin : unread
        assign quad_b = {4*T{1'b0}};
      end
      wrinkle_texel_filter #(
        .TEXEL_BITS(T), .WEIGHT_BITS(WEIGHT_BITS), .LOD_BITS(LOD_BITS), .LEVELS(LEVELS)
      ) filter (
        .clk(clk), .advance_i(advance_i), .a_i(quad_a), .b_i(quad_b), .weights_x_i(weights_x),
        .weights_y_i(weights_y), .weight_level_i(weight_level), .value_o(f));

      if (k < BUMP_COMPONENTS) begin : bump
        localparam [T+D+1:0] CODE_OFFSET = {{(D + 1){1'b0}}, OFFSET[T:0]} << D;
        localparam EXACT   = T + D > BUMP_FRACTION ? T + D : BUMP_FRACTION;
        localparam ROUNDED = BUMP_SATURATES != 0 ? EXACT + 3 : W;
        wire signed [T+D+1:0]     decoded = {1'b0, f, 1'b0} - CODE_OFFSET;
        wire signed [ROUNDED-1:0] rounded;
        wire [W-1:0]              value;
        reg [W-1:0]               bump_q;
        wrinkle_round_half_up #(
          .VALUE_BITS(T + D + 2), .SHIFT(D + T - BUMP_FRACTION), .RESULT_BITS(ROUNDED)
        ) round (.value_i(decoded), .result_o(rounded));
        if (BUMP_SATURATES != 0) begin : saturated
          wrinkle_saturate #(
            .VALUE_BITS(ROUNDED), .RESULT_BITS(W), .MINIMUM(-(1 << (W - 1))), .MAXIMUM((1 << (W - 1)) - 1)
          ) saturate (.value_i(rounded), .result_o(value));
        end else begin : as_rounded
          assign value = rounded;
        end
        assign bump_o[k*W +: W] = bump_q;
        always @(posedge clk) if (advance_i) bump_q <= textured_i ? value : {W{1'b0}};
      end else begin : colour
        wire signed [T:0] rounded;
        reg [T-1:0]       tint_q;
        wire unused_sign = rounded[T];
        wrinkle_round_half_up #(.VALUE_BITS(T + D + 1), .SHIFT(D), .RESULT_BITS(T + 1)) round (
          .value_i({1'b0, f}), .result_o(rounded));
        always @(posedge clk) if (advance_i) tint_q <= textured_i ? rounded[T-1:0] : {T{1'b1}};
        if (k < BUMP_COMPONENTS + COLOURS) begin : decal
          assign decal_o[(k-BUMP_COMPONENTS)*T +: T] = tint_q;
        end else begin : gloss
          assign gloss_o = tint_q;
        end
      end
    end
    if (BUMP_COMPONENTS == 0) begin : no_bump
      assign bump_o = 1'b0;
    end
    if (COLOURS == 0) begin : no_decal
      assign decal_o = 1'b0;
    end
    if (TEXELS == BUMP_COMPONENTS + COLOURS) begin : no_gloss
      assign gloss_o = 1'b0;
    end
  endgenerate
endmodule
`default_nettype wire
