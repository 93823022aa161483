`default_nettype none
// Packet fields that hold over a triangle. BUFFERING double: they follow the row engine and the pixel engine like a
// gradient, latency 0 from registers of their own; single: the field itself, which stays until the last pixel.
module wrinkle_held #(
  parameter WIDTH     = 9,
  parameter BUFFERING = 0
) (
  input  wire             clk,
  input  wire             load_i,   // the row engine takes the packet
  input  wire             take_i,   // the pixel engine takes its first row
  input  wire [WIDTH-1:0] field_i,
  output wire [WIDTH-1:0] value_o
);
  generate
    if (BUFFERING != 0) begin : single
      wire unused_pins = &{1'b0, clk, load_i, take_i};
      assign value_o = field_i;
    end else begin : double
      reg [WIDTH-1:0] row_value_q, value_q;
      assign value_o = value_q;
      always @(posedge clk) begin
        if (load_i) row_value_q <= field_i;
        if (take_i) value_q <= row_value_q;
      end
    end
  endgenerate
endmodule
`default_nettype wire
