`default_nettype none
// N, L and H to unit length by one normalizer in turn: a fragment in three clocks, in which it waits at the input. H
// goes in in the first, L in the second, N in the third. The normalizer has two ranks and never stops: when H comes
// out, the fragment is taken if the one before has left or is leaving, and H, L and N are caught in three clocks; if
// not, all three go in again. So neither the ranks of the normalizer nor the carry need room for a stall.
// The fragment is valid in the clock in which N comes out, on the wire that its register will take. That gives whoever
// takes it two clocks to look before the next H comes, and so wrinkle_shared_light its two dot products. Latency 4.
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
  output wire [CARRY-1:0]             carry_o,
  output wire                         busy_o
);
  localparam UNIT = 3 * (UNIT_BITS + 2);

  // What goes in, L or N, else H; and what is caught after H: L, N.
  reg  in_l_q, in_n_q, out_l_q, out_n_q, full_q;
  wire take = in_n_q & (~full_q | out_ready_i);

  wire [3*(VECTOR_BITS+2)-1:0] vector = in_n_q ? n_i : in_l_q ? l_i : h_i;
  wire [UNIT-1:0] unit;
  wire            zero;

  wrinkle_unit_vector #(
    .NORMALIZER(NORMALIZER), .VECTOR_BITS(VECTOR_BITS), .UNIT_BITS(UNIT_BITS), .RANKS(2)
  ) unit_vector (.clk(clk), .advance_i(1'b1), .vector_i(vector), .unit_o(unit), .zero_o(zero));

  reg [UNIT-1:0]  n_q, l_q, h_q;
  reg             zero_q;

  assign in_ready_o  = take;
  assign out_valid_o = out_n_q | full_q;
  assign n_o         = out_n_q ? unit : n_q;
  assign l_o         = l_q;
  assign h_o         = h_q;
  assign zero_o      = zero_q | (out_n_q & zero);
  assign busy_o      = in_l_q | in_n_q | out_l_q | out_n_q | full_q;

  always @(posedge clk)
    if (rst) {in_l_q, in_n_q, out_l_q, out_n_q, full_q} <= 5'd0;
    else begin
      in_l_q  <= in_valid_i & ~in_l_q & ~in_n_q;
      in_n_q  <= in_l_q;
      out_l_q <= take;
      out_n_q <= out_l_q;
      full_q  <= out_valid_o & ~out_ready_i;
    end

  always @(posedge clk) begin
    if (take) h_q <= unit;
    if (out_l_q) l_q <= unit;
    n_q <= n_o;
    if (take | out_l_q | out_n_q) zero_q <= zero | (zero_q & ~take);
  end

  wrinkle_carry #(.BITS(CARRY), .RANKS(1)) carry (
    .clk(clk), .advance_i(take), .push_i(1'b0), .write_i(1'b0), .read_i(1'b0), .late_advance_i(1'b0),
    .data_i(carry_i), .data_o(carry_o));
endmodule
`default_nettype wire
