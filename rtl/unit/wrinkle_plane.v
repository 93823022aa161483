`default_nettype none
// One interpolated component with its part of the packet, whose words shift past: {dw, row, value} from bit 0.
// BUFFERING double: the part is a shadow, from which a wrinkle_dda loads; single: the part is the interpolator itself,
// a wrinkle_dda_in_place, with one adder where SHARING leaves it a clock for each sum. Latency and modulus of those.
module wrinkle_plane #(
  parameter WIDTH     = 12,
  parameter GUARD     = 10,
  parameter SHARING   = 0,
  parameter BUFFERING = 0
) (
  input  wire                       clk,
  input  wire                       load_i,    // the walk: see wrinkle_dda
  input  wire                       step_i,
  input  wire                       carry_i,
  input  wire                       span_i,
  input  wire                       first_i,
  input  wire                       pixel_i,
  input  wire [3*(WIDTH+GUARD)-1:0] shadow_i,  // double: this part of the shadow
  input  wire [3*(WIDTH+GUARD)-1:0] shift_i,   // single: which bits of it take those of next_i
  input  wire [3*(WIDTH+GUARD)-1:0] next_i,
  output wire [3*(WIDTH+GUARD)-1:0] fields_o,  // ... and what is there; double: 0
  output wire [WIDTH-1:0]           value_o
);
  localparam BITS = WIDTH + GUARD;

  generate
    if (BUFFERING != 0) begin : single
      wire unused_pins = &{1'b0, load_i, first_i, shadow_i};
      wrinkle_dda_in_place #(.WIDTH(WIDTH), .GUARD(GUARD), .SHARING(SHARING)) dda (
        .clk(clk), .shift_i(shift_i), .next_i(next_i), .step_i(step_i), .carry_i(carry_i), .span_i(span_i),
        .pixel_i(pixel_i), .fields_o(fields_o), .value_o(value_o));
    end else begin : double
      wire unused_pins = &{1'b0, shift_i, next_i};
      assign fields_o = {3*BITS{1'b0}};
      wrinkle_dda #(.WIDTH(WIDTH), .GUARD(GUARD)) dda (
        .clk(clk), .load_i(load_i), .step_i(step_i), .carry_i(carry_i), .span_i(span_i), .first_i(first_i),
        .pixel_i(pixel_i), .value_i(shadow_i[0 +: BITS]), .row_i(shadow_i[BITS +: BITS]),
        .dw_i(shadow_i[2*BITS +: BITS]), .value_o(value_o));
    end
  endgenerate
endmodule
`default_nettype wire
