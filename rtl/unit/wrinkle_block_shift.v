`default_nettype none
// Three magnitudes, shifted up together by the leading zeros of their OR; zero_o when there is none that is set.
// Combinational. A synthesis map may arrange the shifts.
module wrinkle_block_shift #(
  parameter BITS = 10
) (
  input  wire [3*BITS-1:0] m_i,
  output wire [3*BITS-1:0] m_o,
  output wire              zero_o
);
  wire [BITS-1:0] any = m_i[0 +: BITS] | m_i[BITS +: BITS] | m_i[2*BITS +: BITS];
  wire [4:0]      places;

  wrinkle_leading_zeros #(.BITS(BITS)) zeros (.value_i(any), .count_o(places));

  assign m_o    = {m_i[2*BITS +: BITS] << places, m_i[BITS +: BITS] << places, m_i[0 +: BITS] << places};
  assign zero_o = ~|any;
endmodule
`default_nettype wire
