`default_nettype none
// The normal of a rotated frame [Kuijk and Blake 1989]: it is (0, 0, 1), so that there is nothing to compute. A wire.
module wrinkle_perturb_rotated #(
  parameter FRAME  = 0,
  parameter BUMP   = 0,
  parameter NORMAL = 0,
  parameter CARRY  = 107
) (
  input  wire clk,
  input  wire rst,
  input  wire draw_bump_i,
  input  wire in_valid_i,
  output wire in_ready_o,
  input  wire [(FRAME != 0 ? FRAME : 1)-1:0]   frame_i,  // none
  input  wire [(BUMP != 0 ? BUMP : 1)-1:0]     bump_i,   // none
  input  wire [CARRY-1:0]                      carry_i,
  output wire out_valid_o,
  input  wire out_ready_i,
  output wire [(NORMAL != 0 ? NORMAL : 1)-1:0] n_o,      // none
  output wire [CARRY-1:0]                      carry_o,
  output wire busy_o
);
  wire unused_pins = &{1'b0, clk, rst, draw_bump_i, frame_i, bump_i};

  assign in_ready_o  = out_ready_i;
  assign out_valid_o = in_valid_i;
  assign n_o         = 1'b0;
  assign carry_o     = carry_i;
  assign busy_o      = 1'b0;
endmodule
`default_nettype wire
