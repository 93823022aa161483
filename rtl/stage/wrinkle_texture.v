`default_nettype none
// Texture: address, fetch, filter. A wire where no part of the configuration reads texels.
// Latency 2 to the request, the memory's own, then 2 (nearest), 3 (bilinear) or 4 (trilinear); waiting fragments stand
// in a buffer of 2^TEXTURE_FIFO_BITS, which also cuts the ready chain. Requests and responses are in order, one per
// fragment; a draw that is not `textured` sends none and gets n = 0 (fu = fv = 0) and a white decal. Does not cache.
module wrinkle_texture #(
  parameter DATAPATH          = 1,
  parameter LIGHT_VECTORS     = 0,
  parameter LIGHTING          = 1,
  parameter FILTER            = 2,
  parameter DECODE            = 0,
  parameter DEPTH             = 1,
  parameter DECAL             = 0,
  parameter SCREEN_BITS       = 10,
  parameter VECTOR_BITS       = 9,
  parameter WIDE_BITS         = 16,
  parameter GRADIENT_BITS     = 9,
  parameter UV_INTEGER_BITS   = 4,
  parameter UV_BITS           = 18,
  parameter LOD_BITS          = 5,
  parameter WEIGHT_BITS       = 8,
  parameter TEXEL_BITS        = 8,
  parameter DEPTH_BITS        = 20,
  parameter TEXTURE_FIFO_BITS = 4,
  // Of the above: components of a texel; bits of N or {C, B, A}, of L, of H or E.
  parameter TEXELS = (DATAPATH == 1 ? 3 : DATAPATH == 2 ? 2 : 0) + 3*DECAL,
  parameter SMOOTH = DATAPATH == 3 ? 1 : DATAPATH == 2 ? 9*(WIDE_BITS+2) : 3*(VECTOR_BITS+2),
  parameter LVEC   = LIGHT_VECTORS != 0 ? 1 : 3*(VECTOR_BITS+2),
  parameter HVEC   = LIGHTING != 0 ? LVEC : 1
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
  input  wire [SMOOTH-1:0] smooth_i,         // interpolated N in s1.V, or {C, B, A} in s1.VW
  input  wire [LVEC-1:0]   l_i,              // s1.V
  input  wire [HVEC-1:0]   h_i,              // s1.V
  input  wire [(TEXELS != 0 ? UV_INTEGER_BITS + UV_BITS : 1)-1:0] u_i,  // s(UI-1).UF
  input  wire [(TEXELS != 0 ? UV_INTEGER_BITS + UV_BITS : 1)-1:0] v_i,
  input  wire [(TEXELS != 0 ? (FILTER == 2 ? 6 + LOD_BITS : 6) : 1)-1:0] lod_i,  // s5.LB
  input  wire [2*SCREEN_BITS+(DEPTH != 0 ? DEPTH_BITS : 0):0] tag_i,  // {z, last, y, x}
  output wire        texel_request_valid_o,
  input  wire        texel_request_ready_i,
  output wire [(TEXELS != 0 ? 64 : 1)-1:0]                texel_request_a_o,
  output wire [(TEXELS != 0 && FILTER == 2 ? 64 : 1)-1:0] texel_request_b_o,
  input  wire        texel_response_valid_i,
  output wire        texel_response_ready_o,
  input  wire [(TEXELS != 0 ? TEXELS*TEXEL_BITS : 1)-1:0]               texel_a00_i,
  input  wire [(TEXELS != 0 && FILTER > 0 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_a10_i,
  input  wire [(TEXELS != 0 && FILTER > 0 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_a01_i,
  input  wire [(TEXELS != 0 && FILTER > 0 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_a11_i,
  input  wire [(TEXELS != 0 && FILTER > 1 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_b00_i,
  input  wire [(TEXELS != 0 && FILTER > 1 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_b10_i,
  input  wire [(TEXELS != 0 && FILTER > 1 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_b01_i,
  input  wire [(TEXELS != 0 && FILTER > 1 ? TEXELS*TEXEL_BITS : 1)-1:0] texel_b11_i,
  output wire        out_valid_o,
  input  wire        out_ready_i,
  output wire [SMOOTH-1:0] smooth_o,
  output wire [(DATAPATH == 1 ? 3*(VECTOR_BITS+2) : 1)-1:0]   n_o,         // s1.V, from the texel
  output wire [(DATAPATH == 2 ? 2*(GRADIENT_BITS+1) : 1)-1:0] gradient_o,  // {fv, fu} in s0.GB, from the texel
  output wire [(DECAL != 0 ? 3*TEXEL_BITS : 1)-1:0]           decal_o,     // u0.T, red in the low bits
  output wire [LVEC-1:0]   l_o,
  output wire [HVEC-1:0]   h_o,
  output wire [2*SCREEN_BITS+(DEPTH != 0 ? DEPTH_BITS : 0):0] tag_o,
  output wire        busy_o
);
  localparam TAG  = 2 * SCREEN_BITS + 1 + (DEPTH != 0 ? DEPTH_BITS : 0);
  localparam HAS_SMOOTH = DATAPATH != 3 ? 1 : 0;
  localparam HAS_L = LIGHT_VECTORS == 0 ? 1 : 0;
  localparam HAS_H = LIGHTING != 0 ? HAS_L : 0;
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
      wire [SMOOTH-1:0] smooth2, smooth_waiting;
      wire [LVEC-1:0] l2, l_waiting;
      wire [HVEC-1:0] h2, h_waiting;
      wire [TAG-1:0]  tag2, tag_waiting;
      wire [WEIGHTS-1:0] weights2, weights_waiting;
      wire address_advance, address_valid, address_busy, fork_ready, push;

      wrinkle_pipe #(.RANKS(2)) address_pipe (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .advance_o(address_advance), .out_valid_o(address_valid),
        .out_ready_i(fork_ready), .busy_o(address_busy));
      wrinkle_delay #(.WIDTH(SMOOTH), .RANKS(2 * HAS_SMOOTH)) delay_smooth (
        .clk(clk), .advance_i(address_advance), .data_i(smooth_i), .data_o(smooth2));
      wrinkle_delay #(.WIDTH(LVEC), .RANKS(2 * HAS_L)) delay_l (
        .clk(clk), .advance_i(address_advance), .data_i(l_i), .data_o(l2));
      wrinkle_delay #(.WIDTH(HVEC), .RANKS(2 * HAS_H)) delay_h (
        .clk(clk), .advance_i(address_advance), .data_i(h_i), .data_o(h2));
      wrinkle_delay #(.WIDTH(TAG), .RANKS(2)) delay_tag (
        .clk(clk), .advance_i(address_advance), .data_i(tag_i), .data_o(tag2));

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
      wrinkle_fifo_memory #(.ADDRESS_BITS(TEXTURE_FIFO_BITS), .WIDTH(TAG)) waiting_tag (
        .clk(clk), .push_i(push), .write_i(write), .read_i(read), .data_i(tag2), .data_o(tag_waiting));
      wrinkle_fifo_memory #(.ADDRESS_BITS(TEXTURE_FIFO_BITS), .WIDTH(WEIGHTS)) waiting_weights (
        .clk(clk), .push_i(push), .write_i(write), .read_i(read), .data_i(weights2), .data_o(weights_waiting));
      if (HAS_SMOOTH != 0) begin : with_smooth
        wrinkle_fifo_memory #(.ADDRESS_BITS(TEXTURE_FIFO_BITS), .WIDTH(SMOOTH)) waiting_smooth (
          .clk(clk), .push_i(push), .write_i(write), .read_i(read), .data_i(smooth2), .data_o(smooth_waiting));
      end else begin : without_smooth
        assign smooth_waiting = smooth2;
      end
      if (HAS_L != 0) begin : with_l
        wrinkle_fifo_memory #(.ADDRESS_BITS(TEXTURE_FIFO_BITS), .WIDTH(LVEC)) waiting_l (
          .clk(clk), .push_i(push), .write_i(write), .read_i(read), .data_i(l2), .data_o(l_waiting));
      end else begin : without_l
        assign l_waiting = l2;
      end
      if (HAS_H != 0) begin : with_h
        wrinkle_fifo_memory #(.ADDRESS_BITS(TEXTURE_FIFO_BITS), .WIDTH(HVEC)) waiting_h (
          .clk(clk), .push_i(push), .write_i(write), .read_i(read), .data_i(h2), .data_o(h_waiting));
      end else begin : without_h
        assign h_waiting = h2;
      end

      // Join and filter.
      wire join_valid = fifo_valid & (texel_response_valid_i | ~draw_textured_i);
      assign texel_response_ready_o = fifo_valid & draw_textured_i & filter_advance;
      assign pop = join_valid & filter_advance;

      wrinkle_pipe #(.RANKS(RANKS)) filter_pipe (
        .clk(clk), .rst(rst), .in_valid_i(join_valid), .advance_o(filter_advance), .out_valid_o(out_valid_o),
        .out_ready_i(out_ready_i), .busy_o(filter_busy));
      wrinkle_texture_filter #(
        .DATAPATH(DATAPATH), .FILTER(FILTER), .DECODE(DECODE), .DECAL(DECAL), .VECTOR_BITS(VECTOR_BITS),
        .GRADIENT_BITS(GRADIENT_BITS), .LOD_BITS(LB), .WEIGHT_BITS(B), .TEXEL_BITS(TEXEL_BITS)
      ) filter (
        .clk(clk), .advance_i(filter_advance), .textured_i(draw_textured_i), .weights_i(weights_waiting),
        .a00_i(texel_a00_i), .a10_i(texel_a10_i), .a01_i(texel_a01_i), .a11_i(texel_a11_i),
        .b00_i(texel_b00_i), .b10_i(texel_b10_i), .b01_i(texel_b01_i), .b11_i(texel_b11_i),
        .n_o(n_o), .gradient_o(gradient_o), .decal_o(decal_o));
      wrinkle_delay #(.WIDTH(SMOOTH), .RANKS(HAS_SMOOTH * RANKS)) filter_smooth (
        .clk(clk), .advance_i(filter_advance), .data_i(smooth_waiting), .data_o(smooth_o));
      wrinkle_delay #(.WIDTH(LVEC), .RANKS(HAS_L * RANKS)) filter_l (
        .clk(clk), .advance_i(filter_advance), .data_i(l_waiting), .data_o(l_o));
      wrinkle_delay #(.WIDTH(HVEC), .RANKS(HAS_H * RANKS)) filter_h (
        .clk(clk), .advance_i(filter_advance), .data_i(h_waiting), .data_o(h_o));
      wrinkle_delay #(.WIDTH(TAG), .RANKS(RANKS)) filter_tag (
        .clk(clk), .advance_i(filter_advance), .data_i(tag_waiting), .data_o(tag_o));

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
      assign smooth_o    = smooth_i;
      assign n_o         = 1'b0;
      assign gradient_o  = 1'b0;
      assign decal_o     = 1'b0;
      assign l_o         = l_i;
      assign h_o         = h_i;
      assign tag_o       = tag_i;
      assign busy_o      = 1'b0;
    end
  endgenerate
endmodule
`default_nettype wire
