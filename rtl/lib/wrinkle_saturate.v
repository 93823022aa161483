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
  localparam FITS = VALUE_BITS > RESULT_BITS && VALUE_BITS <= 32 ? 1 : 0;  // the bounds do the value's width
  localparam WIDE = FITS != 0 ? VALUE_BITS : VALUE_BITS > 32 ? VALUE_BITS + 1 : 33;

  wire signed [WIDE-1:0] value, low, high;

  generate
    if (FITS != 0) begin : as_it_is
      assign value = value_i;
      assign low   = LOW[WIDE-1:0];
      assign high  = HIGH[WIDE-1:0];
    end else begin : extended
      assign value = {{(WIDE - VALUE_BITS){value_i[VALUE_BITS-1]}}, value_i};
      assign low   = {{(WIDE - 32){LOW[31]}}, LOW};
      assign high  = {{(WIDE - 32){HIGH[31]}}, HIGH};
    end
  endgenerate

  assign result_o = value < low ? LOW[RESULT_BITS-1:0] : value > high ? HIGH[RESULT_BITS-1:0] : value[RESULT_BITS-1:0];
endmodule
`default_nettype wire
