`default_nettype none
// Takes along what a stage does not use: BITS that come out with the fragment they came in with. The stage does not
// know what they are, and this unit alone decides how they are kept. Today that is RANKS registers steered by `advance_i`;
// where BUFFER_BITS is not 0 a buffer of 2^BUFFER_BITS entries behind them, steered by a wrinkle_fifo; and LATE_RANKS
// registers behind that, steered by `late_advance_i`. RANKS = 0 with no buffer is a wire. Latency is theirs. The bits are
// kept in words of at most 64, which simulate faster than one wide vector.
module wrinkle_carry #(
  parameter BITS        = 36,
  parameter RANKS       = 2,
  parameter BUFFER_BITS = 0,
  parameter LATE_RANKS  = 0
) (
  input  wire                                           clk,
  input  wire                                           advance_i,
  input  wire                                           push_i,          // 0 without a buffer
  input  wire [(BUFFER_BITS > 0 ? BUFFER_BITS : 1)-1:0] write_i,
  input  wire [(BUFFER_BITS > 0 ? BUFFER_BITS : 1)-1:0] read_i,
  input  wire                                           late_advance_i,  // 0 without late ranks
  input  wire [BITS-1:0]                                data_i,
  output wire [BITS-1:0]                                data_o
);
  localparam WORDS = (BITS + 63) / 64;

  genvar k;
  generate
    for (k = 0; k < WORDS; k = k + 1) begin : word
      localparam WIDTH = k == WORDS - 1 ? BITS - 64 * k : 64;
      wire [WIDTH-1:0] early, buffered;
      wrinkle_delay #(.WIDTH(WIDTH), .RANKS(RANKS)) ranks (
        .clk(clk), .advance_i(advance_i), .data_i(data_i[64*k +: WIDTH]), .data_o(early));
      if (BUFFER_BITS > 0) begin : with_buffer
        wrinkle_fifo_memory #(.ADDRESS_BITS(BUFFER_BITS), .WIDTH(WIDTH)) memory (
          .clk(clk), .push_i(push_i), .write_i(write_i), .read_i(read_i), .data_i(early), .data_o(buffered));
      end else begin : without_buffer
        wire unused_pins = &{1'b0, push_i, write_i, read_i};
        assign buffered = early;
      end
      wrinkle_delay #(.WIDTH(WIDTH), .RANKS(LATE_RANKS)) late_ranks (
        .clk(clk), .advance_i(late_advance_i), .data_i(buffered), .data_o(data_o[64*k +: WIDTH]));
    end
  endgenerate
endmodule
`default_nettype wire
