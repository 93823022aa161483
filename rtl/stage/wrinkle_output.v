`default_nettype none
// Material and rounding to the colour, one wrinkle_shade a channel, then the fragment port behind a skid register.
// Latency 4, with decal 5. Does not test depth or blend.
module wrinkle_output #(
  parameter LIGHTING    = 1,
  parameter DEPTH       = 1,
  parameter DECAL       = 0,
  parameter CHANNELS    = 1,
  parameter SCREEN_BITS = 10,
  parameter TEXEL_BITS  = 8,
  parameter DOT_BITS    = 10,
  parameter POWER_BITS  = 12,
  parameter COLOUR_BITS = 8,
  parameter DEPTH_BITS  = 20
) (
  input  wire clk,
  input  wire rst,
  input  wire [(CHANNELS != 0 ? 3 : 1)*(COLOUR_BITS+1)-1:0]   draw_ambient_i,   // u1.C
  input  wire [(CHANNELS != 0 ? 3 : 1)*(COLOUR_BITS+1)-1:0]   draw_diffuse_i,
  input  wire [(CHANNELS != 0 ? 3 : 1)*(COLOUR_BITS+1)-1:0]   draw_specular_i,
  input  wire in_valid_i,
  output wire in_ready_o,
  input  wire [DOT_BITS:0]                                    diffuse_i,        // u1.DF
  input  wire [(LIGHTING != 0 ? POWER_BITS : 0):0]            specular_i,       // u1.PF
  input  wire                                                 zero_i,
  input  wire [(DECAL != 0 ? 3*TEXEL_BITS : 1)-1:0]           decal_i,          // u0.T
  input  wire [2*SCREEN_BITS+(DEPTH != 0 ? DEPTH_BITS : 0):0] tag_i,            // {z, last, y, x}
  output wire out_valid_o,
  input  wire out_ready_i,
  output wire [(CHANNELS != 0 ? 3 : 1)*COLOUR_BITS-1:0]       colour_o,         // red in the low bits
  output wire [SCREEN_BITS-1:0]                               x_o,
  output wire [SCREEN_BITS-1:0]                               y_o,
  output wire [(DEPTH != 0 ? DEPTH_BITS : 1)-1:0]             z_o,              // u0.Z
  output wire last_o,
  output wire zero_o,
  output wire busy_o
);
  localparam X     = SCREEN_BITS;
  localparam TAG   = 2 * X + 1 + (DEPTH != 0 ? DEPTH_BITS : 0);
  localparam C     = COLOUR_BITS;
  localparam COUNT = CHANNELS != 0 ? 3 : 1;
  localparam RANKS = DECAL != 0 ? 4 : 3;
  localparam TD    = DECAL != 0 ? TEXEL_BITS : 1;

  wire               advance, pipe_valid, pipe_busy, skid_ready, load, spare;
  wire [COUNT*C-1:0] colour;
  wire [TAG:0]       tag, tag_out;

  wrinkle_pipe #(.RANKS(RANKS)) pipe (
    .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .advance_o(advance), .out_valid_o(pipe_valid),
    .out_ready_i(skid_ready), .busy_o(pipe_busy));
  assign in_ready_o = advance;
  assign busy_o = pipe_busy | out_valid_o;

  genvar k;
  generate
    for (k = 0; k < COUNT; k = k + 1) begin : channel
      wrinkle_shade #(
        .LIGHTING(LIGHTING), .DECAL(DECAL), .TEXEL_BITS(TEXEL_BITS), .DOT_BITS(DOT_BITS), .POWER_BITS(POWER_BITS),
        .COLOUR_BITS(C)
      ) shade (
        .clk(clk), .advance_i(advance), .ambient_i(draw_ambient_i[k*(C+1) +: C+1]),
        .diffuse_colour_i(draw_diffuse_i[k*(C+1) +: C+1]), .specular_colour_i(draw_specular_i[k*(C+1) +: C+1]),
        .diffuse_i(diffuse_i), .specular_i(specular_i), .decal_i(decal_i[(DECAL != 0 ? k : 0)*TD +: TD]),
        .colour_o(colour[k*C +: C]));
    end
    if (CHANNELS == 0 && DECAL != 0) begin : grey
      wire unused_decal = &{1'b0, decal_i};
    end
    if (DEPTH != 0) begin : with_z
      assign z_o = tag_out[2*X+1 +: DEPTH_BITS];
    end else begin : without_z
      assign z_o = 1'b0;
    end
  endgenerate

  wrinkle_delay #(.WIDTH(TAG + 1), .RANKS(RANKS)) delay (
    .clk(clk), .advance_i(advance), .data_i({zero_i, tag_i}), .data_o(tag));

  wrinkle_skid skid (
    .clk(clk), .rst(rst), .in_valid_i(pipe_valid), .in_ready_o(skid_ready), .out_valid_o(out_valid_o),
    .out_ready_i(out_ready_i), .load_o(load), .spare_o(spare));
  wrinkle_skid_data #(.WIDTH(COUNT*C)) skid_colour (
    .clk(clk), .load_i(load), .spare_i(spare), .data_i(colour), .data_o(colour_o));
  wrinkle_skid_data #(.WIDTH(TAG + 1)) skid_tag (
    .clk(clk), .load_i(load), .spare_i(spare), .data_i(tag), .data_o(tag_out));

  assign x_o    = tag_out[X-1:0];
  assign y_o    = tag_out[2*X-1:X];
  assign last_o = tag_out[2*X];
  assign zero_o = tag_out[TAG];
endmodule
`default_nettype wire
