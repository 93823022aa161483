`default_nettype none
// N, L and H for dot products that are scaled after: each by its own wrinkle_deferred_vector. Latency 4.
module wrinkle_deferred_units #(
  parameter GLOSSY            = 1,   // H is there
  parameter NORMAL_INPUT_BITS = 9,
  parameter VECTOR_BITS       = 9,   // V
  parameter UNIT_BITS         = 9,   // F
  parameter SCALE             = 11,  // bits of a scale
  parameter CARRY             = 36
) (
  input  wire                               clk,
  input  wire                               rst,
  input  wire                               in_valid_i,
  output wire                               in_ready_o,
  input  wire [3*(NORMAL_INPUT_BITS+2)-1:0] n_i,      // s1.NORMAL_INPUT_BITS
  input  wire [3*(VECTOR_BITS+2)-1:0]       l_i,      // s1.V
  input  wire [(GLOSSY != 0 ? 3*(VECTOR_BITS+2) : 1)-1:0] h_i,
  input  wire [CARRY-1:0]                   carry_i,
  output wire                               out_valid_o,
  input  wire                               out_ready_i,
  output wire [3*(UNIT_BITS+1)-1:0]         n_o,      // mantissas, s0.F
  output wire [3*(UNIT_BITS+1)-1:0]         l_o,
  output wire [(GLOSSY != 0 ? 3*(UNIT_BITS+1) : 1)-1:0] h_o,
  output wire [(GLOSSY + 2)*SCALE-1:0]      scale_o,  // u1.RB each, of N in the low bits
  output wire                               zero_o,   // one of them was zero
  output wire [CARRY-1:0]                   carry_o,
  output wire                               busy_o
);
  wire advance, zero_n, zero_l, zero_h;

  assign in_ready_o = advance;
  assign zero_o     = zero_n | zero_l | zero_h;
  wrinkle_pipe #(.RANKS(4)) pipe (
    .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .advance_o(advance), .out_valid_o(out_valid_o),
    .out_ready_i(out_ready_i), .busy_o(busy_o));
  wrinkle_carry #(.BITS(CARRY), .RANKS(4)) carry (
    .clk(clk), .advance_i(advance), .push_i(1'b0), .write_i(1'b0), .read_i(1'b0), .late_advance_i(1'b0),
    .data_i(carry_i), .data_o(carry_o));

  wrinkle_deferred_vector #(.VECTOR_BITS(NORMAL_INPUT_BITS), .UNIT_BITS(UNIT_BITS), .SCALE_BITS(SCALE - 1)) vector_n (
    .clk(clk), .advance_i(advance), .vector_i(n_i), .mantissa_o(n_o), .scale_o(scale_o[0 +: SCALE]), .zero_o(zero_n));
  wrinkle_deferred_vector #(.VECTOR_BITS(VECTOR_BITS), .UNIT_BITS(UNIT_BITS), .SCALE_BITS(SCALE - 1)) vector_l (
    .clk(clk), .advance_i(advance), .vector_i(l_i), .mantissa_o(l_o), .scale_o(scale_o[SCALE +: SCALE]),
    .zero_o(zero_l));
  generate
    if (GLOSSY != 0) begin : glossy
      wrinkle_deferred_vector #(.VECTOR_BITS(VECTOR_BITS), .UNIT_BITS(UNIT_BITS), .SCALE_BITS(SCALE - 1)) vector_h (
        .clk(clk), .advance_i(advance), .vector_i(h_i), .mantissa_o(h_o), .scale_o(scale_o[2*SCALE +: SCALE]),
        .zero_o(zero_h));
    end else begin : diffuse
      wire unused_h = h_i;
      assign h_o    = 1'b0;
      assign zero_h = 1'b0;
    end
  endgenerate
endmodule
`default_nettype wire
