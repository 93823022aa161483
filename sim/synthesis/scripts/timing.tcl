# Critical path of a netlist without wires: 1000 ns less the worst slack, from any input or flip-flop to any output or
# flip-flop. @...@ is filled in by synthesis.cpp.
read_liberty @LIBERTY@
read_verilog @FOLDER@/netlist.v
link_design @TOP@
set clock [get_ports -quiet clk]
if {$clock ne ""} {
  create_clock -name clk -period 1000 $clock
} else {
  create_clock -name clk -period 1000
}
set_input_delay 0 -clock clk [all_inputs]
set_output_delay 0 -clock clk [all_outputs]
puts "critical_path_ns [expr 1000 - [worst_slack -max]]"
report_checks -path_delay max -format full
exit
