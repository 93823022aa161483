`default_nettype none
// One colour channel of the output stage:
//   base   = (A << DF) + D * diffuse;  with decal base = round_half_up(base * (decal + (decal >> (T-1))), T)
//   sum    = (base << (PF - DF)) + S * specular
//   colour = saturate(round_half_up(sum * (2^C - 1), C + PF))
// Without a highlight PF is taken as DF, which changes no bit. Latency 3, with decal or gloss 4.
module wrinkle_shade #(
  parameter GLOSSY      = 1,
  parameter DECAL       = 0,
  parameter GLOSS_MAP   = 0,   // 1: the highlight comes a clock after the rest
  parameter TEXEL_BITS  = 8,   // T
  parameter DOT_BITS    = 10,  // DF
  parameter POWER_BITS  = 12,  // PF
  parameter COLOUR_BITS = 8    // C
) (
  input  wire                   clk,
  input  wire                   advance_i,
  input  wire [COLOUR_BITS:0]   ambient_i,   // draw state, u1.C
  input  wire [COLOUR_BITS:0]   diffuse_colour_i,
  input  wire [COLOUR_BITS:0]   specular_colour_i,
  input  wire [DOT_BITS:0]      diffuse_i,   // u1.DF
  input  wire [(GLOSSY != 0 ? POWER_BITS : 0):0]  specular_i,  // u1.PF
  input  wire [(DECAL != 0 ? TEXEL_BITS : 1)-1:0]   decal_i,     // u0.T
  output wire [COLOUR_BITS-1:0] colour_o
);
  localparam C    = COLOUR_BITS;
  localparam PF   = GLOSSY != 0 ? POWER_BITS : DOT_BITS;
  localparam BASE = C + DOT_BITS + 3;
  localparam SUM  = C + PF + 4;

  // Ambient and diffuse.
  wire [C+DOT_BITS+1:0] lit;
  reg [BASE-1:0]        base1_q;
  wire [BASE-1:0]       base;
  wrinkle_multiply_unsigned #(.A_BITS(C + 1), .B_BITS(DOT_BITS + 1)) multiply_diffuse (
    .a_i(diffuse_colour_i), .b_i(diffuse_i), .product_o(lit));
  always @(posedge clk) if (advance_i) base1_q <= {2'b00, ambient_i, {DOT_BITS{1'b0}}} + {1'b0, lit};

  generate
    if (DECAL != 0) begin : tinted
      reg [TEXEL_BITS:0]          tint_q;  // a full code is one
      reg [BASE-1:0]              base2_q;
      wire [BASE+TEXEL_BITS:0]    product;
      wire [BASE-1:0]             rounded;
      wrinkle_multiply_unsigned #(.A_BITS(BASE), .B_BITS(TEXEL_BITS + 1)) multiply_decal (
        .a_i(base1_q), .b_i(tint_q), .product_o(product));
      wrinkle_round_half_up #(.VALUE_BITS(BASE + TEXEL_BITS + 1), .SHIFT(TEXEL_BITS), .RESULT_BITS(BASE)) round (
        .value_i(product), .result_o(rounded));
      assign base = base2_q;
      always @(posedge clk)
        if (advance_i) begin
          tint_q  <= {1'b0, decal_i} + {{TEXEL_BITS{1'b0}}, decal_i[TEXEL_BITS-1]};
          base2_q <= rounded;
        end
    end else if (GLOSS_MAP != 0) begin : in_step
      reg [BASE-1:0] base2_q;
      wire unused_pins = decal_i;
      assign base = base2_q;
      always @(posedge clk) if (advance_i) base2_q <= base1_q;
    end else begin : plain
      wire unused_pins = decal_i;
      assign base = base1_q;
    end
  endgenerate

  // Specular.
  reg [SUM-1:0] sum_q;
  generate
    if (GLOSSY != 0) begin : glossy
      wire [C+PF+1:0] product, late;
      wrinkle_multiply_unsigned #(.A_BITS(C + 1), .B_BITS(PF + 1)) multiply_specular (
        .a_i(specular_colour_i), .b_i(specular_i), .product_o(product));
      wrinkle_delay #(.WIDTH(C + PF + 2), .RANKS(DECAL != 0 && GLOSS_MAP == 0 ? 2 : 1)) delay (
        .clk(clk), .advance_i(advance_i), .data_i(product), .data_o(late));
      always @(posedge clk)
        if (advance_i) sum_q <= {1'b0, base, {(PF - DOT_BITS){1'b0}}} + {2'b00, late};
    end else begin : matt
      wire unused_pins = &{1'b0, specular_colour_i, specular_i};
      always @(posedge clk) if (advance_i) sum_q <= {1'b0, base};
    end
  endgenerate

  // To the codes of the channel.
  wire [SUM+C-1:0] codes = {sum_q, {C{1'b0}}} - {{C{1'b0}}, sum_q};
  wire [C-1:0]     colour;
  reg [C-1:0]      colour_q;
  wire signed [C+4:0] rounded_codes;
  wrinkle_round_half_up #(.VALUE_BITS(SUM + C + 1), .SHIFT(C + PF), .RESULT_BITS(C + 5)) round_codes (
    .value_i({1'b0, codes}), .result_o(rounded_codes));
  wrinkle_saturate #(.VALUE_BITS(C + 5), .RESULT_BITS(C), .MINIMUM(0), .MAXIMUM((1 << C) - 1)) saturate (
    .value_i(rounded_codes), .result_o(colour));

  assign colour_o = colour_q;

  always @(posedge clk) if (advance_i) colour_q <= colour;
endmodule
`default_nettype wire
