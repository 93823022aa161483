`default_nettype none
// N, L and H to unit length; `zero` tells that one of them had no length. Of three ways one is there: each vector has its
// own unit (wrinkle_separate_units), with SHARING on all take turns in one (wrinkle_shared_units, a fragment in three
// clocks), with NORMALIZE_ORDER after `light` does the scaling, and n, l, h are mantissas, each with its scale
// (wrinkle_deferred_units). Latency is theirs.
module wrinkle_normalize #(
  parameter LIGHTING          = 1,
  parameter NORMALIZER_N      = 1,
  parameter NORMALIZER_L      = 1,
  parameter NORMALIZER_H      = 1,
  parameter NORMALIZE_ORDER   = 0,
  parameter SHARING           = 0,
  parameter NORMAL            = 33,  // bits of N'; 0: it is (0, 0, 1)
  parameter NORMAL_INPUT_BITS = 9,   // its fraction bits for a normalizer
  parameter L_VECTOR          = 33,  // bits of L, and of H or E; 0: constants of the draw
  parameter VECTOR_BITS       = 9,   // V
  parameter UNIT_BITS         = 9,   // F
  parameter UNIT              = 33,  // bits of a vector that is handed on
  parameter SCALE             = 11,  // bits of a scale
  parameter SCALES            = 0,   // ... of all of them; 0: none
  parameter CARRY             = 41
) (
  input  wire clk,
  input  wire rst,
  input  wire [(L_VECTOR != 0 ? 1 : UNIT)-1:0]                  draw_l_i,  // s1.F
  input  wire [(L_VECTOR != 0 || LIGHTING == 0 ? 1 : UNIT)-1:0] draw_h_i,  // s1.F, H or E
  input  wire in_valid_i,
  output wire in_ready_o,
  input  wire [(NORMAL != 0 ? NORMAL : 1)-1:0]                     n_i,    // s1.NORMAL_INPUT_BITS
  input  wire [(L_VECTOR != 0 ? L_VECTOR : 1)-1:0]                 l_i,    // s1.V
  input  wire [(L_VECTOR != 0 && LIGHTING != 0 ? L_VECTOR : 1)-1:0] h_i,   // s1.V; E where H is made here
  input  wire [CARRY-1:0]                     carry_i,
  output wire out_valid_o,
  input  wire out_ready_i,
  output wire [UNIT-1:0]                      n_o,      // s1.F, a mantissa s0.F
  output wire [UNIT-1:0]                      l_o,
  output wire [(LIGHTING != 0 ? UNIT : 1)-1:0] h_o,
  output wire [(SCALES != 0 ? SCALES : 1)-1:0] scale_o, // u1.RB each, of N in the low bits
  output wire                                 zero_o,
  output wire                                 ahead_o,  // SHARING: see wrinkle_shared_units; else 0
  output wire [CARRY-1:0]                     carry_o,
  output wire busy_o
);
  wire unused_pins = &{1'b0, draw_l_i, draw_h_i};

  generate
    if (SCALES == 0) begin : before
      assign scale_o = 1'b0;
    end

    if (SHARING == 0) begin : at_once
      assign ahead_o = 1'b0;
    end

    if (SHARING != 0) begin : shared
      wrinkle_shared_units #(
        .NORMALIZER(NORMALIZER_N), .VECTOR_BITS(VECTOR_BITS), .UNIT_BITS(UNIT_BITS), .CARRY(CARRY)
      ) units (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .in_ready_o(in_ready_o), .n_i(n_i), .l_i(l_i), .h_i(h_i),
        .carry_i(carry_i), .out_valid_o(out_valid_o), .out_ready_i(out_ready_i), .n_o(n_o), .l_o(l_o), .h_o(h_o),
        .zero_o(zero_o), .ahead_o(ahead_o), .carry_o(carry_o), .busy_o(busy_o));
    end else if (NORMALIZE_ORDER != 0) begin : deferred
      wrinkle_deferred_units #(
        .GLOSSY(LIGHTING != 0 ? 1 : 0), .NORMAL_INPUT_BITS(NORMAL_INPUT_BITS), .VECTOR_BITS(VECTOR_BITS),
        .UNIT_BITS(UNIT_BITS), .SCALE(SCALE), .CARRY(CARRY)
      ) units (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .in_ready_o(in_ready_o), .n_i(n_i), .l_i(l_i), .h_i(h_i),
        .carry_i(carry_i), .out_valid_o(out_valid_o), .out_ready_i(out_ready_i), .n_o(n_o), .l_o(l_o), .h_o(h_o),
        .scale_o(scale_o), .zero_o(zero_o), .carry_o(carry_o), .busy_o(busy_o));
    end else begin : separate
      wrinkle_separate_units #(
        .NORMAL(NORMAL), .NORMAL_INPUT_BITS(NORMAL_INPUT_BITS), .L_VECTOR(L_VECTOR), .LIGHTING(LIGHTING),
        .NORMALIZER_N(NORMALIZER_N), .NORMALIZER_L(NORMALIZER_L), .NORMALIZER_H(NORMALIZER_H),
        .VECTOR_BITS(VECTOR_BITS), .UNIT_BITS(UNIT_BITS), .CARRY(CARRY)
      ) units (
        .clk(clk), .rst(rst), .draw_l_i(draw_l_i), .draw_h_i(draw_h_i), .in_valid_i(in_valid_i),
        .in_ready_o(in_ready_o), .n_i(n_i), .l_i(l_i), .h_i(h_i), .carry_i(carry_i), .out_valid_o(out_valid_o),
        .out_ready_i(out_ready_i), .n_o(n_o), .l_o(l_o), .h_o(h_o), .zero_o(zero_o), .carry_o(carry_o),
        .busy_o(busy_o));
    end
  endgenerate
endmodule
`default_nettype wire
