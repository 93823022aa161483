// The cells that the techmaps of full adders pass on to each other.
(* blackbox *) module full_adder (input A, B, C, output X, Y); endmodule
(* blackbox *) module full_adder_carry (input A, B, C, output X); endmodule
(* blackbox *) module full_adder_sum (input A, B, C, output Y); endmodule
