`default_nettype none
// A packet field that is held over a triangle: it has the same value at every pixel. BUFFERING double: the field is
// copied from the shadow to the row engine when that takes the packet, and to the pixel engine with the packet's first
// row, since the pixel engine may still draw the triangle before. single: the field's part of the packet is its
// register, and stays until the last pixel. Latency 0 from its registers.
module wrinkle_held #(
  parameter WIDTH     = 9,
  parameter BUFFERING = 0
) (
  input  wire             clk,
  input  wire             load_i,    // the row engine takes the packet
  input  wire             take_i,    // the pixel engine takes its first row
  input  wire [WIDTH-1:0] shadow_i,  // double: this part of the shadow
  input  wire [WIDTH-1:0] shift_i,   // single: which bits of it take those of next_i
  input  wire [WIDTH-1:0] next_i,
  output wire [WIDTH-1:0] fields_o,  // ... and what is there; double: 0
  output wire [WIDTH-1:0] value_o
);
  reg [WIDTH-1:0] value_q;
  assign value_o = value_q;

  generate
    if (BUFFERING != 0) begin : single
      wire unused_pins = &{1'b0, load_i, take_i, shadow_i};
      assign fields_o = value_q;
      always @(posedge clk) value_q <= (shift_i & next_i) | (~shift_i & value_q);
    end else begin : double
      reg [WIDTH-1:0] row_value_q;
      wire unused_pins = &{1'b0, shift_i, next_i};
      assign fields_o = {WIDTH{1'b0}};
      always @(posedge clk) begin
        if (load_i) row_value_q <= shadow_i;
        if (take_i) value_q <= row_value_q;
      end
    end
  endgenerate
endmodule
`default_nettype wire
