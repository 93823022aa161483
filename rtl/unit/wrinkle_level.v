`default_nettype none
// The level of detail at the top of a bus, s5.LB: a plane, or what is held over a triangle, which is not negative and has
// two bits less; one 0 where the configuration has neither. Latency 0.
module wrinkle_level #(
  parameter BITS  = 36,
  parameter PLANE = 0,
  parameter HELD  = 9
) (
  input  wire [BITS-1:0]                                              bus_i,
  output wire [(PLANE != 0 ? PLANE : HELD != 0 ? HELD + 2 : 1)-1:0]   level_o
);
  wire unused_others = &{1'b0, bus_i};

  generate
    if (PLANE != 0) begin : interpolated
      assign level_o = bus_i[BITS-1 -: PLANE];
    end else if (HELD != 0) begin : held
      assign level_o = {2'b00, bus_i[BITS-1 -: HELD]};
    end else begin : absent
      assign level_o = 1'b0;
    end
  endgenerate
endmodule
`default_nettype wire
