`default_nettype none
// Interpolates the components of a packet: one digital differential analyser each, led by the walk of wrinkle_scan.
// Values are those of the pixel on which the scan stands: latency 0, no handshake of its own. BUFFERING double: the
// next packet shifts into a shadow while this one is drawn; single: into the interpolators, when it is drawn. What the
// configuration lacks has a port of one constant bit; A, B, C are of [Peercy97 fig. 2]. Does not correct for
// perspective: there u and v are u*q and v*q.
module wrinkle_interpolate #(
  parameter DATAPATH        = 1,
  parameter CROSS_PRODUCTS  = 0,
  parameter LIGHT_VECTORS   = 0,
  parameter LIGHTING        = 1,
  parameter FILTER          = 2,
  parameter PERSPECTIVE     = 0,
  parameter DEPTH           = 1,
  parameter DECAL           = 0,
  parameter SHARING         = 0,
  parameter BUFFERING       = 0,
  parameter GUARD_BITS      = 10,
  parameter VECTOR_BITS     = 9,
  parameter WIDE_BITS       = 16,
  parameter UV_INTEGER_BITS = 4,
  parameter UV_BITS         = 18,
  parameter Q_BITS          = 18,
  parameter LOD_BITS        = 5,
  parameter DEPTH_BITS      = 20,
  parameter TEXELS = (DATAPATH == 1 ? 3 : DATAPATH == 2 ? 2 : 0) + 3*DECAL  // of the above: components of a texel
) (
  input  wire        clk,
  input  wire        shift_i,   // word_i is of the planes part of a packet
  input  wire        last_i,    // ... its last word
  input  wire [63:0] word_i,
  input  wire        load_i,    // the walk: see wrinkle_dda
  input  wire        step_i,
  input  wire        carry_i,
  input  wire        span_i,
  input  wire        first_i,
  input  wire        pixel_i,
  output wire [(DATAPATH < 2 ? 3*(VECTOR_BITS+2) : 1)-1:0]   n_o,   // s1.V, x in the low bits
  output wire [(DATAPATH == 2 ? 3*(WIDE_BITS+2) : 1)-1:0]    a_o,   // s1.VW
  output wire [(DATAPATH == 2 ? 3*(WIDE_BITS+2) : 1)-1:0]    b_o,
  output wire [(DATAPATH == 2 ? 3*(WIDE_BITS+2) : 1)-1:0]    c_o,
  output wire [(LIGHT_VECTORS == 0 ? 3*(VECTOR_BITS+2) : 1)-1:0] l_o,  // s1.V
  output wire [(LIGHT_VECTORS == 0 && LIGHTING != 0 ? 3*(VECTOR_BITS+2) : 1)-1:0] h_o,  // s1.V; E where H comes later
  output wire [(TEXELS != 0 ? UV_INTEGER_BITS + UV_BITS : 1)-1:0] u_o,  // s(UI-1).UF
  output wire [(TEXELS != 0 ? UV_INTEGER_BITS + UV_BITS : 1)-1:0] v_o,
  output wire [(TEXELS != 0 && PERSPECTIVE != 0 ? Q_BITS : 1)-1:0] q_o,  // u0.Q
  output wire [(TEXELS != 0 ? (FILTER == 2 ? 6 + LOD_BITS : 6) : 1)-1:0] lod_o,  // s5.LB
  output wire [(DEPTH != 0 ? DEPTH_BITS : 1)-1:0]            z_o    // u0.Z
);
  localparam G          = GUARD_BITS;
  localparam W          = VECTOR_BITS + 2;
  localparam UW         = UV_INTEGER_BITS + UV_BITS;
  localparam LODW       = FILTER == 2 ? 6 + LOD_BITS : 6;
  localparam WW         = WIDE_BITS + 2;
  localparam NORMALS    = DATAPATH < 2 ? 3 : 0;                                 // planes of N
  localparam PRODUCTS   = DATAPATH != 2 ? 0 : CROSS_PRODUCTS == 0 ? 9 : 3;      // ... of A, B, C
  localparam HELD       = DATAPATH == 2 && CROSS_PRODUCTS != 0 ? 6 : 0;         // values of B, C held over a packet
  localparam LIGHTS     = LIGHT_VECTORS != 0 ? 0 : LIGHTING != 0 ? 6 : 3;       // planes of L and H
  localparam HELD_AT    = 3 * (NORMALS * (W + G) + PRODUCTS * (WW + G));
  localparam L_AT       = HELD_AT + HELD * WW;
  localparam HAS_UV     = TEXELS != 0 ? 1 : 0;
  localparam HAS_Q      = HAS_UV != 0 && PERSPECTIVE != 0 ? 1 : 0;
  localparam U_AT       = L_AT + 3 * LIGHTS * (W + G);
  localparam V_AT       = U_AT + 3 * (UW + G);
  localparam Q_AT       = U_AT + (HAS_UV != 0 ? 6 * (UW + G) : 0);
  localparam PLANE_LOD_AT = Q_AT + 3 * (Q_BITS + G);
  localparam Z_AT       = HAS_Q != 0 ? PLANE_LOD_AT + 3 * (LODW + G) : Q_AT;
  localparam LOD_AT     = Z_AT + (DEPTH != 0 ? 3 * (DEPTH_BITS + G) : 0);
  localparam BITS       = LOD_AT + (HAS_UV != 0 && HAS_Q == 0 ? LODW - 2 : 0);
  localparam WORDS      = (BITS + 63) / 64;

  // double: the shadow; single: the interpolators' own registers, and plain ones for what is no plane. These have no
  // bits for the padding of the last word: it goes to its place at once, all others shift past below it.
  wire [64*WORDS-1:0] packet;
  wire [BITS-1:0]     fields;  // single: as each component has them; double: 0
  wire [64*WORDS-1:0] shifts;  // single: which bits of the packet take those of `next`
  wire [64*WORDS-1:0] next;
  wire unused_bits = &{1'b0, last_i, packet, fields, shifts, next};

  genvar k;
  generate
    for (k = 0; k < WORDS; k = k + 1) begin : word
      assign shifts[64*k +: 64] = {64{BUFFERING != 0 && shift_i && (k == WORDS - 1 ? last_i : ~last_i)}};
      if (k < WORDS - 2) begin : from_above
        assign next[64*k +: 64] = packet[64*k+64 +: 64];
      end else begin : entry
        assign next[64*k +: 64] = word_i;
      end
    end
    if (BUFFERING != 0) begin : in_place
      assign packet[BITS-1:0] = fields;
      if (64*WORDS > BITS) begin : padding
        assign packet[64*WORDS-1:BITS] = {(64*WORDS-BITS){1'b0}};
      end
    end else begin : shadowed
      wrinkle_shadow_words #(.WORDS(WORDS)) shadow (.clk(clk), .shift_i(shift_i), .word_i(word_i), .words_o(packet));
    end
    for (k = 0; k < HELD * WW + BITS - LOD_AT; k = k + 1) begin : plain
      localparam AT = k < HELD * WW ? HELD_AT + k : LOD_AT + k - HELD * WW;
      if (BUFFERING != 0) begin : in_place
        reg bit_q;
        assign fields[AT] = bit_q;
        always @(posedge clk) if (shifts[AT]) bit_q <= next[AT];
      end else begin : shadowed
        assign fields[AT] = 1'b0;
      end
    end

    for (k = 0; k < NORMALS; k = k + 1) begin : normal
      wire [W-1:0] value;
      wrinkle_plane #(.WIDTH(W), .GUARD(G), .SHARING(SHARING), .BUFFERING(BUFFERING)) dda (
        .clk(clk), .load_i(load_i), .step_i(step_i), .carry_i(carry_i), .span_i(span_i), .first_i(first_i),
        .pixel_i(pixel_i), .shadow_i(packet[3*k*(W+G) +: 3*(W+G)]), .shift_i(shifts[3*k*(W+G) +: 3*(W+G)]),
        .next_i(next[3*k*(W+G) +: 3*(W+G)]), .fields_o(fields[3*k*(W+G) +: 3*(W+G)]), .value_o(value));
      assign n_o[k*W +: W] = value;
    end
    if (NORMALS == 0) begin : no_n
      assign n_o = 1'b0;
    end

    if (DATAPATH == 2) begin : blinn
      wire [9*WW-1:0] products;
      for (k = 0; k < PRODUCTS; k = k + 1) begin : product
        wrinkle_plane #(.WIDTH(WW), .GUARD(G), .SHARING(SHARING), .BUFFERING(BUFFERING)) dda (
          .clk(clk), .load_i(load_i), .step_i(step_i), .carry_i(carry_i), .span_i(span_i), .first_i(first_i),
          .pixel_i(pixel_i), .shadow_i(packet[3*k*(WW+G) +: 3*(WW+G)]), .shift_i(shifts[3*k*(WW+G) +: 3*(WW+G)]),
          .next_i(next[3*k*(WW+G) +: 3*(WW+G)]), .fields_o(fields[3*k*(WW+G) +: 3*(WW+G)]),
          .value_o(products[k*WW +: WW]));
      end
      if (HELD != 0) begin : held
        wrinkle_held #(.WIDTH(HELD*WW), .BUFFERING(BUFFERING)) values (
          .clk(clk), .load_i(load_i), .take_i(span_i & first_i), .field_i(packet[HELD_AT +: HELD*WW]),
          .value_o(products[PRODUCTS*WW +: HELD*WW]));
      end
      assign {c_o, b_o, a_o} = products;
    end else begin : no_products
      assign {c_o, b_o, a_o} = 3'b000;
    end

    for (k = 0; k < LIGHTS; k = k + 1) begin : light
      wire [W-1:0] value;
      wrinkle_plane #(.WIDTH(W), .GUARD(G), .SHARING(SHARING), .BUFFERING(BUFFERING)) dda (
        .clk(clk), .load_i(load_i), .step_i(step_i), .carry_i(carry_i), .span_i(span_i), .first_i(first_i),
        .pixel_i(pixel_i), .shadow_i(packet[L_AT+3*k*(W+G) +: 3*(W+G)]), .shift_i(shifts[L_AT+3*k*(W+G) +: 3*(W+G)]),
        .next_i(next[L_AT+3*k*(W+G) +: 3*(W+G)]), .fields_o(fields[L_AT+3*k*(W+G) +: 3*(W+G)]), .value_o(value));
      if (k < 3) begin : of_l
        assign l_o[k*W +: W] = value;
      end else begin : of_h
        assign h_o[(k-3)*W +: W] = value;
      end
    end
    if (LIGHTS == 0) begin : no_l
      assign l_o = 1'b0;
    end
    if (LIGHTS < 6) begin : no_h
      assign h_o = 1'b0;
    end

    if (HAS_UV != 0) begin : uv
      wrinkle_plane #(.WIDTH(UW), .GUARD(G), .SHARING(SHARING), .BUFFERING(BUFFERING)) u (
        .clk(clk), .load_i(load_i), .step_i(step_i), .carry_i(carry_i), .span_i(span_i), .first_i(first_i),
        .pixel_i(pixel_i), .shadow_i(packet[U_AT +: 3*(UW+G)]), .shift_i(shifts[U_AT +: 3*(UW+G)]),
        .next_i(next[U_AT +: 3*(UW+G)]), .fields_o(fields[U_AT +: 3*(UW+G)]), .value_o(u_o));
      wrinkle_plane #(.WIDTH(UW), .GUARD(G), .SHARING(SHARING), .BUFFERING(BUFFERING)) v (
        .clk(clk), .load_i(load_i), .step_i(step_i), .carry_i(carry_i), .span_i(span_i), .first_i(first_i),
        .pixel_i(pixel_i), .shadow_i(packet[V_AT +: 3*(UW+G)]), .shift_i(shifts[V_AT +: 3*(UW+G)]),
        .next_i(next[V_AT +: 3*(UW+G)]), .fields_o(fields[V_AT +: 3*(UW+G)]), .value_o(v_o));
    end else begin : no_uv
      assign u_o = 1'b0;
      assign v_o = 1'b0;
    end

    if (HAS_Q != 0) begin : divided
      wrinkle_plane #(.WIDTH(Q_BITS), .GUARD(G), .SHARING(SHARING), .BUFFERING(BUFFERING)) q (
        .clk(clk), .load_i(load_i), .step_i(step_i), .carry_i(carry_i), .span_i(span_i), .first_i(first_i),
        .pixel_i(pixel_i), .shadow_i(packet[Q_AT +: 3*(Q_BITS+G)]), .shift_i(shifts[Q_AT +: 3*(Q_BITS+G)]),
        .next_i(next[Q_AT +: 3*(Q_BITS+G)]), .fields_o(fields[Q_AT +: 3*(Q_BITS+G)]), .value_o(q_o));
      wrinkle_plane #(.WIDTH(LODW), .GUARD(G), .SHARING(SHARING), .BUFFERING(BUFFERING)) lod (
        .clk(clk), .load_i(load_i), .step_i(step_i), .carry_i(carry_i), .span_i(span_i), .first_i(first_i),
        .pixel_i(pixel_i), .shadow_i(packet[PLANE_LOD_AT +: 3*(LODW+G)]), .shift_i(shifts[PLANE_LOD_AT +: 3*(LODW+G)]),
        .next_i(next[PLANE_LOD_AT +: 3*(LODW+G)]), .fields_o(fields[PLANE_LOD_AT +: 3*(LODW+G)]), .value_o(lod_o));
    end else if (HAS_UV != 0) begin : undivided
      // One level of detail a packet: it follows the row engine and the pixel engine like a gradient.
      assign q_o   = 1'b0;
      assign lod_o[LODW-1:LODW-2] = 2'b00;
      wrinkle_held #(.WIDTH(LODW-2), .BUFFERING(BUFFERING)) lod (
        .clk(clk), .load_i(load_i), .take_i(span_i & first_i), .field_i(packet[LOD_AT +: LODW-2]),
        .value_o(lod_o[LODW-3:0]));
    end else begin : no_texture
      assign q_o   = 1'b0;
      assign lod_o = 1'b0;
    end

    if (DEPTH != 0) begin : with_z
      wrinkle_plane #(.WIDTH(DEPTH_BITS), .GUARD(G), .SHARING(SHARING), .BUFFERING(BUFFERING)) z (
        .clk(clk), .load_i(load_i), .step_i(step_i), .carry_i(carry_i), .span_i(span_i), .first_i(first_i),
        .pixel_i(pixel_i), .shadow_i(packet[Z_AT +: 3*(DEPTH_BITS+G)]), .shift_i(shifts[Z_AT +: 3*(DEPTH_BITS+G)]),
        .next_i(next[Z_AT +: 3*(DEPTH_BITS+G)]), .fields_o(fields[Z_AT +: 3*(DEPTH_BITS+G)]), .value_o(z_o));
    end else begin : no_z
      assign z_o = 1'b0;
    end
  endgenerate
endmodule
`default_nettype wire
