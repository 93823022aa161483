`default_nettype none
// Takes the word stream apart [docs/formats.md]. Words of a triangle go to the shadow registers of scan and
// interpolate, and `triangle_valid_o` says that they hold a whole packet; the next packet waits until it is taken. A
// draw packet waits until no fragment is in flight, so that its state is constant to every stage. With BUFFERING single
// the planes of a triangle go to the interpolators themselves, and wait until the walk of the one before has ended. A
// word that is no opcode is skipped. Latency 1 into the shadow registers. Does not look at any field of a triangle.
module wrinkle_packet #(
  parameter DATAPATH        = 1,
  parameter CROSS_PRODUCTS  = 0,
  parameter LIGHT_VECTORS   = 0,
  parameter LIGHTING        = 1,
  parameter FILTER          = 2,
  parameter PERSPECTIVE     = 0,
  parameter DEPTH           = 1,
  parameter DECAL           = 0,
  parameter BUFFERING       = 0,
  parameter CHANNELS        = 1,
  parameter SCREEN_BITS     = 10,
  parameter SUBPIXEL_BITS   = 8,
  parameter GUARD_BITS      = 10,
  parameter VECTOR_BITS     = 9,
  parameter WIDE_BITS       = 16,
  parameter UV_INTEGER_BITS = 4,
  parameter UV_BITS         = 18,
  parameter Q_BITS          = 18,
  parameter LOD_BITS        = 5,
  parameter UNIT_BITS       = 9,
  parameter COLOUR_BITS     = 8,
  parameter DEPTH_BITS      = 20
) (
  input  wire        clk,
  input  wire        rst,
  input  wire        packet_valid_i,
  output wire        packet_ready_o,
  input  wire [63:0] packet_word_i,
  input  wire        busy_i,              // a fragment is in flight
  input  wire        walking_i,           // scan has a row or a pixel to draw
  output wire [63:0] word_o,
  output wire        scan_shift_o,        // word_o is of the scan part
  output wire        plane_shift_o,       // ... of the planes part
  output wire        plane_last_o,        // ... its last word
  output wire        triangle_valid_o,
  input  wire        triangle_take_i,     // only while triangle_valid_o
  output wire        draw_bump_o,
  output wire        draw_textured_o,
  output wire        draw_shadow_o,
  output wire        draw_exponent_zero_o,
  output wire [1:0]  draw_wrap_u_o,
  output wire [1:0]  draw_wrap_v_o,
  output wire [3:0]  draw_log2_width_o,
  output wire [3:0]  draw_log2_height_o,
  output wire [3:0]  draw_max_level_o,
  output wire [11:0] draw_texture_o,
  output wire [3:0]  draw_squarings_o,
  output wire [(CHANNELS != 0 ? 3 : 1)*(COLOUR_BITS+1)-1:0] draw_ambient_o,   // u1.C, red in the low bits
  output wire [(CHANNELS != 0 ? 3 : 1)*(COLOUR_BITS+1)-1:0] draw_diffuse_o,
  output wire [(CHANNELS != 0 ? 3 : 1)*(COLOUR_BITS+1)-1:0] draw_specular_o,
  output wire [(LIGHT_VECTORS != 0 ? 3*(UNIT_BITS+2) : 1)-1:0] draw_l_o,       // s1.F, x in the low bits
  output wire [(LIGHT_VECTORS != 0 && LIGHTING != 0 ? 3*(UNIT_BITS+2) : 1)-1:0] draw_h_o,  // s1.F, H or E
  output wire        busy_o
);
  localparam TEXTURE    = DATAPATH == 1 || DATAPATH == 2 || DECAL != 0 ? 1 : 0;
  localparam DIVIDE     = TEXTURE != 0 && PERSPECTIVE != 0 ? 1 : 0;
  localparam LB         = FILTER == 2 ? LOD_BITS : 0;
  localparam EDGE_BITS  = SCREEN_BITS + SUBPIXEL_BITS + 2;
  localparam SCAN_BITS  = 5 + SCREEN_BITS + 2 * (SCREEN_BITS + 1) + 3 * (2 * (SCREEN_BITS + 2) + 3 * EDGE_BITS + 1);
  localparam HELD       = DATAPATH == 2 && CROSS_PRODUCTS != 0 ? 6 : 0;
  localparam PRODUCTS   = DATAPATH == 2 ? 9 - HELD : 0;
  localparam VECTORS    = (DATAPATH < 2 ? 3 : 0) + (LIGHT_VECTORS != 0 ? 0 : LIGHTING != 0 ? 6 : 3);
  localparam PLANES     = VECTORS + PRODUCTS + (TEXTURE != 0 ? 2 : 0) + (DIVIDE != 0 ? 2 : 0) + (DEPTH != 0 ? 1 : 0);
  localparam PLANE_BITS = 3 * (PLANES * GUARD_BITS + VECTORS * (VECTOR_BITS + 2) + PRODUCTS * (WIDE_BITS + 2) +
                               (TEXTURE != 0 ? 2 * (UV_INTEGER_BITS + UV_BITS) : 0) +
                               (DIVIDE != 0 ? Q_BITS + 6 + LB : 0) + (DEPTH != 0 ? DEPTH_BITS : 0)) +
                          HELD * (WIDE_BITS + 2) + (TEXTURE != 0 && DIVIDE == 0 ? 4 + LB : 0);
  localparam SCAN_WORDS  = (SCAN_BITS + 63) / 64;
  localparam PLANE_WORDS = (PLANE_BITS + 63) / 64;
  localparam [31:0] LAST_SCAN_INDEX = SCAN_WORDS - 1;
  localparam [31:0] LAST_INDEX      = SCAN_WORDS + PLANE_WORDS - 1;
  localparam [5:0] LAST_SCAN = LAST_SCAN_INDEX[5:0];
  localparam [5:0] LAST_WORD = LAST_INDEX[5:0];
  localparam [5:0] LAST_DRAW = LIGHT_VECTORS != 0 ? 6'd5 : 6'd3;
  localparam COUNT = CHANNELS != 0 ? 3 : 1;
  localparam C1    = COLOUR_BITS + 1;

  wire        load, spare, word_valid, word_ready;
  wire [63:0] word;
  wrinkle_skid skid (
    .clk(clk), .rst(rst), .in_valid_i(packet_valid_i), .in_ready_o(packet_ready_o), .out_valid_o(word_valid),
    .out_ready_i(word_ready), .load_o(load), .spare_o(spare));
  wrinkle_skid_data #(.WIDTH(64)) skid_word (
    .clk(clk), .load_i(load), .spare_i(spare), .data_i(packet_word_i), .data_o(word));

  // What the next word is: an opcode, or one of a draw or of a triangle, and which.
  wire unused_walking = walking_i;
  reg       in_draw_q, in_triangle_q, loaded_q;
  reg [5:0] index_q;

  wire opcode      = ~in_draw_q & ~in_triangle_q;
  wire is_draw     = opcode & word[3:0] == 4'd1;
  wire is_triangle = opcode & word[3:0] == 4'd2;
  wire scan_done   = in_triangle_q & index_q > LAST_SCAN;
  wire planes_wait = BUFFERING != 0 ? scan_done & walking_i : 1'b0;
  assign word_ready = is_draw ? ~(busy_i | loaded_q) : is_triangle ? ~loaded_q | triangle_take_i : ~planes_wait;
  wire take         = word_valid & word_ready;
  wire triangle     = take & (is_triangle | in_triangle_q);

  assign word_o           = word;
  assign scan_shift_o     = triangle & ~scan_done;
  assign plane_shift_o    = triangle & scan_done;
  assign plane_last_o     = index_q == LAST_WORD;
  assign triangle_valid_o = loaded_q;
  assign busy_o           = word_valid | ~opcode | loaded_q;

  always @(posedge clk)
    if (rst) begin
      in_draw_q     <= 1'b0;
      in_triangle_q <= 1'b0;
      loaded_q      <= 1'b0;
      index_q       <= 6'd0;
    end else begin
      if (triangle_take_i) loaded_q <= 1'b0;
      if (take) begin
        in_draw_q     <= is_draw | (in_draw_q & index_q != LAST_DRAW);
        in_triangle_q <= is_triangle | (in_triangle_q & index_q != LAST_WORD);
        index_q       <= opcode ? 6'd1 : index_q + 6'd1;
        if (in_triangle_q & index_q == LAST_WORD) loaded_q <= 1'b1;
      end
    end

  // Draw state: only what the configuration has.
  wire take_flags    = take & is_draw;
  wire take_ambient  = take & in_draw_q & index_q == 6'd1;
  wire take_diffuse  = take & in_draw_q & index_q == 6'd2;

  reg [COUNT*C1-1:0] ambient_q, diffuse_q;
  reg                shadow_q;
  wire [COUNT*C1-1:0] colour;
  genvar k;
  generate
    for (k = 0; k < COUNT; k = k + 1) begin : channel
      assign colour[k*C1 +: C1] = word[16*k +: C1];
    end
  endgenerate

  assign draw_ambient_o = ambient_q;
  assign draw_diffuse_o = diffuse_q;
  assign draw_shadow_o  = shadow_q;

  always @(posedge clk) begin
    if (take_flags) shadow_q <= word[6];
    if (take_ambient) ambient_q <= colour;
    if (take_diffuse) diffuse_q <= colour;
  end

  generate
    if (LIGHTING != 0) begin : with_specular
      reg [COUNT*C1-1:0] specular_q;
      reg                exponent_zero_q;
      reg [3:0]          squarings_q;
      assign draw_specular_o      = specular_q;
      assign draw_exponent_zero_o = exponent_zero_q;
      assign draw_squarings_o     = squarings_q;
      always @(posedge clk) begin
        if (take_flags) {squarings_q, exponent_zero_q} <= {word[39:36], word[7]};
        if (take & in_draw_q & index_q == 6'd3) specular_q <= colour;
      end
    end else begin : without_specular
      assign draw_specular_o      = {COUNT*C1{1'b0}};
      assign draw_exponent_zero_o = 1'b0;
      assign draw_squarings_o     = 4'd0;
    end
    if (LIGHT_VECTORS != 0) begin : with_light_vectors
      localparam UNIT = 3 * (UNIT_BITS + 2);
      reg [UNIT-1:0] l_q;
      assign draw_l_o = l_q;
      always @(posedge clk) if (take & in_draw_q & index_q == 6'd4) l_q <= word[UNIT-1:0];
      if (LIGHTING != 0) begin : with_h
        reg [UNIT-1:0] h_q;
        assign draw_h_o = h_q;
        always @(posedge clk) if (take & in_draw_q & index_q == 6'd5) h_q <= word[UNIT-1:0];
      end else begin : without_h
        assign draw_h_o = 1'b0;
      end
    end else begin : without_light_vectors
      assign draw_l_o = 1'b0;
      assign draw_h_o = 1'b0;
    end
    if (TEXTURE != 0) begin : with_texture
      reg [27:0] texture_q;
      reg        bump_q, textured_q;
      assign {draw_texture_o, draw_max_level_o, draw_log2_height_o, draw_log2_width_o} = texture_q[27:4];
      assign {draw_wrap_v_o, draw_wrap_u_o} = texture_q[3:0];
      assign draw_bump_o     = bump_q;
      assign draw_textured_o = textured_q;
      always @(posedge clk)
        if (take_flags) begin
          texture_q <= {word[35:12], word[11:8]};
          {textured_q, bump_q} <= word[5:4];
        end
    end else begin : without_texture
      assign {draw_texture_o, draw_max_level_o, draw_log2_height_o, draw_log2_width_o} = 24'd0;
      assign {draw_wrap_v_o, draw_wrap_u_o} = 4'd0;
      assign draw_bump_o     = 1'b0;
      assign draw_textured_o = 1'b0;
    end
  endgenerate
endmodule
`default_nettype wire
