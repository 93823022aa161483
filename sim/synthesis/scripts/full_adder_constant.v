// Techmap: a full adder with a constant pin becomes gates. That may make a pin of the next one constant, so this is
// repeated, with opt after each time.
(* techmap_celltype = "full_adder" *)
module wrinkle_map_full_adder_constant (A, B, C, X, Y);
  input A, B, C;
  output X, Y;
  parameter _TECHMAP_CONSTMSK_A_ = 1'b0;
  parameter _TECHMAP_CONSTMSK_B_ = 1'b0;
  parameter _TECHMAP_CONSTMSK_C_ = 1'b0;
  wire _TECHMAP_FAIL_ = !(_TECHMAP_CONSTMSK_A_ || _TECHMAP_CONSTMSK_B_ || _TECHMAP_CONSTMSK_C_);

  wire half = A ^ B;
  assign Y = half ^ C;
  assign X = (A & B) | (C & half);
endmodule
