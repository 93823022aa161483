// A register of BITS bits, at most 64, that starts in bit `place` of the planes part of a packet: what is in it after the
// clock in which `words` says that `word` is of that part, and which one.
function [BITS-1:0] written;
  input [BITS-1:0] old;
  input integer    place;
  input [WORDS:0]  words;  // a bit each; none beyond the last
  input [63:0]     word;
  reg [BITS-1:0] low, takes;  // low: of the two words in which it may lie, what is in the first
  reg [127:0]    twice;
  begin
    low     = ~({BITS{1'b1}} << (64 - place % 64));
    takes   = (low & {BITS{words[place/64]}}) | (~low & {BITS{words[place/64+1]}});
    twice   = {word, word};
    written = (takes & twice[place%64 +: BITS]) | (~takes & old);
  end
endfunction
