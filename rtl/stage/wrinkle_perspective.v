`default_nettype none
// Perspective: u = uq / q, v = vq / q. q is normalized by its leading zeros, its reciprocal comes from a table, and the
// product is shifted back and rounded: u = round_half_up(uq * r, R - lz), modulo the width of u.
// Latency 5; a wire unless PERSPECTIVE is on and something reads texels. Does not detect q = 0: it is taken as 1 LSB.
module wrinkle_perspective #(
  parameter DATAPATH        = 1,
  parameter LIGHT_VECTORS   = 0,
  parameter LIGHTING        = 1,
  parameter FILTER          = 2,
  parameter PERSPECTIVE     = 1,
  parameter DEPTH           = 1,
  parameter DECAL           = 0,
  parameter SCREEN_BITS     = 10,
  parameter VECTOR_BITS     = 9,
  parameter WIDE_BITS       = 16,
  parameter UV_INTEGER_BITS = 4,
  parameter UV_BITS         = 18,
  parameter Q_BITS          = 18,  // Q
  parameter RECIPROCAL_BITS = 18,  // R, at least Q - 1
  parameter LOD_BITS        = 5,
  parameter DEPTH_BITS      = 20,
  // Of the above: components of a texel; bits of N or {C, B, A}, of L, of H or E.
  parameter TEXELS = (DATAPATH == 1 ? 3 : DATAPATH == 2 ? 2 : 0) + 3*DECAL,
  parameter SMOOTH = DATAPATH == 3 ? 1 : DATAPATH == 2 ? 9*(WIDE_BITS+2) : 3*(VECTOR_BITS+2),
  parameter LVEC   = LIGHT_VECTORS != 0 ? 1 : 3*(VECTOR_BITS+2),
  parameter HVEC   = LIGHTING != 0 ? LVEC : 1
) (
  input  wire clk,
  input  wire rst,
  input  wire in_valid_i,
  output wire in_ready_o,
  input  wire [SMOOTH-1:0] smooth_i,
  input  wire [LVEC-1:0]   l_i,
  input  wire [HVEC-1:0]   h_i,
  input  wire [(TEXELS != 0 ? UV_INTEGER_BITS + UV_BITS : 1)-1:0]   u_i,  // u*q, s(UI-1).UF
  input  wire [(TEXELS != 0 ? UV_INTEGER_BITS + UV_BITS : 1)-1:0]   v_i,
  input  wire [(TEXELS != 0 && PERSPECTIVE != 0 ? Q_BITS : 1)-1:0]  q_i,  // u0.Q
  input  wire [(TEXELS != 0 ? (FILTER == 2 ? 6 + LOD_BITS : 6) : 1)-1:0] lod_i,
  input  wire [2*SCREEN_BITS+(DEPTH != 0 ? DEPTH_BITS : 0):0] tag_i,
  output wire out_valid_o,
  input  wire out_ready_i,
  output wire [SMOOTH-1:0] smooth_o,
  output wire [LVEC-1:0]   l_o,
  output wire [HVEC-1:0]   h_o,
  output wire [(TEXELS != 0 ? UV_INTEGER_BITS + UV_BITS : 1)-1:0]   u_o,  // s(UI-1).UF
  output wire [(TEXELS != 0 ? UV_INTEGER_BITS + UV_BITS : 1)-1:0]   v_o,
  output wire [(TEXELS != 0 ? (FILTER == 2 ? 6 + LOD_BITS : 6) : 1)-1:0] lod_o,
  output wire [2*SCREEN_BITS+(DEPTH != 0 ? DEPTH_BITS : 0):0] tag_o,
  output wire busy_o
);
  localparam TAG   = 2 * SCREEN_BITS + 1 + (DEPTH != 0 ? DEPTH_BITS : 0);
  localparam UW    = UV_INTEGER_BITS + UV_BITS;
  localparam LODW  = FILTER == 2 ? 6 + LOD_BITS : 6;
  localparam RANKS = 5;

  generate
    if (TEXELS != 0 && PERSPECTIVE != 0) begin : present
      wire advance;
      wrinkle_pipe #(.RANKS(RANKS)) pipe (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .advance_o(advance), .out_valid_o(out_valid_o),
        .out_ready_i(out_ready_i), .busy_o(busy_o));
      assign in_ready_o = advance;

      // Rank 1: q normalized.
      wire [Q_BITS-1:0] q = |q_i ? q_i : {{(Q_BITS - 1){1'b0}}, 1'b1};
      wire [4:0]        zeros, zeros3;
      reg [Q_BITS-1:0]  m_q;
      reg [4:0]         zeros_q;
      wrinkle_leading_zeros #(.BITS(Q_BITS)) leading (.value_i(q), .count_o(zeros));
      always @(posedge clk)
        if (advance) begin
          m_q     <= q << zeros;
          zeros_q <= zeros;
        end

      // Ranks 2 and 3: its reciprocal. Ranks 4 and 5: the quotients.
      wire [RECIPROCAL_BITS:0] r;
      wire signed [UW-1:0]     u3, v3;
      wrinkle_reciprocal #(.INPUT_BITS(Q_BITS), .OUTPUT_BITS(RECIPROCAL_BITS)) reciprocal (
        .clk(clk), .advance_i(advance), .m_i(m_q), .r_o(r));
      wrinkle_delay #(.WIDTH(5), .RANKS(2)) delay_zeros (
        .clk(clk), .advance_i(advance), .data_i(zeros_q), .data_o(zeros3));
      wrinkle_delay #(.WIDTH(UW), .RANKS(3)) delay_u (.clk(clk), .advance_i(advance), .data_i(u_i), .data_o(u3));
      wrinkle_delay #(.WIDTH(UW), .RANKS(3)) delay_v (.clk(clk), .advance_i(advance), .data_i(v_i), .data_o(v3));
      wrinkle_quotient #(.WIDTH(UW), .RECIPROCAL_BITS(RECIPROCAL_BITS)) quotient_u (
        .clk(clk), .advance_i(advance), .value_i(u3), .r_i(r), .zeros_i(zeros3), .quotient_o(u_o));
      wrinkle_quotient #(.WIDTH(UW), .RECIPROCAL_BITS(RECIPROCAL_BITS)) quotient_v (
        .clk(clk), .advance_i(advance), .value_i(v3), .r_i(r), .zeros_i(zeros3), .quotient_o(v_o));

      wrinkle_delay #(.WIDTH(SMOOTH), .RANKS(DATAPATH != 3 ? RANKS : 0)) delay_smooth (
        .clk(clk), .advance_i(advance), .data_i(smooth_i), .data_o(smooth_o));
      wrinkle_delay #(.WIDTH(LVEC), .RANKS(LIGHT_VECTORS == 0 ? RANKS : 0)) delay_l (
        .clk(clk), .advance_i(advance), .data_i(l_i), .data_o(l_o));
      wrinkle_delay #(.WIDTH(HVEC), .RANKS(LIGHTING != 0 && LIGHT_VECTORS == 0 ? RANKS : 0)) delay_h (
        .clk(clk), .advance_i(advance), .data_i(h_i), .data_o(h_o));
      wrinkle_delay #(.WIDTH(LODW), .RANKS(RANKS)) delay_lod (
        .clk(clk), .advance_i(advance), .data_i(lod_i), .data_o(lod_o));
      wrinkle_delay #(.WIDTH(TAG), .RANKS(RANKS)) delay_tag (
        .clk(clk), .advance_i(advance), .data_i(tag_i), .data_o(tag_o));
    end else begin : absent
      wire unused_pins = &{1'b0, clk, rst, q_i};
      assign in_ready_o  = out_ready_i;
      assign out_valid_o = in_valid_i;
      assign smooth_o = smooth_i;
      assign l_o   = l_i;
      assign h_o   = h_i;
      assign u_o   = u_i;
      assign v_o   = v_i;
      assign lod_o = lod_i;
      assign tag_o = tag_i;
      assign busy_o = 1'b0;
    end
  endgenerate
endmodule
`default_nettype wire
