`default_nettype none
// The normal of [Peercy97 fig. 2]: two vector scalings and an addition,
//   N' = saturate(round_half_up((A << GB) - fu B - fv C, GB)) in s2.VW, with fu = fv = 0 where the draw has no bump.
// A = Pu x Pv, B = Pv x N and C = N x Pu. Latency 2. Does not normalize.
module wrinkle_perturb_blinn #(
  parameter FRAME  = 162,
  parameter BUMP   = 20,
  parameter NORMAL = 57,
  parameter CARRY  = 107
) (
  input  wire clk,
  input  wire rst,
  input  wire draw_bump_i,
  input  wire in_valid_i,
  output wire in_ready_o,
  input  wire [(FRAME != 0 ? FRAME : 1)-1:0]   frame_i,  // {C, B, A} in s1.VW, x in the low bits
  input  wire [(BUMP != 0 ? BUMP : 1)-1:0]     bump_i,   // {fv, fu} in s0.GB
  input  wire [CARRY-1:0]                      carry_i,
  output wire out_valid_o,
  input  wire out_ready_i,
  output wire [(NORMAL != 0 ? NORMAL : 1)-1:0] n_o,      // s2.VW
  output wire [CARRY-1:0]                      carry_o,
  output wire busy_o
);
  // Of 32 bits, since Icarus widens what is computed from numbers without a size.
  localparam [31:0] WW   = FRAME / 9;
  localparam [31:0] GRAD = BUMP / 2;

  wire advance;
  wire [GRAD-1:0] fu = draw_bump_i ? bump_i[0 +: GRAD] : {GRAD{1'b0}};
  wire [GRAD-1:0] fv = draw_bump_i ? bump_i[GRAD +: GRAD] : {GRAD{1'b0}};

  wrinkle_pipe #(.RANKS(2)) pipe (
    .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .advance_o(advance), .out_valid_o(out_valid_o),
    .out_ready_i(out_ready_i), .busy_o(busy_o));
  assign in_ready_o = advance;

  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : component
      wrinkle_perturbed #(.WIDE_BITS(WW - 2), .GRADIENT_BITS(GRAD - 1)) perturbed (
        .clk(clk), .advance_i(advance), .a_i(frame_i[k*WW +: WW]), .b_i(frame_i[(3+k)*WW +: WW]),
        .c_i(frame_i[(6+k)*WW +: WW]), .fu_i(fu), .fv_i(fv), .n_o(n_o[k*(WW+1) +: WW+1]));
    end
  endgenerate

  wrinkle_carry #(.BITS(CARRY), .RANKS(2)) carry (
    .clk(clk), .advance_i(advance), .push_i(1'b0), .write_i(1'b0), .read_i(1'b0), .late_advance_i(1'b0),
    .data_i(carry_i), .data_o(carry_o));
endmodule
`default_nettype wire
