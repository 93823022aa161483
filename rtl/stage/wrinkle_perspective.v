`default_nettype none
// Perspective: u = uq / q, v = vq / q. q is normalized by its leading zeros, its reciprocal comes from a table, and the
// product is shifted back and rounded: u = round_half_up(uq * r, R - lz), modulo the width of u.
// Latency 5; a wire where there is no q. Does not detect q = 0: it is taken as 1 LSB.
module wrinkle_perspective #(
  parameter UV              = 22,  // bits of u and of v; 0: none
  parameter Q               = 18,  // bits of q; 0: none
  parameter RECIPROCAL_BITS = 18,  // R, at least Q - 1
  parameter CARRY           = 140
) (
  input  wire clk,
  input  wire rst,
  input  wire in_valid_i,
  output wire in_ready_o,
  input  wire [(UV != 0 ? UV : 1)-1:0] u_i,  // u*q, s(UI-1).UF
  input  wire [(UV != 0 ? UV : 1)-1:0] v_i,
  input  wire [(Q != 0 ? Q : 1)-1:0]   q_i,  // u0.Q
  input  wire [CARRY-1:0]              carry_i,
  output wire out_valid_o,
  input  wire out_ready_i,
  output wire [(UV != 0 ? UV : 1)-1:0] u_o,  // s(UI-1).UF
  output wire [(UV != 0 ? UV : 1)-1:0] v_o,
  output wire [CARRY-1:0]              carry_o,
  output wire busy_o
);
  localparam RANKS = Q != 0 ? 5 : 0;
  wire advance;

  generate
    if (Q != 0) begin : present
      wrinkle_pipe #(.RANKS(RANKS)) pipe (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .advance_o(advance), .out_valid_o(out_valid_o),
        .out_ready_i(out_ready_i), .busy_o(busy_o));
      assign in_ready_o = advance;

      // Rank 1: q normalized.
      wire [Q-1:0] q = |q_i ? q_i : {{(Q - 1){1'b0}}, 1'b1};
      wire [4:0]   zeros, zeros3;
      reg [Q-1:0]  m_q;
      reg [4:0]    zeros_q;
      wrinkle_leading_zeros #(.BITS(Q)) leading (.value_i(q), .count_o(zeros));
      always @(posedge clk)
        if (advance) begin
          m_q     <= q << zeros;
          zeros_q <= zeros;
        end

      // Ranks 2 and 3: its reciprocal. Ranks 4 and 5: the quotients.
      wire [RECIPROCAL_BITS:0] r;
      wire signed [UV-1:0]     u3, v3;
      wrinkle_reciprocal #(.INPUT_BITS(Q), .OUTPUT_BITS(RECIPROCAL_BITS)) reciprocal (
        .clk(clk), .advance_i(advance), .m_i(m_q), .r_o(r));
      wrinkle_delay #(.WIDTH(5), .RANKS(2)) delay_zeros (
        .clk(clk), .advance_i(advance), .data_i(zeros_q), .data_o(zeros3));
      wrinkle_delay #(.WIDTH(UV), .RANKS(3)) delay_u (.clk(clk), .advance_i(advance), .data_i(u_i), .data_o(u3));
      wrinkle_delay #(.WIDTH(UV), .RANKS(3)) delay_v (.clk(clk), .advance_i(advance), .data_i(v_i), .data_o(v3));
      wrinkle_quotient #(.WIDTH(UV), .RECIPROCAL_BITS(RECIPROCAL_BITS)) quotient_u (
        .clk(clk), .advance_i(advance), .value_i(u3), .r_i(r), .zeros_i(zeros3), .quotient_o(u_o));
      wrinkle_quotient #(.WIDTH(UV), .RECIPROCAL_BITS(RECIPROCAL_BITS)) quotient_v (
        .clk(clk), .advance_i(advance), .value_i(v3), .r_i(r), .zeros_i(zeros3), .quotient_o(v_o));
    end else begin : absent
      wire unused_pins = &{1'b0, rst, q_i};
      assign advance     = out_ready_i;
      assign in_ready_o  = out_ready_i;
      assign out_valid_o = in_valid_i;
      assign u_o         = u_i;
      assign v_o         = v_i;
      assign busy_o      = 1'b0;
    end
  endgenerate

  wrinkle_carry #(.BITS(CARRY), .RANKS(RANKS)) carry (
    .clk(clk), .advance_i(advance), .push_i(1'b0), .write_i(1'b0), .read_i(1'b0), .late_advance_i(1'b0),
    .data_i(carry_i), .data_o(carry_o));
endmodule
`default_nettype wire
