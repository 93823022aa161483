`default_nettype none
// Filters every component of the texels, then rounds: normals to s1.V, gradients fu, fv to s0.GB, decal to u0.T.
//   normal = round_half_up(2f - (2^T - d) 2^D, D + T - V), d = 1 range, 0 offset;  decal = round_half_up(f, D)
//   gradient = saturate(round_half_up(f - 2^(T-1+D), D + T - 1 - GB))
// |normal| is at most 2^V and decal at most 2^T - 1, so neither can leave its format and only the gradient saturates.
// Latency FILTER + 2. Without texels (`textured_i` off) the normal or gradient is 0 and the decal white.
module wrinkle_texture_filter #(
  parameter DATAPATH    = 1,
  parameter FILTER      = 2,
  parameter DECODE      = 0,
  parameter DECAL       = 0,
  parameter VECTOR_BITS = 9,
  parameter GRADIENT_BITS = 9,
  parameter LOD_BITS    = 5,  // LB, 0 unless trilinear
  parameter WEIGHT_BITS = 8,  // B, 0 with nearest
  parameter TEXEL_BITS  = 8,
  parameter TEXELS = (DATAPATH == 1 ? 3 : DATAPATH == 2 ? 2 : 0) + 3*DECAL  // of the above: components of a texel
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
  output wire [(DATAPATH == 1 ? 3*(VECTOR_BITS+2) : 1)-1:0]               n_o,
  output wire [(DATAPATH == 2 ? 2*(GRADIENT_BITS+1) : 1)-1:0]             gradient_o,
  output wire [(DECAL != 0 ? 3*TEXEL_BITS : 1)-1:0]                       decal_o
);
  localparam T  = TEXEL_BITS;
  localparam W  = VECTOR_BITS + 2;
  localparam BW = WEIGHT_BITS > 0 ? WEIGHT_BITS : 1;
  localparam LW = LOD_BITS > 0 ? LOD_BITS : 1;
  localparam LEVELS = FILTER == 2 ? 2 : 1;
  localparam D = 2 * WEIGHT_BITS + LOD_BITS;
  localparam DECAL_AT = TEXELS - 3 * DECAL;  // first component of the decal

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

      if (k < DECAL_AT && DATAPATH == 1) begin : normal
        localparam [T+D+1:0] OFFSET = (({{(T + D + 1){1'b0}}, 1'b1} << T) - (DECODE != 0 ? 0 : 1)) << D;
        wire signed [T+D+1:0] decoded = {1'b0, f, 1'b0} - OFFSET;
        wire signed [W-1:0]   rounded;
        reg [W-1:0]           n_q;
        wrinkle_round_half_up #(.VALUE_BITS(T + D + 2), .SHIFT(D + T - VECTOR_BITS), .RESULT_BITS(W)) round (
          .value_i(decoded), .result_o(rounded));
        assign n_o[k*W +: W] = n_q;
        always @(posedge clk) if (advance_i) n_q <= textured_i ? rounded : {W{1'b0}};
      end else if (k < DECAL_AT) begin : gradient
        localparam GB = GRADIENT_BITS;
        localparam ROUNDED = (T + D > GB ? T + D : GB) + 3;
        wire signed [T+D:0]       centred = {1'b0, f} - ({{(T + D){1'b0}}, 1'b1} << (T + D - 1));
        wire signed [ROUNDED-1:0] rounded;
        wire [GB:0]               saturated;
        reg [GB:0]                gradient_q;
        wrinkle_round_half_up #(.VALUE_BITS(T + D + 1), .SHIFT(D + T - 1 - GB), .RESULT_BITS(ROUNDED)) round (
          .value_i(centred), .result_o(rounded));
        wrinkle_saturate #(
          .VALUE_BITS(ROUNDED), .RESULT_BITS(GB + 1), .MINIMUM(-(1 << GB)), .MAXIMUM((1 << GB) - 1)
        ) saturate (.value_i(rounded), .result_o(saturated));
        assign gradient_o[k*(GB+1) +: GB+1] = gradient_q;
        always @(posedge clk) if (advance_i) gradient_q <= textured_i ? saturated : {(GB + 1){1'b0}};
      end else begin : colour
        wire signed [T:0] rounded;
        reg [T-1:0]       decal_q;
        wire unused_sign = rounded[T];
        wrinkle_round_half_up #(.VALUE_BITS(T + D + 1), .SHIFT(D), .RESULT_BITS(T + 1)) round (
          .value_i({1'b0, f}), .result_o(rounded));
        assign decal_o[(k-DECAL_AT)*T +: T] = decal_q;
        always @(posedge clk) if (advance_i) decal_q <= textured_i ? rounded[T-1:0] : {T{1'b1}};
      end
    end
    if (DATAPATH != 1) begin : no_normal
      assign n_o = 1'b0;
    end
    if (DATAPATH != 2) begin : no_gradient
      assign gradient_o = 1'b0;
    end
    if (DECAL == 0) begin : no_decal
      assign decal_o = 1'b0;
    end
  endgenerate
endmodule
`default_nettype wire
