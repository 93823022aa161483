`default_nettype none
// One interpolated component: a digital differential analyser down the start edge and along the row.
// All values modulo 2^(WIDTH + GUARD); the guard bits are dropped at the output, the set-up has added half.
// Latency 0 from its registers; moves only when told by the walk of wrinkle_scan. Does not clamp: outside the triangle
// it may wrap, and is right again inside.
module wrinkle_dda #(
  parameter WIDTH = 12,
  parameter GUARD = 10
) (
  input  wire                   clk,
  input  wire                   load_i,        // next triangle: row registers from the packet
  input  wire                   step_i,        // next row
  input  wire                   carry_i,       // ... of which the start edge moved one pixel more
  input  wire                   span_i,        // pixel register to the start of the row
  input  wire                   first_i,       // ... of the first span of a triangle
  input  wire                   pixel_i,       // pixel register along the row
  input  wire [WIDTH+GUARD-1:0] value_i,       // packet fields
  input  wire [WIDTH+GUARD-1:0] row_i,
  input  wire [WIDTH+GUARD-1:0] dw_i,
  output wire [WIDTH-1:0]       value_o
);
  localparam BITS = WIDTH + GUARD;

  reg [BITS-1:0] row_value_q, row_q, row_dw_q;   // the row engine's
  reg [BITS-1:0] value_q, dw_q;                  // the pixel engine's, which may still be in the triangle before

  wire unused_guard = &{1'b0, value_q};
  assign value_o = value_q[BITS-1:GUARD];

  always @(posedge clk) begin
    if (load_i) begin
      row_value_q <= value_i;
      row_q       <= row_i;
      row_dw_q    <= dw_i;
    end else if (step_i) begin
      row_value_q <= row_value_q + row_q + (carry_i ? row_dw_q : {BITS{1'b0}});
    end
    if (span_i) begin
      value_q <= row_value_q;
      if (first_i) dw_q <= row_dw_q;
    end else if (pixel_i) begin
      value_q <= value_q + dw_q;
    end
  end
endmodule
`default_nettype wire
