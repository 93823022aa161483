`default_nettype none
// Texture: address, fetch, filter, decoding. A wire where no part of the configuration reads texels. A texel has the
// components of a bump map, then those of a colour, then a gloss; wrinkle_texture_filter says how a bump is decoded.
// Latency 2 to the request, the memory's own, then 2 (nearest), 3 (bilinear) or 4 (trilinear); waiting fragments stand
// in a buffer of 2^TEXTURE_FIFO_BITS, which also cuts the ready chain. Requests and responses are in order, one per
// fragment; a draw that is not `textured` sends none and gets a bump of 0, a white decal and full gloss. Does not cache.
module wrinkle_texture #(
  parameter BUMP_COMPONENTS   = 3,
  parameter BUMP_WIDTH        = 11,   // bits of a component, decoded
  parameter BUMP_FRACTION     = 9,    // ... of which fraction
  parameter BUMP_OFFSET       = 255,  // code 2c - offset
  parameter BUMP_SATURATES    = 0,
  parameter COLOURS           = 0,    // components of the decal
  parameter TEXELS            = 3,    // components of a texel; one more than those of bump and decal is the gloss
  parameter FILTER            = 2,
  parameter UV_INTEGER_BITS   = 4,
  parameter UV_BITS           = 18,
  parameter LOD_BITS          = 5,    // trilinear only
  parameter WEIGHT_BITS       = 8,    // bilinear and trilinear only
  parameter TEXEL_BITS        = 8,
  parameter TEXTURE_FIFO_BITS = 4,
  parameter CARRY             = 140
) (
  input  wire        clk,
  input  wire        rst,
  input  wire        draw_textured_i,        // draw state
  input  wire [1:0]  draw_wrap_u_i,
  input  wire [1:0]  draw_wrap_v_i,
  input  wire [3:0]  draw_log2_width_i,
  input  wire [3:0]  draw_log2_height_i,
  input  wire [3:0]  draw_max_level_i,
  input  wire [11:0] draw_texture_i,
  input  wire        in_valid_i,
  output wire        in_ready_o,
  input  wire [(TEXELS != 0 ? UV_INTEGER_BITS + UV_BITS : 1)-1:0] u_i,          // s(UI-1).UF
  input  wire [(TEXELS != 0 ? UV_INTEGER_BITS + UV_BITS : 1)-1:0] v_i,
  input  wire [(TEXELS != 0 ? (FILTER == 2 ? 6 + LOD_BITS : 6) : 1)-1:0] lod_i,  // s5.LB
  input  wire [CARRY-1:0] carry_i,
  output wire        texel_request_valid_o,
  input  wire        texel_request_ready_i,
  output wire [(TEXELS != 0 ? 64 : 1)-1:0]                texel_request_a_o,
  output wire [(TEXELS != 0 && FILTER == 2 ? 64 : 1)-1:0] texel_request_b_o,
  input  wire        texel_response_valid_i,
  output wire        texel_response_ready_o,
  input  wire [(TEXELS != 0 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_a00_i,
  input  wire [(FILTER > 0 && TEXELS != 0 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_a10_i,
  input  wire [(FILTER > 0 && TEXELS != 0 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_a01_i,
  input  wire [(FILTER > 0 && TEXELS != 0 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_a11_i,
  input  wire [(FILTER > 1 && TEXELS != 0 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_b00_i,
  input  wire [(FILTER > 1 && TEXELS != 0 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_b10_i,
  input  wire [(FILTER > 1 && TEXELS != 0 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_b01_i,
  input  wire [(FILTER > 1 && TEXELS != 0 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_b11_i,
  output wire        out_valid_o,
  input  wire        out_ready_i,
  output wire [(BUMP_COMPONENTS != 0 ? BUMP_COMPONENTS*BUMP_WIDTH : 1)-1:0] bump_o,  // first component in the low bits
  output wire [(COLOURS != 0 ? COLOURS*TEXEL_BITS : 1)-1:0]                decal_o, // u0.T, red in the low bits
  output wire [(TEXELS != BUMP_COMPONENTS + COLOURS ? TEXEL_BITS : 1)-1:0] gloss_o, // u0.T
  output wire [CARRY-1:0] carry_o,
  output wire        busy_o
);
  localparam B    = FILTER == 0 ? 0 : WEIGHT_BITS;
  localparam LB   = FILTER == 2 ? LOD_BITS : 0;
  localparam BW   = B > 0 ? B : 1;
  localparam LW   = LB > 0 ? LB : 1;
  localparam LEVELS = FILTER == 2 ? 2 : 1;
  localparam WEIGHTS = 2 * BW * LEVELS + LW;
  localparam RANKS = FILTER + 2;  // of the filter, with the rounding

  generate
    if (TEXELS != 0) begin : present
      // Address: two ranks.
      wire [WEIGHTS-1:0] weights2, weights_waiting;
      wire address_advance, address_valid, address_busy, fork_ready, push;

      wrinkle_pipe #(.RANKS(2)) address_pipe (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .advance_o(address_advance), .out_valid_o(address_valid),
        .out_ready_i(fork_ready), .busy_o(address_busy));
      wrinkle_texture_address #(
        .FILTER(FILTER), .UV_INTEGER_BITS(UV_INTEGER_BITS), .UV_BITS(UV_BITS), .LOD_BITS(LB), .WEIGHT_BITS(B)
      ) address (
        .clk(clk), .advance_i(address_advance), .u_i(u_i), .v_i(v_i), .lod_i(lod_i),
        .wrap_u_i(draw_wrap_u_i), .wrap_v_i(draw_wrap_v_i), .log2_width_i(draw_log2_width_i),
        .log2_height_i(draw_log2_height_i), .max_level_i(draw_max_level_i), .texture_i(draw_texture_i),
        .request_a_o(texel_request_a_o), .request_b_o(texel_request_b_o), .weights_o(weights2));

      // Fork: the request and the waiting fragment leave together.
      wire fifo_ready, fifo_valid, pop, filter_advance, filter_busy;
      wire [TEXTURE_FIFO_BITS-1:0] write, read;

      assign texel_request_valid_o = address_valid & fifo_ready & draw_textured_i;
      assign fork_ready = fifo_ready & (texel_request_ready_i | ~draw_textured_i);
      assign push = address_valid & fork_ready;

      wrinkle_fifo #(.ADDRESS_BITS(TEXTURE_FIFO_BITS)) waiting (
        .clk(clk), .rst(rst), .push_i(push), .ready_o(fifo_ready), .valid_o(fifo_valid), .pop_i(pop),
        .write_o(write), .read_o(read));
      wrinkle_fifo_memory #(.ADDRESS_BITS(TEXTURE_FIFO_BITS), .WIDTH(WEIGHTS)) waiting_weights (
        .clk(clk), .push_i(push), .write_i(write), .read_i(read), .data_i(weights2), .data_o(weights_waiting));

      // Join and filter.
      wire join_valid = fifo_valid & (texel_response_valid_i | ~draw_textured_i);
      assign texel_response_ready_o = fifo_valid & draw_textured_i & filter_advance;
      assign pop = join_valid & filter_advance;

      wrinkle_pipe #(.RANKS(RANKS)) filter_pipe (
        .clk(clk), .rst(rst), .in_valid_i(join_valid), .advance_o(filter_advance), .out_valid_o(out_valid_o),
        .out_ready_i(out_ready_i), .busy_o(filter_busy));
      wrinkle_texture_filter #(
        .BUMP_COMPONENTS(BUMP_COMPONENTS), .BUMP_WIDTH(BUMP_WIDTH), .BUMP_FRACTION(BUMP_FRACTION),
        .BUMP_OFFSET(BUMP_OFFSET), .BUMP_SATURATES(BUMP_SATURATES), .COLOURS(COLOURS), .TEXELS(TEXELS), .FILTER(FILTER),
        .LOD_BITS(LB), .WEIGHT_BITS(B), .TEXEL_BITS(TEXEL_BITS)
      ) filter (
        .clk(clk), .advance_i(filter_advance), .textured_i(draw_textured_i), .weights_i(weights_waiting),
        .a00_i(texel_a00_i), .a10_i(texel_a10_i), .a01_i(texel_a01_i), .a11_i(texel_a11_i),
        .b00_i(texel_b00_i), .b10_i(texel_b10_i), .b01_i(texel_b01_i), .b11_i(texel_b11_i),
        .bump_o(bump_o), .decal_o(decal_o), .gloss_o(gloss_o));

      wrinkle_carry #(
        .BITS(CARRY), .RANKS(2), .BUFFER_BITS(TEXTURE_FIFO_BITS), .LATE_RANKS(RANKS)
      ) carry (
        .clk(clk), .advance_i(address_advance), .push_i(push), .write_i(write), .read_i(read),
        .late_advance_i(filter_advance), .data_i(carry_i), .data_o(carry_o));

      assign in_ready_o = address_advance;
      assign busy_o = address_busy | fifo_valid | filter_busy;
    end else begin : absent
      wire unused_pins = &{1'b0, clk, rst, draw_textured_i, draw_wrap_u_i, draw_wrap_v_i, draw_log2_width_i,
        draw_log2_height_i, draw_max_level_i, draw_texture_i, u_i, v_i, lod_i, texel_request_ready_i,
        texel_response_valid_i, texel_a00_i, texel_a10_i, texel_a01_i, texel_a11_i, texel_b00_i, texel_b10_i,
        texel_b01_i, texel_b11_i};
      assign texel_request_valid_o  = 1'b0;
      assign texel_request_a_o      = 1'b0;
      assign texel_request_b_o      = 1'b0;
      assign texel_response_ready_o = 1'b0;
      assign in_ready_o  = out_ready_i;
      assign out_valid_o = in_valid_i;
      assign bump_o      = 1'b0;
      assign decal_o     = 1'b0;
      assign gloss_o     = 1'b0;
      assign carry_o     = carry_i;
      assign busy_o      = 1'b0;
    end
  endgenerate
endmodule
`default_nettype wire
