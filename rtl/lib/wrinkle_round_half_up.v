`default_nettype none
// The one rounding: floor(value / 2^SHIFT + 1/2), kept to RESULT_BITS bits; for SHIFT <= 0 the exact value * 2^-SHIFT.
// Signed. Combinational. Does not saturate: the bits above the result are dropped (wrinkle_saturate keeps them in
// check).
module wrinkle_round_half_up #(
  parameter VALUE_BITS  = 20,
  parameter integer SHIFT = 8,
  parameter RESULT_BITS = 13
) (
  input  wire signed [VALUE_BITS-1:0]  value_i,
  output wire signed [RESULT_BITS-1:0] result_o
);
  // Wide enough for the value, its carry and every bit of the result; always at least one bit of sign extension.
  localparam LEFT  = SHIFT < 0 ? -SHIFT : 0;
  localparam RIGHT = SHIFT > 0 ? SHIFT : 0;
  localparam NEED  = RESULT_BITS + RIGHT;
  localparam WIDE  = (VALUE_BITS + LEFT > NEED ? VALUE_BITS + LEFT : NEED) + 1;

  wire [WIDE-1:0] wide = {{(WIDE - VALUE_BITS){value_i[VALUE_BITS-1]}}, value_i};

  generate
    if (SHIFT > 0) begin : right
      localparam [WIDE-1:0] HALF = {{(WIDE - 1){1'b0}}, 1'b1} << (SHIFT - 1);
      wire [WIDE-1:0] sum = wide + HALF;
      wire unused_bits = &{1'b0, sum};
      assign result_o = sum[RIGHT +: RESULT_BITS];
    end else begin : left
      wire [WIDE-1:0] moved = wide << LEFT;
      wire unused_bits = &{1'b0, moved};
      assign result_o = moved[RESULT_BITS-1:0];
    end
  endgenerate
endmodule
`default_nettype wire
