`default_nettype none
// One texel component filtered: along x, along y, between levels, one rank each, exact.
// Latency 1 nearest, 2 bilinear, 3 trilinear. The weights come already delayed to the rank that uses them.
module wrinkle_texel_filter #(
  parameter TEXEL_BITS  = 8,
  parameter WEIGHT_BITS = 8,  // B; 0: nearest
  parameter LOD_BITS    = 5,  // LB; 0: the second level is never mixed in
  parameter LEVELS      = 2   // 2: trilinear
) (
  input  wire clk,
  input  wire advance_i,
  input  wire [4*TEXEL_BITS-1:0] a_i,                                    // level a: {11, 01, 10, 00}
  input  wire [4*TEXEL_BITS-1:0] b_i,
  input  wire [2*(WEIGHT_BITS > 0 ? WEIGHT_BITS : 1)-1:0] weights_x_i,  // {level b, level a}
  input  wire [2*(WEIGHT_BITS > 0 ? WEIGHT_BITS : 1)-1:0] weights_y_i,
  input  wire [(LOD_BITS > 0 ? LOD_BITS : 1)-1:0] weight_level_i,
  output wire [TEXEL_BITS+2*WEIGHT_BITS+LOD_BITS-1:0] value_o           // uT.D
);
  localparam T = TEXEL_BITS;
  localparam B = WEIGHT_BITS;

  genvar k;
  generate
    if (B == 0 && LEVELS == 1) begin : nearest
      reg [T-1:0] value_q;
      wire unused_pins = &{1'b0, a_i, b_i, weights_x_i, weights_y_i, weight_level_i};
      assign value_o = value_q;
      always @(posedge clk) if (advance_i) value_q <= a_i[T-1:0];
    end else begin : linear
      for (k = 0; k < LEVELS; k = k + 1) begin : level
        wire [4*T-1:0]   quad = k == 0 ? a_i : b_i;
        reg [T+B-1:0]    upper_q, lower_q;
        reg [T+2*B-1:0]  value_q;
        wire [T+B-1:0]   upper, lower;
        wire [T+2*B-1:0] value;
        wrinkle_lerp #(.BITS(T), .WEIGHT_BITS(B)) along_x0 (
          .a_i(quad[0 +: T]), .b_i(quad[T +: T]), .weight_i(weights_x_i[k*B +: B]), .value_o(upper));
        wrinkle_lerp #(.BITS(T), .WEIGHT_BITS(B)) along_x1 (
          .a_i(quad[2*T +: T]), .b_i(quad[3*T +: T]), .weight_i(weights_x_i[k*B +: B]), .value_o(lower));
        wrinkle_lerp #(.BITS(T + B), .WEIGHT_BITS(B)) along_y (
          .a_i(upper_q), .b_i(lower_q), .weight_i(weights_y_i[k*B +: B]), .value_o(value));
        always @(posedge clk)
          if (advance_i) begin
            upper_q <= upper;
            lower_q <= lower;
            value_q <= value;
          end
      end
      if (LEVELS == 1) begin : bilinear
        wire unused_pins = &{1'b0, b_i, weights_x_i, weights_y_i, weight_level_i};
        assign value_o = level[0].value_q;
      end else if (LOD_BITS == 0) begin : nearer
        reg [T+2*B-1:0] value_q;
        wire unused_pins = &{1'b0, weight_level_i, level[1].value_q};
        assign value_o = value_q;
        always @(posedge clk) if (advance_i) value_q <= level[0].value_q;
      end else begin : trilinear
        reg [T+2*B+LOD_BITS-1:0]  value_q;
        wire [T+2*B+LOD_BITS-1:0] value;
        wrinkle_lerp #(.BITS(T + 2 * B), .WEIGHT_BITS(LOD_BITS)) between (
          .a_i(level[0].value_q), .b_i(level[1].value_q), .weight_i(weight_level_i), .value_o(value));
        assign value_o = value_q;
        always @(posedge clk) if (advance_i) value_q <= value;
      end
    end
  endgenerate
endmodule
`default_nettype wire
