`default_nettype none
// The normal of an offset vector map: N' = N + (Dx, Dy, 0), saturated to s1.V, with D = 0 where the draw has no bump.
// Latency 1.
module wrinkle_perturb_offset #(
  parameter FRAME  = 33,
  parameter BUMP   = 20,
  parameter NORMAL = 33,
  parameter CARRY  = 107
) (
  input  wire clk,
  input  wire rst,
  input  wire draw_bump_i,
  input  wire in_valid_i,
  output wire in_ready_o,
  input  wire [(FRAME != 0 ? FRAME : 1)-1:0]   frame_i,  // N in s1.V, x in the low bits
  input  wire [(BUMP != 0 ? BUMP : 1)-1:0]     bump_i,   // {Dy, Dx} in s0.V
  input  wire [CARRY-1:0]                      carry_i,
  output wire out_valid_o,
  input  wire out_ready_i,
  output wire [(NORMAL != 0 ? NORMAL : 1)-1:0] n_o,      // s1.V
  output wire [CARRY-1:0]                      carry_o,
  output wire busy_o
);
  // Of 32 bits, since Icarus widens what is computed from numbers without a size.
  localparam [31:0] W     = FRAME / 3;
  localparam [31:0] D     = BUMP / 2;
  localparam [31:0] LIMIT = 32'd1 << (W - 32'd1);

  wire advance;
  wire [NORMAL-1:0] n;
  reg [NORMAL-1:0]  n_q;

  wrinkle_pipe #(.RANKS(1)) pipe (
    .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .advance_o(advance), .out_valid_o(out_valid_o),
    .out_ready_i(out_ready_i), .busy_o(busy_o));
  assign in_ready_o = advance;

  genvar k;
  generate
    for (k = 0; k < 2; k = k + 1) begin : component
      wire [D-1:0]      d   = draw_bump_i ? bump_i[k*D +: D] : {D{1'b0}};
      wire signed [W:0] sum = {frame_i[(k+1)*W-1], frame_i[k*W +: W]} + {{(W + 1 - D){d[D-1]}}, d};
      wrinkle_saturate #(.VALUE_BITS(FRAME/3 + 1), .RESULT_BITS(FRAME/3), .MINIMUM(-LIMIT), .MAXIMUM(LIMIT - 1)) s1v (
        .value_i(sum), .result_o(n[k*W +: W]));
    end
  endgenerate
  assign n[2*W +: W] = frame_i[2*W +: W];

  always @(posedge clk)
    if (advance) n_q <= n;
  assign n_o = n_q;

  wrinkle_carry #(.BITS(CARRY), .RANKS(1)) carry (
    .clk(clk), .advance_i(advance), .push_i(1'b0), .write_i(1'b0), .read_i(1'b0), .late_advance_i(1'b0),
    .data_i(carry_i), .data_o(carry_o));
endmodule
`default_nettype wire
