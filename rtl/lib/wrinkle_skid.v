`default_nettype none
// Two-entry stream register, control half: cuts valid and ready, so that neither side sees the other's wires within a
// clock. One wrinkle_skid_data a payload word hangs on it (no vector of the pixel path is wider than 64 bits).
// Latency 1, one transfer a clock.
module wrinkle_skid (
  input  wire clk,
  input  wire rst,
  input  wire in_valid_i,
  output wire in_ready_o,
  output wire out_valid_o,
  input  wire out_ready_i,
  output wire load_o,      // the front register takes a word: the spare one's if spare_o, else the incoming one
  output wire spare_o      // the spare register is occupied
);
  reg valid_q, spare_q;

  assign in_ready_o  = ~spare_q;
  assign out_valid_o = valid_q;
  assign load_o      = out_ready_i | ~valid_q;
  assign spare_o     = spare_q;

  always @(posedge clk)
    if (rst) begin
      valid_q <= 1'b0;
      spare_q <= 1'b0;
    end else if (load_o) begin
      valid_q <= spare_q | in_valid_i;
      spare_q <= 1'b0;
    end else begin
      spare_q <= spare_q | in_valid_i;
    end
endmodule
`default_nettype wire
