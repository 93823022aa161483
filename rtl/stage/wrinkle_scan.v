`default_nettype none
// Walks the pixels of a triangle packet: the row engine steps the edges one row a clock, empty rows included, and
// stands on the next row to draw; the pixel engine walks the span before it, one pixel a clock. So neither a new row
// nor a new triangle costs a clock, unless rows are empty. Tells wrinkle_interpolate every step, in the clock in which
// it is made. A span's last pixel waits until the row engine knows whether more of the triangle follows. Latency 2 from
// the packet. Does not clip: set-up lets no row leave the screen.
// With SHARING on and BUFFERING single an interpolator has one adder, and the walk it is told has one sum a clock: a
// row that the pixel engine takes or that is empty is stepped over in the clock after, in one more where the start edge
// carries, and no pixel is offered meanwhile. A pixel that is offered stays so until it is taken: no row is stepped over
// before.
module wrinkle_scan #(
  parameter SHARING       = 0,
  parameter BUFFERING     = 0,
  parameter SCREEN_BITS   = 10,
  parameter SUBPIXEL_BITS = 8,
  parameter WORDS         = 5   // of the scan part of a packet
) (
  input  wire                   clk,
  input  wire                   rst,
  input  wire                   shift_i,           // word_i is of the scan part of a packet
  input  wire [63:0]            word_i,
  input  wire                   triangle_valid_i,
  output wire                   load_o,            // the row engine takes the packet
  output wire                   step_o,            // ... goes to its next row
  output wire                   carry_o,           // ... and the start edge has moved one pixel more; with one
                                                   // sum a clock this comes in the clock after step_o
  output wire                   span_o,            // the pixel engine takes the row
  output wire                   first_o,           // ... the first one of a packet
  output wire                   pixel_o,           // ... goes to its next pixel
  output wire                   out_valid_o,
  input  wire                   out_ready_i,
  output wire [SCREEN_BITS-1:0] x_o,
  output wire [SCREEN_BITS-1:0] y_o,
  output wire                   last_o,            // of its packet
  output wire                   busy_o             // a row, a pixel or a sum of the interpolators is left
);
  localparam X         = SCREEN_BITS;
  localparam EDGE_BITS = SCREEN_BITS + SUBPIXEL_BITS + 2;
  localparam FIELDS    = 2 * (X + 2) + 3 * EDGE_BITS + 1;  // of one edge
  localparam EDGES_AT  = 5 + X + 2 * (X + 1);

  wire [64*WORDS-1:0] packet;
  wrinkle_shadow_words #(.WORDS(WORDS)) shadow (.clk(clk), .shift_i(shift_i), .word_i(word_i), .words_o(packet));
  wire unused_opcode_and_padding = &{1'b0, packet};

  // Row engine.
  reg              row_valid_q, row_fresh_q;  // fresh: no row of this packet has been drawn yet
  reg              mirror_q;
  reg [X-1:0]      row_y_q;
  reg [X:0]        rows_q, rows_end0_q;       // from this row on
  reg [FIELDS-1:0] end1_q;
  wire signed [X+1:0] start, finish;
  wire             load, step, carry, to_end1, unused_carry;
  wire             waits;                     // for the interpolators' adder
  wire             held;                      // ... and the adder for a pixel that is offered

  wire row_full  = start < finish;
  wire nonempty  = row_valid_q & row_full & ~waits;
  wire empty     = row_valid_q & ~row_full & ~waits & ~held;

  // Pixel engine.
  reg         pixel_valid_q, pixel_mirror_q;
  reg [X-1:0] w_q, y_q, left_q;               // left: pixels of the span after this one
  wire        final_pixel = left_q == {X{1'b0}};
  wire        resolved    = ~row_valid_q | row_fresh_q | row_full;
  wire        leave       = out_valid_o & out_ready_i;
  wire        span        = nonempty & (~pixel_valid_q | (leave & final_pixel));
  wire        pixel       = leave & ~final_pixel;
  wire [X-1:0] length_less_1 = finish[X-1:0] + ~start[X-1:0];

  assign out_valid_o = pixel_valid_q & (~final_pixel | resolved) & ~waits;
  assign last_o      = final_pixel & (~row_valid_q | row_fresh_q);
  assign x_o         = w_q ^ {X{pixel_mirror_q}};
  assign y_o         = y_q;

  assign step    = empty | span;
  wire row_last  = rows_q == {{X{1'b0}}, 1'b1};
  assign load    = triangle_valid_i & (~row_valid_q | (step & row_last));
  assign to_end1 = rows_end0_q == {{X{1'b0}}, 1'b1};

  assign load_o  = load;
  assign span_o  = span;
  assign first_o = row_fresh_q;
  assign pixel_o = pixel;
  assign busy_o  = row_valid_q | pixel_valid_q | waits;

  wire [FIELDS-1:0] start_fields = packet[EDGES_AT +: FIELDS];
  wire [FIELDS-1:0] end0_fields  = packet[EDGES_AT + FIELDS +: FIELDS];
  wire [FIELDS-1:0] end1_fields  = packet[EDGES_AT + 2*FIELDS +: FIELDS];
  wire [X-1:0]      packet_y     = packet[5 +: X];
  wire [X:0]        packet_rows  = packet[5 + X +: X + 1];
  wire [X:0]        packet_end0  = packet[6 + 2*X +: X + 1];

  wrinkle_edge #(.SCREEN_BITS(X), .EDGE_BITS(EDGE_BITS)) start_edge (
    .clk(clk), .load_i(load), .step_i(step), .fields_i(start_fields), .w_o(start), .carry_o(carry));
  wrinkle_edge #(.SCREEN_BITS(X), .EDGE_BITS(EDGE_BITS)) end_edge (
    .clk(clk), .load_i(load | (step & to_end1)), .step_i(step),
    .fields_i(~load ? end1_q : packet_end0 == {(X + 1){1'b0}} ? end1_fields : end0_fields),
    .w_o(finish), .carry_o(unused_carry));

  generate
    if (SHARING != 0 && BUFFERING != 0) begin : one_sum_a_clock
      reg step_q, carry_q;
      assign waits   = step_q | carry_q;
      assign held    = out_valid_o & ~out_ready_i;
      assign step_o  = step_q;
      assign carry_o = carry_q & ~step_q;
      always @(posedge clk)
        if (rst) {step_q, carry_q} <= 2'b00;
        else {step_q, carry_q} <= {step, step ? carry : carry_q & step_q};
    end else begin : at_once
      assign waits   = 1'b0;
      assign held    = 1'b0;
      assign step_o  = step;
      assign carry_o = carry;
    end
  endgenerate

  always @(posedge clk)
    if (rst) begin
      row_valid_q   <= 1'b0;
      pixel_valid_q <= 1'b0;
    end else begin
      row_valid_q   <= load | (row_valid_q & ~(step & row_last));
      pixel_valid_q <= span | (pixel_valid_q & ~(leave & final_pixel));
    end

  always @(posedge clk) begin
    if (load) begin
      row_fresh_q <= 1'b1;
      mirror_q    <= packet[4];
      row_y_q     <= packet_y;
      rows_q      <= packet_rows;
      rows_end0_q <= packet_end0;
      end1_q      <= end1_fields;
    end else if (step) begin
      row_fresh_q <= row_fresh_q & ~span;
      row_y_q     <= row_y_q + 1'b1;
      rows_q      <= rows_q - 1'b1;
      rows_end0_q <= rows_end0_q - 1'b1;
    end
    if (span) begin
      pixel_mirror_q <= mirror_q;
      w_q            <= start[X-1:0];
      y_q            <= row_y_q;
      left_q         <= length_less_1;
    end else if (pixel) begin
      w_q    <= w_q + 1'b1;
      left_q <= left_q - 1'b1;
    end
  end
endmodule
`default_nettype wire
