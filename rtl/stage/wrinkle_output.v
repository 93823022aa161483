`default_nettype none
// Material and rounding to the colour, one wrinkle_shade a channel, then a skid register, so that the fragment port
// depends on registers alone. With a gloss the highlight of all channels is first
//   round_half_up(specular * (gloss + (gloss >> (T-1))), T)
// Latency 4, with decal or gloss 5. Does not test depth or blend.
module wrinkle_output #(
  parameter GLOSSY      = 1,
  parameter COLOURS     = 0,   // components of the decal
  parameter GLOSS_MAP   = 0,   // 1: texels have a gloss
  parameter COUNT       = 3,   // colour channels
  parameter TEXEL_BITS  = 8,   // T
  parameter DOT_BITS    = 10,  // DF
  parameter POWER_BITS  = 12,  // PF
  parameter COLOUR_BITS = 8,   // C
  parameter CARRY       = 42
) (
  input  wire clk,
  input  wire rst,
  input  wire [COUNT*(COLOUR_BITS+1)-1:0]                   draw_ambient_i,   // u1.C
  input  wire [COUNT*(COLOUR_BITS+1)-1:0]                   draw_diffuse_i,
  input  wire [COUNT*(COLOUR_BITS+1)-1:0]                   draw_specular_i,
  input  wire in_valid_i,
  output wire in_ready_o,
  input  wire [DOT_BITS:0]                                  diffuse_i,        // u1.DF
  input  wire [(GLOSSY != 0 ? POWER_BITS : 0):0]            specular_i,       // u1.PF
  input  wire [(COLOURS != 0 ? COLOURS*TEXEL_BITS : 1)-1:0] decal_i,          // u0.T
  input  wire [(GLOSS_MAP != 0 ? TEXEL_BITS : 1)-1:0]       gloss_i,          // u0.T
  input  wire [CARRY-1:0]                                   carry_i,
  output wire out_valid_o,
  input  wire out_ready_i,
  output wire [COUNT*COLOUR_BITS-1:0]                       colour_o,         // red in the low bits
  output wire [CARRY-1:0]                                   carry_o,
  output wire busy_o
);
  localparam C     = COLOUR_BITS;
  localparam RANKS = COLOURS != 0 || GLOSS_MAP != 0 ? 4 : 3;
  localparam TD    = COLOURS != 0 ? TEXEL_BITS : 1;
  localparam T     = TEXEL_BITS;
  localparam PF    = GLOSSY != 0 ? POWER_BITS : 0;

  wire               advance, pipe_valid, pipe_busy, skid_ready, load, spare;
  wire [COUNT*C-1:0] colour;
  wire [CARRY-1:0]   carried;

  wrinkle_pipe #(.RANKS(RANKS)) pipe (
    .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .advance_o(advance), .out_valid_o(pipe_valid),
    .out_ready_i(skid_ready), .busy_o(pipe_busy));
  assign in_ready_o = advance;
  assign busy_o = pipe_busy | out_valid_o;

  // The highlight of the fragment: with a gloss a clock after the rest of it.
  wire [PF:0] highlight;
  genvar k;
  generate
    if (GLOSS_MAP != 0) begin : glossed
      wire [PF+T+1:0]      product;
      wire signed [PF+1:0] rounded;
      reg [PF:0]           highlight_q;
      wire unused_sign = rounded[PF+1];
      wrinkle_multiply_unsigned #(.A_BITS(PF + 1), .B_BITS(T + 1)) multiply_gloss (
        .a_i(specular_i), .b_i({1'b0, gloss_i} + {{T{1'b0}}, gloss_i[T-1]}), .product_o(product));
      wrinkle_round_half_up #(.VALUE_BITS(PF + T + 2), .SHIFT(T), .RESULT_BITS(PF + 2)) round (
        .value_i(product), .result_o(rounded));
      assign highlight = highlight_q;
      always @(posedge clk) if (advance) highlight_q <= rounded[PF:0];
    end else begin : whole
      wire unused_pins = gloss_i;
      assign highlight = specular_i;
    end
    for (k = 0; k < COUNT; k = k + 1) begin : channel
      wrinkle_shade #(
        .GLOSSY(GLOSSY), .DECAL(COLOURS), .GLOSS_MAP(GLOSS_MAP), .TEXEL_BITS(TEXEL_BITS), .DOT_BITS(DOT_BITS),
        .POWER_BITS(POWER_BITS), .COLOUR_BITS(C)
      ) shade (
        .clk(clk), .advance_i(advance), .ambient_i(draw_ambient_i[k*(C+1) +: C+1]),
        .diffuse_colour_i(draw_diffuse_i[k*(C+1) +: C+1]), .specular_colour_i(draw_specular_i[k*(C+1) +: C+1]),
        .diffuse_i(diffuse_i), .specular_i(highlight), .decal_i(decal_i[(COLOURS != 0 ? k : 0)*TD +: TD]),
        .colour_o(colour[k*C +: C]));
    end
    if (COUNT == 1 && COLOURS != 0) begin : grey
      wire unused_decal = &{1'b0, decal_i};
    end
  endgenerate

  wrinkle_carry #(.BITS(CARRY), .RANKS(RANKS)) carry (
    .clk(clk), .advance_i(advance), .push_i(1'b0), .write_i(1'b0), .read_i(1'b0), .late_advance_i(1'b0),
    .data_i(carry_i), .data_o(carried));

  wrinkle_skid skid (
    .clk(clk), .rst(rst), .in_valid_i(pipe_valid), .in_ready_o(skid_ready), .out_valid_o(out_valid_o),
    .out_ready_i(out_ready_i), .load_o(load), .spare_o(spare));
  wrinkle_skid_data #(.WIDTH(COUNT*C)) skid_colour (
    .clk(clk), .load_i(load), .spare_i(spare), .data_i(colour), .data_o(colour_o));
  wrinkle_skid_data #(.WIDTH(CARRY)) skid_carry (
    .clk(clk), .load_i(load), .spare_i(spare), .data_i(carried), .data_o(carry_o));
endmodule
`default_nettype wire
