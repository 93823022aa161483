`default_nettype none
// Level of detail to levels a and b, then a request for each level the filter reads. Latency 2.
//   a = floor(lod), b = a + 1, both clamped to [0, max_level]; weight of b: the fraction, 0 where lod is out of range
module wrinkle_texture_address #(
  parameter FILTER          = 2,
  parameter UV_INTEGER_BITS = 4,
  parameter UV_BITS         = 18,
  parameter LOD_BITS        = 5,  // LB, 0 unless trilinear
  parameter WEIGHT_BITS     = 8   // B, 0 with nearest
) (
  input  wire        clk,
  input  wire        advance_i,
  input  wire signed [UV_INTEGER_BITS+UV_BITS-1:0] u_i,
  input  wire signed [UV_INTEGER_BITS+UV_BITS-1:0] v_i,
  input  wire [5+LOD_BITS:0] lod_i,                      // s5.LB
  input  wire [1:0]  wrap_u_i,                           // draw state
  input  wire [1:0]  wrap_v_i,
  input  wire [3:0]  log2_width_i,
  input  wire [3:0]  log2_height_i,
  input  wire [3:0]  max_level_i,
  input  wire [11:0] texture_i,
  output wire [63:0] request_a_o,
  output wire [(FILTER == 2 ? 64 : 1)-1:0] request_b_o,
  output wire [(FILTER == 2 ? 4 : 2)*(WEIGHT_BITS > 0 ? WEIGHT_BITS : 1)+(LOD_BITS > 0 ? LOD_BITS : 1)-1:0]
    weights_o                                            // {level, v of b, u of b, v of a, u of a}
);
  localparam PAIR = 2 * (WEIGHT_BITS > 0 ? WEIGHT_BITS : 1);
  localparam AT   = (FILTER == 2 ? 2 : 1) * PAIR;

  wire signed [5:0] floor  = lod_i[LOD_BITS +: 6];
  wire              below  = floor[5];
  wire              beyond = ~below & floor[4:0] >= {1'b0, max_level_i};
  wire [3:0]        a      = below ? 4'd0 : beyond ? max_level_i : floor[3:0];

  wrinkle_texel_address #(
    .UV_INTEGER_BITS(UV_INTEGER_BITS), .UV_BITS(UV_BITS), .WEIGHT_BITS(WEIGHT_BITS)
  ) level_a (
    .clk(clk), .advance_i(advance_i), .u_i(u_i), .v_i(v_i), .level_i(a), .wrap_u_i(wrap_u_i), .wrap_v_i(wrap_v_i),
    .log2_width_i(log2_width_i), .log2_height_i(log2_height_i), .texture_i(texture_i),
    .request_o(request_a_o), .weights_o(weights_o[0 +: PAIR]));

  generate
    if (FILTER == 2) begin : two
      wire [3:0] b = below ? 4'd0 : beyond ? max_level_i : floor[3:0] + 4'd1;
      wrinkle_texel_address #(
        .UV_INTEGER_BITS(UV_INTEGER_BITS), .UV_BITS(UV_BITS), .WEIGHT_BITS(WEIGHT_BITS)
      ) level_b (
        .clk(clk), .advance_i(advance_i), .u_i(u_i), .v_i(v_i), .level_i(b), .wrap_u_i(wrap_u_i), .wrap_v_i(wrap_v_i),
        .log2_width_i(log2_width_i), .log2_height_i(log2_height_i), .texture_i(texture_i),
        .request_o(request_b_o), .weights_o(weights_o[PAIR +: PAIR]));
    end else begin : one
      assign request_b_o = 1'b0;
    end
    if (LOD_BITS > 0) begin : fraction
      wrinkle_delay #(.WIDTH(LOD_BITS), .RANKS(2)) delay (
        .clk(clk), .advance_i(advance_i), .data_i(below | beyond ? {LOD_BITS{1'b0}} : lod_i[LOD_BITS-1:0]),
        .data_o(weights_o[AT +: LOD_BITS]));
    end else begin : whole
      assign weights_o[AT] = 1'b0;
    end
  endgenerate
endmodule
`default_nettype wire
