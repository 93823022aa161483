`default_nettype none
// The light stage with one dot product in turn: N.H as soon as `ahead_i` says that n_i and h_i stand, N.L in the clock
// after, in which the fragment is valid and taken, and the power by SQUARERS = ceil(K/3) squarers in a row, used up to
// three times. A fragment in three clocks. Latency 2 from the transfer; 3 with SELF_SHADOW, or where the squarers are
// used a third time.
module wrinkle_shared_light #(
  parameter SURFACE_IS_Z       = 1,
  parameter SELF_SHADOW        = 1,
  parameter UNIT_BITS          = 9,   // F
  parameter DOT_BITS           = 10,  // DF
  parameter POWER_BITS         = 12,  // PF
  parameter SPECULAR_SQUARINGS = 5,   // K
  parameter CARRY              = 37
) (
  input  wire                       clk,
  input  wire                       rst,
  input  wire                       draw_bump_i,
  input  wire                       draw_shadow_i,
  input  wire                       draw_exponent_zero_i,
  input  wire [3:0]                 draw_squarings_i,
  input  wire                       in_valid_i,
  input  wire                       ahead_i,     // n_i and h_i stand, and the fragment is valid from the next clock
  output wire                       in_ready_o,
  input  wire [3*(UNIT_BITS+2)-1:0] n_i,         // s1.F
  input  wire [3*(UNIT_BITS+2)-1:0] l_i,
  input  wire [3*(UNIT_BITS+2)-1:0] h_i,
  input  wire [CARRY-1:0]           carry_i,
  output wire                       out_valid_o,
  input  wire                       out_ready_i,
  output wire [DOT_BITS:0]          nl_o,        // u1.DF
  output wire [DOT_BITS:0]          nh_o,        // u1.DF
  output wire [DOT_BITS:0]          diffuse_o,   // u1.DF
  output wire [POWER_BITS:0]        specular_o,  // u1.PF
  output wire [CARRY-1:0]           carry_o,
  output wire                       busy_o
);
  localparam W        = UNIT_BITS + 2;
  localparam SHIFT    = 2 * UNIT_BITS - DOT_BITS;
  localparam SUM      = 2 * W + 2;
  localparam ROUNDED  = SUM - SHIFT + 1;
  localparam K        = SPECULAR_SQUARINGS;
  localparam SQUARERS = (K + 2) / 3;
  localparam [31:0] ONCE  = SQUARERS;
  localparam [31:0] TWICE = 2 * SQUARERS;
  localparam THIRD    = K > 2 * SQUARERS ? 1 : 0;
  localparam LATE     = SELF_SHADOW != 0 || THIRD != 0 ? 1 : 0;  // a rank more, at the output

  wire unused_valid = in_valid_i;  // in the second clock it always is

  // A fragment stands at the input; it is in its second clock, in its third, or done but for the rank at the output.
  reg  second_q, third_q, done_q;
  wire done_taken;
  wire first = ~second_q & ~third_q & (~done_q | done_taken);
  assign in_ready_o = second_q;
  always @(posedge clk)
    if (rst) {second_q, third_q, done_q} <= 3'b000;
    else {second_q, third_q, done_q} <= {first & ahead_i, second_q, third_q | (done_q & ~done_taken)};

  // The dot product in turn, as in wrinkle_clamped_dot.
  wire [3*W-1:0]            other = second_q ? l_i : h_i;
  wire signed [2*W-1:0]     x, y, z;
  wire signed [SUM-1:0]     sum = {{2{x[2*W-1]}}, x} + {{2{y[2*W-1]}}, y} + {{2{z[2*W-1]}}, z};
  wire signed [ROUNDED-1:0] rounded;
  wire [DOT_BITS:0]         dot;

  wrinkle_multiply #(.A_BITS(W), .B_BITS(W)) multiply_x (.a_i(n_i[0 +: W]), .b_i(other[0 +: W]), .product_o(x));
  wrinkle_multiply #(.A_BITS(W), .B_BITS(W)) multiply_y (.a_i(n_i[W +: W]), .b_i(other[W +: W]), .product_o(y));
  wrinkle_multiply #(.A_BITS(W), .B_BITS(W)) multiply_z (.a_i(n_i[2*W +: W]), .b_i(other[2*W +: W]), .product_o(z));
  wrinkle_round_half_up #(.VALUE_BITS(SUM), .SHIFT(SHIFT), .RESULT_BITS(ROUNDED)) round (
    .value_i(sum), .result_o(rounded));
  wrinkle_saturate #(
    .VALUE_BITS(ROUNDED), .RESULT_BITS(DOT_BITS + 1), .MINIMUM(0), .MAXIMUM(1 << DOT_BITS)
  ) saturate (.value_i(rounded), .result_o(dot));

  // The power: squarings 0 to SQUARERS - 1 in the second clock, as many more in the third, the rest at the output.
  reg [POWER_BITS:0]  power_q;
  wire [POWER_BITS:0] power;
  wire [3:0]          done_before = second_q ? 4'd0 : third_q | THIRD == 0 ? ONCE[3:0] : TWICE[3:0];
  genvar k;
  generate
    for (k = 0; k < SQUARERS; k = k + 1) begin : squarer
      wire [POWER_BITS:0] p, squared, result;
      if (k == 0) begin : head
        assign p = power_q;
      end else begin : tail
        assign p = squarer[k-1].result;
      end
      wrinkle_scale #(.BITS(POWER_BITS + 1), .FRACTION_BITS(POWER_BITS)) square (
        .a_i(p), .b_i(p), .result_o(squared));
      assign result = draw_squarings_i > done_before + k ? squared : p;
    end
    if (SQUARERS == 0) begin : no_power
      wire unused_pins = &{1'b0, done_before, draw_squarings_i};
      assign power = power_q;
    end else begin : with_power
      assign power = squarer[SQUARERS-1].result;
    end
  endgenerate

  reg [DOT_BITS:0] nl_q, nh_q;
  wire [CARRY-1:0] carried;
  wrinkle_carry #(.BITS(CARRY), .RANKS(1)) carry (
    .clk(clk), .advance_i(second_q), .push_i(1'b0), .write_i(1'b0), .read_i(1'b0), .late_advance_i(1'b0),
    .data_i(carry_i), .data_o(carried));
  always @(posedge clk) begin
    if (first) nh_q <= dot;
    if (second_q) nl_q <= dot;
    if (first) power_q <= {dot, {(POWER_BITS - DOT_BITS){1'b0}}};
    else if (second_q | third_q) power_q <= power;
  end

  wire [POWER_BITS:0] one    = {1'b1, {POWER_BITS{1'b0}}};
  wire [POWER_BITS:0] raised = draw_exponent_zero_i ? one : THIRD != 0 ? power : power_q;

  generate
    if (LATE == 0) begin : at_once
      wire unused_pins = &{1'b0, draw_bump_i, draw_shadow_i};
      assign done_taken  = out_ready_i;
      assign out_valid_o = done_q;
      assign busy_o      = second_q | third_q | done_q;
      assign nl_o        = nl_q;
      assign nh_o        = nh_q;
      assign diffuse_o   = nl_q;
      assign specular_o  = raised;
      assign carry_o     = carried;
    end else begin : late
      reg                valid_q;
      reg [DOT_BITS:0]   nl_out_q, nh_out_q;
      reg [POWER_BITS:0] specular_q;
      wire [POWER_BITS:0] specular;
      assign done_taken  = out_ready_i | ~valid_q;
      assign out_valid_o = valid_q;
      assign busy_o      = second_q | third_q | done_q | valid_q;
      assign nl_o        = nl_out_q;
      assign nh_o        = nh_out_q;
      assign specular_o  = specular_q;
      always @(posedge clk)
        if (rst) valid_q <= 1'b0;
        else if (done_taken) valid_q <= done_q;
      always @(posedge clk)
        if (done_taken) {nl_out_q, nh_out_q, specular_q} <= {nl_q, nh_q, specular};
      wrinkle_carry #(.BITS(CARRY), .RANKS(1)) late_carry (
        .clk(clk), .advance_i(done_taken), .push_i(1'b0), .write_i(1'b0), .read_i(1'b0), .late_advance_i(1'b0),
        .data_i(carried), .data_o(carry_o));

      if (SELF_SHADOW != 0) begin : shadowed
        wire [DOT_BITS:0]   source, factor, diffuse;
        wire [POWER_BITS:0] scaled;
        reg [DOT_BITS:0]    diffuse_q;
        if (SURFACE_IS_Z != 0) begin : from_l
          wire [DOT_BITS:0] lz;
          reg [DOT_BITS:0]  lz_q;
          wrinkle_clamped #(.UNIT_BITS(UNIT_BITS), .DOT_BITS(DOT_BITS)) clamp (
            .value_i(l_i[2*W +: W]), .clamped_o(lz));
          assign source = draw_bump_i ? lz_q : nl_q;
          always @(posedge clk) if (second_q) lz_q <= lz;
        end else begin : from_nl
          wire unused_bump = draw_bump_i;
          assign source = nl_q;
        end
        wrinkle_shadow_factor #(.SELF_SHADOW(SELF_SHADOW), .DOT_BITS(DOT_BITS)) shadow (
          .source_i(source), .off_i(~draw_shadow_i), .factor_o(factor));
        wrinkle_scale #(.BITS(DOT_BITS + 1), .FRACTION_BITS(DOT_BITS)) scale_diffuse (
          .a_i(nl_q), .b_i(factor), .result_o(diffuse));
        wrinkle_scale #(.BITS(POWER_BITS + 1), .FRACTION_BITS(DOT_BITS)) scale_specular (
          .a_i(raised), .b_i(factor), .result_o(scaled));
        assign specular  = ~draw_shadow_i ? raised : |nl_q ? scaled : {(POWER_BITS + 1){1'b0}};
        assign diffuse_o = diffuse_q;
        always @(posedge clk) if (done_taken) diffuse_q <= diffuse;
      end else begin : unshadowed
        wire unused_pins = &{1'b0, draw_bump_i, draw_shadow_i};
        assign specular  = raised;
        assign diffuse_o = nl_out_q;
      end
    end
  endgenerate
endmodule
`default_nettype wire
