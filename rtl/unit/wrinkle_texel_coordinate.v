`default_nettype none
// u (or v) to the number of the texel before it in one level, without wrapping, and the weight of the texel after it.
//   s = (u << size_log2) + half an LSB of the weight - half a texel;  i = s >> UF;  weight = the B bits below
// which is floor and fraction of round_half_up(u, UF - size_log2 - B) - 2^(B-1). B = 0 is nearest: i = floor(u * size).
// Latency 1.
module wrinkle_texel_coordinate #(
  parameter UV_INTEGER_BITS = 4,
  parameter UV_BITS         = 18,  // UF
  parameter WEIGHT_BITS     = 8    // B; 0: no second texel, no weight
) (
  input  wire                                      clk,
  input  wire                                      advance_i,
  input  wire signed [UV_INTEGER_BITS+UV_BITS-1:0] u_i,         // repeats, s(UI-1).UF
  input  wire [3:0]                                log2_i,      // size of level 0
  input  wire [3:0]                                level_i,
  output wire [UV_INTEGER_BITS+12:0]               index_o,
  output wire [3:0]                                size_log2_o,
  output wire [(WEIGHT_BITS > 0 ? WEIGHT_BITS : 1)-1:0] weight_o  // u0.B
);
  localparam U_BITS = UV_INTEGER_BITS + UV_BITS;
  localparam S_BITS = U_BITS + 13;
  localparam [S_BITS-1:0] ONE  = {{(S_BITS - 1){1'b0}}, 1'b1};
  localparam [S_BITS-1:0] HALF = UV_BITS > WEIGHT_BITS ? ONE << (UV_BITS - WEIGHT_BITS - 1) : {S_BITS{1'b0}};
  localparam [S_BITS-1:0] BIAS = WEIGHT_BITS > 0 ? HALF - (ONE << (UV_BITS - 1)) : {S_BITS{1'b0}};

  function [3:0] size_log2;
    input [3:0] log2, level;
    size_log2 = log2 > level ? log2 - level : 4'd0;
  endfunction

  reg [S_BITS-1:0] s_q;
  reg [3:0]        size_q;

  wire unused_low = &{1'b0, s_q};
  assign index_o     = s_q[S_BITS-1:UV_BITS];
  assign size_log2_o = size_q;

  always @(posedge clk)
    if (advance_i) begin
      s_q    <= ({{13{u_i[U_BITS-1]}}, u_i} << size_log2(log2_i, level_i)) + BIAS;
      size_q <= size_log2(log2_i, level_i);
    end

  generate
    if (WEIGHT_BITS > 0) begin : linear
      assign weight_o = s_q[UV_BITS-1 -: WEIGHT_BITS];
    end else begin : nearest
      assign weight_o = 1'b0;
    end
  endgenerate
endmodule
`default_nettype wire
