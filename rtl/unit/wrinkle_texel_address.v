`default_nettype none
// The texel request of one level, and its two weights. Latency 2.
module wrinkle_texel_address #(
  parameter UV_INTEGER_BITS = 4,
  parameter UV_BITS         = 18,
  parameter WEIGHT_BITS     = 8
) (
  input  wire        clk,
  input  wire        advance_i,
  input  wire signed [UV_INTEGER_BITS+UV_BITS-1:0] u_i,
  input  wire signed [UV_INTEGER_BITS+UV_BITS-1:0] v_i,
  input  wire [3:0]  level_i,
  input  wire [1:0]  wrap_u_i,        // draw state
  input  wire [1:0]  wrap_v_i,
  input  wire [3:0]  log2_width_i,
  input  wire [3:0]  log2_height_i,
  input  wire [11:0] texture_i,
  output wire [63:0] request_o,       // [docs/formats.md, texel request]
  output wire [2*(WEIGHT_BITS > 0 ? WEIGHT_BITS : 1)-1:0] weights_o  // {v, u}
);
  localparam B = WEIGHT_BITS > 0 ? WEIGHT_BITS : 1;

  wire [3:0]  level2;
  wire [11:0] x0, x1, y0, y1;

  wrinkle_texel_coordinate #(
    .UV_INTEGER_BITS(UV_INTEGER_BITS), .UV_BITS(UV_BITS), .WEIGHT_BITS(WEIGHT_BITS)
  ) along_u (
    .clk(clk), .advance_i(advance_i), .u_i(u_i),
    .size_log2_i(log2_width_i > level_i ? log2_width_i - level_i : 4'd0), .mode_i(wrap_u_i),
    .texel0_o(x0), .texel1_o(x1), .weight_o(weights_o[0 +: B]));

  wrinkle_texel_coordinate #(
    .UV_INTEGER_BITS(UV_INTEGER_BITS), .UV_BITS(UV_BITS), .WEIGHT_BITS(WEIGHT_BITS)
  ) along_v (
    .clk(clk), .advance_i(advance_i), .u_i(v_i),
    .size_log2_i(log2_height_i > level_i ? log2_height_i - level_i : 4'd0), .mode_i(wrap_v_i),
    .texel0_o(y0), .texel1_o(y1), .weight_o(weights_o[B +: B]));

  wrinkle_delay #(.WIDTH(4), .RANKS(2)) level (
    .clk(clk), .advance_i(advance_i), .data_i(level_i), .data_o(level2));

  assign request_o = {texture_i, level2, y1, y0, x1, x0};
endmodule
`default_nettype wire
