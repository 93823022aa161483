`default_nettype none
// N, L and H to unit length, each by its own unit. Constant light vectors come from the draw state, and where N' has
// no bits it is (0, 0, 1): neither has a unit. With LIGHTING pixel_halfangle H is made here, from the unit vectors L and E,
// and has a unit of its own behind theirs. Latency 5, or 1 when no vector has a normalizer; pixel_halfangle adds 6.
module wrinkle_separate_units #(
  parameter NORMAL            = 33,  // bits of N'; 0: it is (0, 0, 1)
  parameter NORMAL_INPUT_BITS = 9,
  parameter L_VECTOR          = 33,  // bits of L, and of H or E; 0: constants of the draw
  parameter LIGHTING          = 1,
  parameter NORMALIZER_N      = 1,
  parameter NORMALIZER_L      = 1,
  parameter NORMALIZER_H      = 1,
  parameter VECTOR_BITS       = 9,   // V
  parameter UNIT_BITS         = 9,   // F
  parameter CARRY             = 36
) (
  input  wire                clk,
  input  wire                rst,
  input  wire [(L_VECTOR != 0 ? 1 : 3*(UNIT_BITS+2))-1:0]                  draw_l_i,  // s1.F
  input  wire [(L_VECTOR != 0 || LIGHTING == 0 ? 1 : 3*(UNIT_BITS+2))-1:0] draw_h_i,  // s1.F, H or E
  input  wire                in_valid_i,
  output wire                in_ready_o,
  input  wire [(NORMAL != 0 ? NORMAL : 1)-1:0]                      n_i,  // s1.NORMAL_INPUT_BITS
  input  wire [(L_VECTOR != 0 ? L_VECTOR : 1)-1:0]                  l_i,  // s1.V
  input  wire [(L_VECTOR != 0 && LIGHTING != 0 ? L_VECTOR : 1)-1:0] h_i,  // s1.V; E where H is made here
  input  wire [CARRY-1:0]    carry_i,
  output wire                out_valid_o,
  input  wire                out_ready_i,
  output wire [3*(UNIT_BITS+2)-1:0]                       n_o,  // s1.F
  output wire [3*(UNIT_BITS+2)-1:0]                       l_o,
  output wire [(LIGHTING != 0 ? 3*(UNIT_BITS+2) : 1)-1:0] h_o,
  output wire                zero_o,  // one of them was zero
  output wire [CARRY-1:0]    carry_o,
  output wire                busy_o
);
  localparam UNIT      = 3 * (UNIT_BITS + 2);
  localparam HAS_N     = NORMAL != 0 ? 1 : 0;
  localparam HAS_LIGHT = L_VECTOR != 0 ? 1 : 0;
  localparam HAS_H     = LIGHTING != 0 ? HAS_LIGHT : 0;
  localparam LATE_H    = LIGHTING == 3 ? 1 : 0;                         // H is made of L and E
  localparam KIND_H    = LATE_H != 0 ? NORMALIZER_L : NORMALIZER_H;     // of what h_i brings
  localparam FIRST     = (HAS_N != 0 && NORMALIZER_N != 0) || (HAS_LIGHT != 0 && NORMALIZER_L != 0) ||
                         (HAS_H != 0 && KIND_H != 0) ? 5 : 1;
  localparam SECOND    = LATE_H != 0 ? 6 : 0;                           // the sum, and its normalizer
  localparam RANKS     = FIRST + SECOND;

  wire advance, zero_n, zero_l, zero_h;
  wire [UNIT-1:0] l;  // after the first normalizers

  wrinkle_pipe #(.RANKS(RANKS)) pipe (
    .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .advance_o(advance), .out_valid_o(out_valid_o),
    .out_ready_i(out_ready_i), .busy_o(busy_o));
  assign in_ready_o = advance;
  wrinkle_delay #(.WIDTH(1), .RANKS(SECOND)) delay_zero (
    .clk(clk), .advance_i(advance), .data_i(zero_n | zero_l | zero_h), .data_o(zero_o));

  generate
    if (HAS_N != 0) begin : with_n
      wire [UNIT-1:0] n;
      wrinkle_unit_vector #(
        .NORMALIZER(NORMALIZER_N), .VECTOR_BITS(NORMAL_INPUT_BITS), .UNIT_BITS(UNIT_BITS), .RANKS(FIRST)
      ) unit_n (.clk(clk), .advance_i(advance), .vector_i(n_i), .unit_o(n), .zero_o(zero_n));
      wrinkle_delay #(.WIDTH(UNIT), .RANKS(SECOND)) delay_n (
        .clk(clk), .advance_i(advance), .data_i(n), .data_o(n_o));
    end else begin : without_n
      wire unused_pins = n_i;
      assign n_o    = {2'b01, {(UNIT - 2){1'b0}}};
      assign zero_n = 1'b0;
    end

    if (HAS_LIGHT != 0) begin : with_l
      wire unused_draw = &{1'b0, draw_l_i, draw_h_i};
      wrinkle_unit_vector #(
        .NORMALIZER(NORMALIZER_L), .VECTOR_BITS(VECTOR_BITS), .UNIT_BITS(UNIT_BITS), .RANKS(FIRST)
      ) unit_l (.clk(clk), .advance_i(advance), .vector_i(l_i), .unit_o(l), .zero_o(zero_l));
      wrinkle_delay #(.WIDTH(UNIT), .RANKS(SECOND)) delay_l (
        .clk(clk), .advance_i(advance), .data_i(l), .data_o(l_o));
    end else begin : constant_l
      wire unused_pins = &{1'b0, l_i, h_i};
      assign l      = draw_l_i;
      assign l_o    = l;
      assign zero_l = 1'b0;
    end

    if (LIGHTING != 0) begin : glossy
      wire [UNIT-1:0] h;
      if (HAS_H != 0) begin : with_h
        wrinkle_unit_vector #(
          .NORMALIZER(KIND_H), .VECTOR_BITS(VECTOR_BITS), .UNIT_BITS(UNIT_BITS), .RANKS(FIRST)
        ) unit_h (.clk(clk), .advance_i(advance), .vector_i(h_i), .unit_o(h), .zero_o(zero_h));
      end else begin : constant_h
        assign h      = draw_h_i;
        assign zero_h = 1'b0;
      end
      if (LATE_H != 0) begin : late
        wrinkle_halfangle #(.NORMALIZER(NORMALIZER_H), .UNIT_BITS(UNIT_BITS)) halfangle (
          .clk(clk), .advance_i(advance), .l_i(l), .e_i(h), .h_o(h_o));
      end else begin : at_once
        assign h_o = h;
      end
    end else begin : diffuse
      wire unused_h = &{1'b0, h_i, draw_h_i};
      assign h_o    = 1'b0;
      assign zero_h = 1'b0;
    end
  endgenerate

  wrinkle_carry #(.BITS(CARRY), .RANKS(RANKS)) carry (
    .clk(clk), .advance_i(advance), .push_i(1'b0), .write_i(1'b0), .read_i(1'b0), .late_advance_i(1'b0),
    .data_i(carry_i), .data_o(carry_o));
endmodule
`default_nettype wire
