`default_nettype none
// wrinkle_normalizer without its registers, a port for each component: what its combinational area is measured on.
module normalizer_pins #(
  parameter KIND        = 1,
  parameter VECTOR_BITS = 8,
  parameter UNIT_BITS   = 8
) (
  input  wire [3*(VECTOR_BITS+2)-1:0] vector_i,
  output wire [UNIT_BITS+1:0]         x_o,
  output wire [UNIT_BITS+1:0]         y_o,
  output wire [UNIT_BITS+1:0]         z_o,
  output wire                         zero_o
);
  wrinkle_normalizer #(.KIND(KIND), .VECTOR_BITS(VECTOR_BITS), .UNIT_BITS(UNIT_BITS), .PIPELINED(0)) normalizer (
    .clk(1'b0), .advance_i(1'b1), .vector_i(vector_i), .unit_o({z_o, y_o, x_o}), .zero_o(zero_o));
endmodule
`default_nettype wire
