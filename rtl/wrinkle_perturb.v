`default_nettype none
// The multiplexer of [Peercy97 fig. 3]: the texture's normal where the draw says so, else the interpolated one.
// Latency 0. With DATAPATH phong [Peercy97 fig. 1], a wire. Does not normalize.
module wrinkle_perturb #(
  parameter DATAPATH    = 1,
  parameter VECTOR_BITS = 9
) (
  input  wire draw_bump_i,
  input  wire in_valid_i,
  output wire in_ready_o,
  input  wire [3*(VECTOR_BITS+2)-1:0]                       smooth_n_i,   // s1.V, interpolated
  input  wire [(DATAPATH != 0 ? 3*(VECTOR_BITS+2) : 1)-1:0] texture_n_i,  // s1.V
  output wire out_valid_o,
  input  wire out_ready_i,
  output wire [3*(VECTOR_BITS+2)-1:0]                       n_o           // s1.V
);
  assign in_ready_o  = out_ready_i;
  assign out_valid_o = in_valid_i;

  generate
    if (DATAPATH != 0) begin : fig3
      assign n_o = draw_bump_i ? texture_n_i : smooth_n_i;
    end else begin : fig1
      wire unused_pins = &{1'b0, draw_bump_i, texture_n_i};
      assign n_o = smooth_n_i;
    end
  endgenerate
endmodule
`default_nettype wire
