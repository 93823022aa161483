`default_nettype none
// u (or v) to the two texels on either side of it in one level, and the weight of the second.
//   s = (u << size_log2) + half an LSB of the weight - half a texel;  i = s >> UF;  weight = the B bits below
// which is floor and fraction of round_half_up(u, UF - size_log2 - B) - 2^(B-1). B = 0 is nearest: i = floor(u * size).
// Latency 2.
module wrinkle_texel_coordinate #(
  parameter UV_INTEGER_BITS = 4,
  parameter UV_BITS         = 18,  // UF
  parameter WEIGHT_BITS     = 8    // B; 0: no second texel, no weight
) (
  input  wire                                     clk,
  input  wire                                     advance_i,
  input  wire signed [UV_INTEGER_BITS+UV_BITS-1:0] u_i,        // repeats, s(UI-1).UF
  input  wire [3:0]                               size_log2_i,
  input  wire [1:0]                               mode_i,      // constant over a draw
  output wire [11:0]                              texel0_o,
  output wire [11:0]                              texel1_o,    // B = 0: texel0
  output wire [(WEIGHT_BITS > 0 ? WEIGHT_BITS : 1)-1:0] weight_o  // u0.B
);
  localparam U_BITS     = UV_INTEGER_BITS + UV_BITS;
  localparam S_BITS     = U_BITS + 13;
  localparam INDEX_BITS = UV_INTEGER_BITS + 13;

  wire [S_BITS-1:0] scaled = {{13{u_i[U_BITS-1]}}, u_i} << size_log2_i;
  reg [S_BITS-1:0]  s_q;
  reg [3:0]         size_q;
  reg [11:0]        texel0_q;
  wire [11:0]       texel0;

  wrinkle_wrap #(.INDEX_BITS(INDEX_BITS)) wrap0 (
    .index_i(s_q[S_BITS-1:UV_BITS]), .size_log2_i(size_q), .mode_i(mode_i), .texel_o(texel0));

  assign texel0_o = texel0_q;

  always @(posedge clk)
    if (advance_i) begin
      size_q   <= size_log2_i;
      texel0_q <= texel0;
    end

  generate
    if (WEIGHT_BITS > 0) begin : linear
      localparam [S_BITS-1:0] ONE  = {{(S_BITS - 1){1'b0}}, 1'b1};
      localparam [S_BITS-1:0] HALF = UV_BITS > WEIGHT_BITS ? ONE << (UV_BITS - WEIGHT_BITS - 1) : {S_BITS{1'b0}};
      localparam [S_BITS-1:0] BIAS = HALF - (ONE << (UV_BITS - 1));
      reg [11:0]            texel1_q;
      reg [WEIGHT_BITS-1:0] weight_q;
      wire [11:0]           texel1;
      wire unused_low = &{1'b0, s_q};

      wrinkle_wrap #(.INDEX_BITS(INDEX_BITS)) wrap1 (
        .index_i(s_q[S_BITS-1:UV_BITS] + {{(INDEX_BITS - 1){1'b0}}, 1'b1}), .size_log2_i(size_q), .mode_i(mode_i),
        .texel_o(texel1));
      assign texel1_o = texel1_q;
      assign weight_o = weight_q;
      always @(posedge clk)
        if (advance_i) begin
          s_q      <= scaled + BIAS;
          texel1_q <= texel1;
          weight_q <= s_q[UV_BITS-1 -: WEIGHT_BITS];
        end
    end else begin : nearest
      wire unused_low = &{1'b0, s_q};
      assign texel1_o = texel0_q;
      assign weight_o = 1'b0;
      always @(posedge clk) if (advance_i) s_q <= scaled;
    end
  endgenerate
endmodule
`default_nettype wire
