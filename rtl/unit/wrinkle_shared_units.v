`default_nettype none
// N, L and H to unit length by one normalizer in turn: a fragment in three clocks, in which it waits at the input. N
// goes in in the first, H in the second, L in the third. The normalizer has two ranks and never stops: when N comes
// out, the fragment is taken if the one before has left or is leaving, and N, H and L are caught in three clocks; if
// not, all three go in again. So neither the ranks of the normalizer nor the carry need room for a stall.
// n_o and h_o stand a clock before the fragment is valid, and `ahead_o` says so: wrinkle_shared_light may multiply them
// then, and n_o by l_o in the clock in which it takes the fragment. All of them hold until it is taken. Latency 5.
module wrinkle_shared_units #(
  parameter NORMALIZER  = 1,   // not none
  parameter VECTOR_BITS = 9,   // V
  parameter UNIT_BITS   = 9,   // F
  parameter CARRY       = 36
) (
  input  wire                         clk,
  input  wire                         rst,
  input  wire                         in_valid_i,
  output wire                         in_ready_o,
  input  wire [3*(VECTOR_BITS+2)-1:0] n_i,          // s1.V, x in the low bits
  input  wire [3*(VECTOR_BITS+2)-1:0] l_i,
  input  wire [3*(VECTOR_BITS+2)-1:0] h_i,
  input  wire [CARRY-1:0]             carry_i,
  output wire                         out_valid_o,
  input  wire                         out_ready_i,
  output wire [3*(UNIT_BITS+2)-1:0]   n_o,          // s1.F
  output wire [3*(UNIT_BITS+2)-1:0]   l_o,
  output wire [3*(UNIT_BITS+2)-1:0]   h_o,
  output wire                         zero_o,       // one of them was zero
  output wire                         ahead_o,      // n_o and h_o stand, and hold as a valid fragment does
  output wire [CARRY-1:0]             carry_o,
  output wire                         busy_o
);
  localparam UNIT = 3 * (UNIT_BITS + 2);

  // What goes in, H or L, else N; and what is caught after N: H, L.
  reg  in_h_q, in_l_q, out_h_q, out_l_q, full_q;
  wire take = in_l_q & (~full_q | out_ready_i);

  wire [3*(VECTOR_BITS+2)-1:0] vector = in_l_q ? l_i : in_h_q ? h_i : n_i;
  wire [UNIT-1:0] unit;
  wire            zero;

  wrinkle_unit_vector #(
    .NORMALIZER(NORMALIZER), .VECTOR_BITS(VECTOR_BITS), .UNIT_BITS(UNIT_BITS), .RANKS(2)
  ) unit_vector (.clk(clk), .advance_i(1'b1), .vector_i(vector), .unit_o(unit), .zero_o(zero));

  reg [UNIT-1:0]  n_q, l_q, h_q;
  reg             zero_q;

  assign in_ready_o  = take;
  assign out_valid_o = full_q;
  assign ahead_o     = out_l_q | full_q;
  assign n_o         = n_q;
  assign l_o         = l_q;
  assign h_o         = h_q;
  assign zero_o      = zero_q;
  assign busy_o      = in_h_q | in_l_q | out_h_q | out_l_q | full_q;

  always @(posedge clk)
    if (rst) {in_h_q, in_l_q, out_h_q, out_l_q, full_q} <= 5'd0;
    else begin
      in_h_q  <= in_valid_i & ~in_h_q & ~in_l_q;
      in_l_q  <= in_h_q;
      out_h_q <= take;
      out_l_q <= out_h_q;
      full_q  <= out_l_q | (full_q & ~out_ready_i);
    end

  always @(posedge clk) begin
    if (take) n_q <= unit;
    if (out_h_q) h_q <= unit;
    if (out_l_q) l_q <= unit;
    if (take | out_h_q | out_l_q) zero_q <= zero | (zero_q & ~take);
  end

  wrinkle_carry #(.BITS(CARRY), .RANKS(1)) carry (
    .clk(clk), .advance_i(take), .push_i(1'b0), .write_i(1'b0), .read_i(1'b0), .late_advance_i(1'b0),
    .data_i(carry_i), .data_o(carry_o));
endmodule
`default_nettype wire
