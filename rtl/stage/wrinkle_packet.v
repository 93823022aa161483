`default_nettype none
// Takes the word stream apart [docs/formats.md]. Words of a triangle go to the shadow registers of scan and
// interpolate, and `triangle_valid_o` says that they hold a whole packet; the next packet waits until it is taken. A
// draw packet waits until no fragment is in flight, so that its state is constant to every stage. With BUFFERING single
// the planes of a triangle go to the interpolators themselves, and wait until the walk of the one before has ended. A
// word that is no opcode is skipped. Latency 1 into the shadow registers. Does not look at any field of a triangle.
module wrinkle_packet #(
  parameter SCAN_WORDS  = 5,   // of a triangle packet, its opcode among them
  parameter PLANE_WORDS = 16,
  parameter DRAW_WORDS  = 4,   // of a draw packet
  parameter BUFFERING   = 0,
  parameter TEXTURED    = 1,   // the draw state has a texture
  parameter GLOSSY      = 1,   // ... and a highlight
  parameter CONSTANT    = 0,   // bits of its constant light vectors; 0: none
  parameter COUNT       = 3,   // colour channels
  parameter COLOUR_BITS = 8    // C
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
  output wire [PLANE_WORDS-1:0] plane_words_o,  // ... with BUFFERING single: the bit of which word
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
  output wire [COUNT*(COLOUR_BITS+1)-1:0] draw_ambient_o,   // u1.C, red in the low bits
  output wire [COUNT*(COLOUR_BITS+1)-1:0] draw_diffuse_o,
  output wire [COUNT*(COLOUR_BITS+1)-1:0] draw_specular_o,
  output wire [(CONSTANT != 0 ? CONSTANT : 1)-1:0] draw_l_o,                   // s1.F, x in the low bits
  output wire [(CONSTANT != 0 && GLOSSY != 0 ? CONSTANT : 1)-1:0] draw_h_o,    // s1.F, H or E
  output wire        busy_o
);
  // The index counts the words of either packet.
  localparam INDEX = $clog2(SCAN_WORDS + PLANE_WORDS > DRAW_WORDS ? SCAN_WORDS + PLANE_WORDS : DRAW_WORDS);
  localparam [31:0] LAST_OF_SCAN     = SCAN_WORDS - 1;
  localparam [31:0] LAST_OF_TRIANGLE = SCAN_WORDS + PLANE_WORDS - 1;
  localparam [31:0] LAST_OF_DRAW     = DRAW_WORDS - 1;
  localparam [INDEX-1:0] LAST_SCAN = LAST_OF_SCAN[INDEX-1:0];
  localparam [INDEX-1:0] LAST_WORD = LAST_OF_TRIANGLE[INDEX-1:0];
  localparam [INDEX-1:0] LAST_DRAW = LAST_OF_DRAW[INDEX-1:0];
  localparam [INDEX-1:0] FIRST     = 1;
  localparam [PLANE_WORDS-1:0] FIRST_PLANE = 1;
  localparam C1 = COLOUR_BITS + 1;

  wire        load, spare, word_valid, word_ready;
  wire [63:0] word;
  wrinkle_skid skid (
    .clk(clk), .rst(rst), .in_valid_i(packet_valid_i), .in_ready_o(packet_ready_o), .out_valid_o(word_valid),
    .out_ready_i(word_ready), .load_o(load), .spare_o(spare));
  wrinkle_skid_data #(.WIDTH(64)) skid_word (
    .clk(clk), .load_i(load), .spare_i(spare), .data_i(packet_word_i), .data_o(word));

  // What the next word is: an opcode, or one of a draw or of a triangle, and which.
  wire unused_walking = walking_i;
  reg             in_draw_q, in_triangle_q, loaded_q;
  reg [INDEX-1:0] index_q;

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
  assign plane_words_o    = BUFFERING != 0 && plane_shift_o ? FIRST_PLANE << (index_q - FIRST - LAST_SCAN)
                                                            : {PLANE_WORDS{1'b0}};
  assign triangle_valid_o = loaded_q;
  assign busy_o           = word_valid | ~opcode | loaded_q;

  always @(posedge clk)
    if (rst) begin
      in_draw_q     <= 1'b0;
      in_triangle_q <= 1'b0;
      loaded_q      <= 1'b0;
      index_q       <= {INDEX{1'b0}};
    end else begin
      if (triangle_take_i) loaded_q <= 1'b0;
      if (take) begin
        in_draw_q     <= is_draw | (in_draw_q & index_q != LAST_DRAW);
        in_triangle_q <= is_triangle | (in_triangle_q & index_q != LAST_WORD);
        index_q       <= opcode ? FIRST : index_q + FIRST;
        if (in_triangle_q & index_q == LAST_WORD) loaded_q <= 1'b1;
      end
    end

  // Draw state: only what the configuration has. What is rare is asked in two steps, the first of which mostly says no.
  wire take_flags = take & is_draw;
  wire take_draw  = take & in_draw_q;

  function [COUNT*C1-1:0] colour;
    input [63:0] channels;
    integer i;
    for (i = 0; i < COUNT; i = i + 1) colour[i*C1 +: C1] = channels[16*i +: C1];
  endfunction

  reg [COUNT*C1-1:0] ambient_q, diffuse_q;
  reg                shadow_q;

  assign draw_ambient_o = ambient_q;
  assign draw_diffuse_o = diffuse_q;
  assign draw_shadow_o  = shadow_q;

  always @(posedge clk) begin
    if (take_flags) shadow_q <= word[6];
    if (take_draw) begin
      if (index_q == 1) ambient_q <= colour(word);
      if (index_q == 2) diffuse_q <= colour(word);
    end
  end

  generate
    if (GLOSSY != 0) begin : with_specular
      reg [COUNT*C1-1:0] specular_q;
      reg                exponent_zero_q;
      reg [3:0]          squarings_q;
      assign draw_specular_o      = specular_q;
      assign draw_exponent_zero_o = exponent_zero_q;
      assign draw_squarings_o     = squarings_q;
      always @(posedge clk) begin
        if (take_flags) {squarings_q, exponent_zero_q} <= {word[39:36], word[7]};
        if (take_draw) if (index_q == 3) specular_q <= colour(word);
      end
    end else begin : without_specular
      assign draw_specular_o      = {COUNT*C1{1'b0}};
      assign draw_exponent_zero_o = 1'b0;
      assign draw_squarings_o     = 4'd0;
    end
    if (CONSTANT != 0) begin : with_light_vectors
      reg [CONSTANT-1:0] l_q;
      assign draw_l_o = l_q;
      always @(posedge clk) if (take_draw) if (index_q == 4) l_q <= word[CONSTANT-1:0];
      if (GLOSSY != 0) begin : with_h
        reg [CONSTANT-1:0] h_q;
        assign draw_h_o = h_q;
        always @(posedge clk) if (take_draw) if (index_q == 5) h_q <= word[CONSTANT-1:0];
      end else begin : without_h
        assign draw_h_o = 1'b0;
      end
    end else begin : without_light_vectors
      assign draw_l_o = 1'b0;
      assign draw_h_o = 1'b0;
    end
    if (TEXTURED != 0) begin : with_texture
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
