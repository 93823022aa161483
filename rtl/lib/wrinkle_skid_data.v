`default_nettype none
// Two-entry stream register, one payload word. Steered by wrinkle_skid; knows no handshake itself.
module wrinkle_skid_data #(
  parameter WIDTH = 64
) (
  input  wire             clk,
  input  wire             load_i,
  input  wire             spare_i,
  input  wire [WIDTH-1:0] data_i,
  output wire [WIDTH-1:0] data_o
);
  reg [WIDTH-1:0] front_q, spare_q;

  assign data_o = front_q;

  always @(posedge clk) begin
    if (load_i) front_q <= spare_i ? spare_q : data_i;
    if (!spare_i) spare_q <= data_i;
  end
endmodule
`default_nettype wire
