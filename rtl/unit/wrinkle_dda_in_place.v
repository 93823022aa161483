`default_nettype none
// One interpolated component whose packet fields are its registers: a digital differential analyser like wrinkle_dda
// without a second set of them, so that the next packet shifts in only after the last pixel of this one. Four
// registers: value at the start of the row, row, dw, and the value at the pixel.
// SHARING 0: an adder for each sum. 1: one adder, and the walk of wrinkle_scan tells at most one of its sums a clock:
// `step` adds row to the row's value, `carry` dw, `pixel` dw to the pixel's value, `span` nothing to the row's value.
// All values modulo 2^(WIDTH + GUARD). Latency 0 from its registers. Does not clamp.
module wrinkle_dda_in_place #(
  parameter WIDTH   = 12,
  parameter GUARD   = 10,
  parameter SHARING = 0
) (
  input  wire                       clk,
  input  wire [3*(WIDTH+GUARD)-1:0] shift_i,   // bits that take those of next_i, never during a walk
  input  wire [3*(WIDTH+GUARD)-1:0] next_i,    // what shifts in: {dw, row, value}
  input  wire                       step_i,    // the walk
  input  wire                       carry_i,
  input  wire                       span_i,
  input  wire                       pixel_i,
  output wire [3*(WIDTH+GUARD)-1:0] fields_o,  // {dw, row, value of the row}
  output wire [WIDTH-1:0]           value_o
);
  localparam BITS = WIDTH + GUARD;

  reg [BITS-1:0]  row_value_q, row_q, dw_q, value_q;
  wire [BITS-1:0] next_row_value, next_value;
  wire            to_row, to_pixel;

  wire unused_guard = &{1'b0, value_q};
  assign value_o  = value_q[BITS-1:GUARD];
  assign fields_o = {dw_q, row_q, row_value_q};

  generate
    if (SHARING != 0) begin : one_adder
      wire [BITS-1:0] from  = pixel_i ? value_q : row_value_q;
      wire [BITS-1:0] delta = ({BITS{step_i}} & row_q) | ({BITS{carry_i | pixel_i}} & dw_q);
      wire [BITS-1:0] sum   = from + delta;
      assign next_row_value = sum;
      assign next_value     = sum;
      assign to_row         = step_i | carry_i;
      assign to_pixel       = span_i | pixel_i;
    end else begin : adders
      assign next_row_value = row_value_q + row_q + (carry_i ? dw_q : {BITS{1'b0}});
      assign next_value     = span_i ? row_value_q : value_q + dw_q;
      assign to_row         = step_i;
      assign to_pixel       = span_i | pixel_i;
    end
  endgenerate

  always @(posedge clk) begin
    if (to_row) row_value_q <= next_row_value;
    if (|shift_i)
      {dw_q, row_q, row_value_q} <= (shift_i & next_i) |
                                    (~shift_i & {dw_q, row_q, to_row ? next_row_value : row_value_q});
    if (to_pixel) value_q <= next_value;
  end
endmodule
`default_nettype wire
