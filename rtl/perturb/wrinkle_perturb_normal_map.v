`default_nettype none
// The multiplexer of [Peercy97 fig. 3]: the normal of the texture where the draw has a bump map, else the interpolated N.
// Latency 0.
module wrinkle_perturb_normal_map #(
  parameter FRAME  = 33,
  parameter BUMP   = 33,
  parameter NORMAL = 33,
  parameter CARRY  = 107
) (
  input  wire clk,
  input  wire rst,
  input  wire draw_bump_i,
  input  wire in_valid_i,
  output wire in_ready_o,
  input  wire [(FRAME != 0 ? FRAME : 1)-1:0]   frame_i,  // N in s1.V, x in the low bits
  input  wire [(BUMP != 0 ? BUMP : 1)-1:0]     bump_i,   // N of the texture in s1.V
  input  wire [CARRY-1:0]                      carry_i,
  output wire out_valid_o,
  input  wire out_ready_i,
  output wire [(NORMAL != 0 ? NORMAL : 1)-1:0] n_o,      // s1.V
  output wire [CARRY-1:0]                      carry_o,
  output wire busy_o
);
  wire unused_pins = &{1'b0, clk, rst};

  assign in_ready_o  = out_ready_i;
  assign out_valid_o = in_valid_i;
  assign n_o         = draw_bump_i ? bump_i : frame_i;
  assign carry_o     = carry_i;
  assign busy_o      = 1'b0;
endmodule
`default_nettype wire
