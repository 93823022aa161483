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
  localparam B          = WEIGHT_BITS > 0 ? WEIGHT_BITS : 1;
  localparam INDEX_BITS = UV_INTEGER_BITS + 13;

`include "wrinkle_wrap.vh"

  wire [INDEX_BITS-1:0] x, y;
  wire [3:0]            width, height;
  wire [2*B-1:0]        weights;

  wrinkle_texel_coordinate #(
    .UV_INTEGER_BITS(UV_INTEGER_BITS), .UV_BITS(UV_BITS), .WEIGHT_BITS(WEIGHT_BITS)
  ) along_u (
    .clk(clk), .advance_i(advance_i), .u_i(u_i), .log2_i(log2_width_i), .level_i(level_i), .index_o(x),
    .size_log2_o(width), .weight_o(weights[0 +: B]));

  wrinkle_texel_coordinate #(
    .UV_INTEGER_BITS(UV_INTEGER_BITS), .UV_BITS(UV_BITS), .WEIGHT_BITS(WEIGHT_BITS)
  ) along_v (
    .clk(clk), .advance_i(advance_i), .u_i(v_i), .log2_i(log2_height_i), .level_i(level_i), .index_o(y),
    .size_log2_o(height), .weight_o(weights[B +: B]));

  // The texel after the one before; with nearest there is none, and it is the same.
  localparam [INDEX_BITS-1:0] NEXT = WEIGHT_BITS > 0 ? 1 : 0;
  reg [3:0]     level_q;
  reg [51:0]    request_q;
  reg [2*B-1:0] weights_q;

  assign request_o = {texture_i, request_q};
  assign weights_o = weights_q;

  always @(posedge clk)
    if (advance_i) begin
      request_q <= {level_q, wrapped(y + NEXT, height, wrap_v_i), wrapped(y, height, wrap_v_i),
                    wrapped(x + NEXT, width, wrap_u_i), wrapped(x, width, wrap_u_i)};
      weights_q <= weights;
      level_q   <= level_i;
    end
endmodule
`default_nettype wire
