`default_nettype none
// WIDTH bits of a bus from bit AT; one 0 where the configuration has no such field (WIDTH = 0). Latency 0.
module wrinkle_field #(
  parameter BITS  = 36,
  parameter AT    = 0,
  parameter WIDTH = 10
) (
  input  wire [BITS-1:0]                    bus_i,
  output wire [(WIDTH > 0 ? WIDTH : 1)-1:0] field_o
);
  wire unused_others = &{1'b0, bus_i};

  generate
    if (WIDTH > 0) begin : present
      assign field_o = bus_i[AT +: WIDTH];
    end else begin : absent
      assign field_o = 1'b0;
    end
  endgenerate
endmodule
`default_nettype wire
