`default_nettype none
// The one saturation: clamps a signed value to [MINIMUM, MAXIMUM]; the bounds fit RESULT_BITS bits. Combinational.
module wrinkle_saturate #(
  parameter VALUE_BITS  = 20,
  parameter RESULT_BITS = 13,
  parameter MINIMUM     = 0,
  parameter MAXIMUM     = 4096
) (
  input  wire signed [VALUE_BITS-1:0]  value_i,
  output wire        [RESULT_BITS-1:0] result_o
);
  localparam signed [31:0] LOW  = MINIMUM;
  localparam signed [31:0] HIGH = MAXIMUM;
  localparam WIDE = VALUE_BITS > 32 ? VALUE_BITS + 1 : 33;

  wire signed [WIDE-1:0] value = {{(WIDE - VALUE_BITS){value_i[VALUE_BITS-1]}}, value_i};
  wire signed [WIDE-1:0] low   = {{(WIDE - 32){LOW[31]}}, LOW};
  wire signed [WIDE-1:0] high  = {{(WIDE - 32){HIGH[31]}}, HIGH};

  assign result_o = value < low ? LOW[RESULT_BITS-1:0] : value > high ? HIGH[RESULT_BITS-1:0] : value[RESULT_BITS-1:0];
endmodule
`default_nettype wire
