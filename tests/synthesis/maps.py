#!/usr/bin/env python3
"""The modules of sim/synthesis/maps compute what the modules of the same names in rtl/ do, for every input.

  maps.py                  the widths of some normalizers
  maps.py --every-width    those of every normalizer that a legal configuration can have, long
  maps.py --mutants        a fault planted in each map must be found

Yosys elaborates normalizers of chosen widths twice, from the plain Verilog and with the maps in place, and so finds the
parameters with which each module is asked for.

Sums (`truncated_...`) are proven by algebra, since no solver finishes a product of 20 bits by 20 bits. The value of
`sum` is a polynomial in its bits; modulo 2^(its width), the outputs of each cell are replaced by what its inputs say: a
full adder by 2 X + Y = A + B + C, an adder or a multiplier by the sum or product of its operands, a gate by its
polynomial (b^2 = b), until only the bits of ports are left. Equal polynomials are equal values. The other modules are
small enough for the solver of Yosys; where there are registers, what goes into each is compared.
"""

import argparse
import collections
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
MAPS = ROOT / "sim" / "synthesis" / "maps"
SUMS = ["wrinkle_truncated_squares", "wrinkle_truncated_product", "wrinkle_truncated_segment"]
SOLVED = ["wrinkle_multiple", "wrinkle_magnitude", "wrinkle_signed", "wrinkle_block_shift", "wrinkle_table",
          "wrinkle_dda_in_place"]
PARTS = ["wrinkle_bit_heap", "wrinkle_bit_heap_column", "wrinkle_leading_zeros"]  # of other modules
KINDS = {"compact": 2, "lite": 3}  # `near` has the widths of `compact`


class Refused(Exception):
    """The map is not proven equal."""


def run_yosys(script, folder):
    path = folder / "script.ys"
    path.write_text(script)
    done = subprocess.run(["yosys", "-q", "-s", str(path)], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def sources(maps):
    plain = sorted(p for p in (ROOT / "rtl").rglob("*.v"))
    if maps is None:
        return plain
    mapped = sorted(maps.glob("*.v"))
    return mapped + [p for p in plain if not (maps / p.name).exists()]


def read_script(maps, widths, folder):
    """Yosys commands after which only the modules to compare are left, of the widths that a top asks for."""
    top = folder / "top.v"
    instances = "".join(
        f"  wrinkle_compact_normalizer #(.KIND({KINDS[kind]}), .UNIT_BITS({f}), .VECTOR_BITS({v})) "
        f"{kind}_{f}_{v} (.clk(), .advance_i(), .vector_i(), .unit_o(), .zero_o());\n"
        for kind, f, v in widths)
    tables = "".join(
        f"  wrinkle_reciprocal #(.INPUT_BITS({q}), .OUTPUT_BITS({r})) r_{q}_{r} "
        "(.clk(), .advance_i(), .m_i(), .r_o());\n"
        for q, r in [(8, 8), (13, 12)])
    tables += "  wrinkle_rsqrt #(.INPUT_BITS(12)) root (.clk(), .advance_i(), .t_i(), .r_o());\n"
    tables += "".join(f"  wrinkle_dda_in_place #(.WIDTH({w}), .GUARD({g}), .SHARING({s})) d_{w}_{g}_{s} (.clk());\n"
                      for w, g, s in [(8, 7, 1), (11, 10, 0)])
    top.write_text(f"module top ();\n{instances}{tables}endmodule\n")
    includes = " ".join(f"-I{p}" for p in sorted({p.parent for p in (ROOT / "rtl").rglob("*.vh")}))
    names = " ".join(f"*{name}*" for name in SUMS + SOLVED + PARTS)
    return (f"read_verilog -icells -defer {includes} {' '.join(map(str, sources(maps)))} {top}\nhierarchy -top top\n"
            f"select -set kept {names}\nselect -set others @kept %n\ndelete @others\n"
            "proc\n")


def elaborate(maps, widths, folder):
    """The modules by name, as Yosys writes them."""
    out = folder / "design.json"
    whole = f"setattr -mod -set keep_hierarchy 1 {' '.join(f'*{name}*' for name in SUMS + SOLVED)}\n"
    script = read_script(maps, widths, folder) + whole + f"flatten\nopt_expr\nopt_clean\nwrite_json {out}\n"
    code, text = run_yosys(script, folder)
    if code != 0:
        raise Refused(f"Yosys: {text[-2000:]}")
    return json.loads(out.read_text())["modules"]


def base_name(module):
    return next(name for name in SUMS + SOLVED + PARTS if module.split("\\")[-1] == name or f"\\{name}\\" in module)


class Polynomial:
    """Monomials (sets of bits, each 0 or 1) with coefficients modulo 2^width."""

    def __init__(self, width):
        self.modulus = 1 << width
        self.terms = {}
        self.users = collections.defaultdict(set)

    def add(self, monomial, coefficient):
        value = (self.terms.get(monomial, 0) + coefficient) % self.modulus
        if value:
            self.terms[monomial] = value
            for bit in monomial:
                self.users[bit].add(monomial)
        elif monomial in self.terms:
            del self.terms[monomial]
            for bit in monomial:
                self.users[bit].discard(monomial)

    def linear(self, bit):
        """Takes out a bit that stands only alone; its coefficient."""
        if isinstance(bit, str):
            raise Refused("constant output")
        if any(len(monomial) > 1 for monomial in self.users[bit]):
            raise Refused(f"bit {bit} of an adder stands in a product")
        coefficient = self.terms.get(frozenset([bit]), 0)
        self.add(frozenset([bit]), -coefficient)
        return coefficient

    def substitute(self, bit, polynomial):
        for monomial in list(self.users[bit]):
            coefficient = self.terms[monomial]
            self.add(monomial, -coefficient)
            for factor, k in polynomial.items():
                self.add((monomial - {bit}) | factor, coefficient * k)


def value_of(bits):
    """A vector, its first bit of weight 1, as a polynomial."""
    value = collections.defaultdict(int)
    for i, bit in enumerate(bits):
        if bit in ("x", "z"):
            raise Refused("undriven bit")
        if bit != "0":
            value[frozenset() if bit == "1" else frozenset([bit])] += 1 << i
    return value


def times(a, b):
    product = collections.defaultdict(int)
    for m, x in a.items():
        for n, y in b.items():
            product[m | n] += x * y
    return product


def plus(a, b, sign=1):
    total = collections.defaultdict(int, a)
    for m, x in b.items():
        total[m] += sign * x
    return total


def logic(kind, pins):
    """The polynomial of each output bit of a bitwise cell."""
    out = []
    for k in range(len(pins["Y"])):
        bit = {name: value_of([bits[k] if k < len(bits) else "0"]) for name, bits in pins.items() if name not in "SY"}
        if kind == "$not":
            out.append(plus({frozenset(): 1}, bit["A"], -1))
        elif kind == "$and":
            out.append(times(bit["A"], bit["B"]))
        elif kind == "$or":
            out.append(plus(plus(bit["A"], bit["B"]), times(bit["A"], bit["B"]), -1))
        elif kind == "$mux":
            s = value_of(pins["S"])
            out.append(plus(bit["A"], times(s, plus(bit["B"], bit["A"], -1))))
        else:
            raise Refused(f"cell {kind} is not known")
    return out


def word(polynomial, bits, exact):
    """Takes the whole word `bits` out of the polynomial; what one of its units counts there."""
    coefficients = [polynomial.linear(bit) for bit in bits]
    unit = coefficients[0]
    if any((c - (unit << k)) % polynomial.modulus for k, c in enumerate(coefficients)):
        raise Refused("only a part of a sum is used")
    if not exact and (unit << len(bits)) % polynomial.modulus:
        raise Refused("a carry out of a sum is lost")
    return unit


def expand(polynomial, name, cell):
    """Replaces the outputs of a cell by its inputs."""
    kind, pins = cell["type"], cell["connections"]
    if kind == "$fa":
        for a, b, c, x, y in zip(*(pins[p] for p in "ABCXY")):
            unit = polynomial.linear(y)
            if (polynomial.linear(x) - 2 * unit) % polynomial.modulus:
                raise Refused(f"carry and sum of {name} do not weigh 2 : 1")
            for bit in (a, b, c):
                for monomial, k in value_of([bit]).items():
                    polynomial.add(monomial, unit * k)
    elif kind in ("$add", "$sub", "$mul"):
        if any(int(cell["parameters"].get(p, "0"), 2) for p in ("A_SIGNED", "B_SIGNED")):
            raise Refused(f"{name} is signed")
        widths = [len(pins[p]) for p in "ABY"]
        exact = (kind == "$mul" and widths[2] >= widths[0] + widths[1]) or (
            kind == "$add" and widths[2] > max(widths[:2]))
        unit = word(polynomial, pins["Y"], exact)
        a, b = value_of(pins["A"]), value_of(pins["B"])
        value = times(a, b) if kind == "$mul" else plus(a, b, 1 if kind == "$add" else -1)
        for monomial, k in value.items():
            polynomial.add(monomial, unit * k)
    elif kind.startswith("$paramod") or kind.startswith("wrinkle_"):
        if base_name(kind) != "wrinkle_multiple":
            raise Refused(f"module {kind} in a sum")
        digit, value = pins["digit_i"], pins["value_i"]
        for k, bit in enumerate(pins["multiple_o"]):
            if digit[1] == "0":  # once or not at all
                polynomial.substitute(bit, times(value_of([digit[0]]), value_of(value[k:k + 1])))
            else:
                polynomial.substitute(bit, {frozenset([(tuple(digit), tuple(value), k)]): 1})
    else:
        for bit, meaning in zip(pins["Y"], logic(kind, pins)):
            polynomial.substitute(bit, meaning)


def outputs_of(cell):
    return {bit for pin, bits in cell["connections"].items()
            if cell["port_directions"].get(pin, "output" if pin in ("X", "Y") else "input") == "output" for bit in bits}


def from_the_outputs(cells):
    """Every cell before those that drive it."""
    driver = {bit: name for name, cell in cells.items() for bit in outputs_of(cell)}
    order, seen = [], set()
    for start in cells:
        stack = [(start, False)]
        while stack:
            name, done = stack.pop()
            if done:
                order.append(name)
            elif name not in seen:
                seen.add(name)
                stack.append((name, True))
                inputs = {bit for bits in cells[name]["connections"].values() for bit in bits} - outputs_of(cells[name])
                stack.extend((driver[bit], False) for bit in inputs if bit in driver)
    return reversed(order)


def meaning(module):
    """The sum, of which the output is the leading bits, as a polynomial in bits of ports."""
    nets, ports = module["netnames"], module["ports"]
    total = nets["sum_o" if "sum_o" in ports else "sum"]["bits"]
    polynomial = Polynomial(len(total))
    for monomial, k in value_of(total).items():
        polynomial.add(monomial, k)
    for name in from_the_outputs(module["cells"]):
        expand(polynomial, name, module["cells"][name])
    port_of = {bit: (name, i) for name, port in ports.items() if port["direction"] == "input"
               for i, bit in enumerate(port["bits"])}

    def named(bit):
        return port_of[bit] if bit in port_of else (named_all(bit[0]), named_all(bit[1]), bit[2])

    def named_all(bits):
        return tuple(bit if isinstance(bit, str) else port_of[bit] for bit in bits)

    terms = {frozenset(named(bit) for bit in monomial): k for monomial, k in polynomial.terms.items()}
    for name, port in ports.items():
        if port["direction"] == "output" and port["bits"] != total[-len(port["bits"]):]:
            raise Refused(f"{name} is not the leading bits of the sum")
    return terms


def prove_sums(plain, mapped):
    count = 0
    for name, module in plain.items():
        if base_name(name) not in SUMS:
            continue
        if name not in mapped:
            raise Refused(f"{name} has no map")
        if meaning(module) != meaning(mapped[name]):
            raise Refused(f"{name} is not what its map computes")
        count += 1
    return count


def prove_solved(maps, widths, names, folder):
    script = ""
    for design, folder_of_maps in (("plain", None), ("mapped", maps)):
        sub = folder / design
        sub.mkdir(exist_ok=True)
        script += read_script(folder_of_maps, widths, sub) + f"flatten\nopt_clean\ndesign -save {design}\n" + "design -reset\n"
    for name in names:
        script += (f"design -copy-from plain -as plain {name}\ndesign -copy-from mapped -as mapped {name}\n"
                   "memory_map\nexpose -dff -evert-dff plain mapped\nmiter -equiv -flatten -make_assert plain mapped miter\n"
                   "sat -verify -prove-asserts miter\ndesign -reset\n")
    code, text = run_yosys(script, folder)
    if code != 0:
        raise Refused(text[-1500:])
    return len(names)


def prove(maps, widths):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        plain, mapped = (elaborate(m, widths, folder) for m in (None, maps))
        sums = prove_sums(plain, mapped)
        solved = prove_solved(maps, widths, [n for n in plain if base_name(n) in SOLVED], folder)
        adders = any(cell["type"] == "$fa" for module in mapped.values() for cell in module["cells"].values())
        if sums == 0 or solved == 0 or not adders:
            raise Refused("nothing was compared")
        return sums, solved


MUTANTS = {
    "wrinkle_bit_heap_column": [("assign a = bits_i[3*j]", "assign a = bits_i[(3*j+1)%COUNT]")],
    "wrinkle_bit_heap": [("rows_i[i*COLUMNS+c]", "rows_i[i*COLUMNS+(c==5?4:c)]")],
    "wrinkle_truncated_squares": [("if (b >= CUT)", "if (b > CUT)")],
    "wrinkle_truncated_product": [("2 * a + b >= CUT", "2 * a + b >= CUT + 1")],
    "wrinkle_truncated_segment": [("a + b >= DROPPED_COLUMNS", "a + b >= DROPPED_COLUMNS - 1")],
    "wrinkle_multiple": [("once + twice", "once | twice")],
    "wrinkle_magnitude": [("value[BITS] & ~|value[BITS-1:0]", "1'b0")],
    "wrinkle_signed": [("negative & magnitude[a-1]", "magnitude[a-1]")],
    "wrinkle_block_shift": [("i >= HOP && i >= BITS - HOP", "i >= HOP && i >= BITS - HOP - 1")],
    "wrinkle_dda_in_place": [("to_row ? next_row_value", "to_pixel ? next_row_value")],
    "wrinkle_table": [("CONTENT[i*ENTRY_BITS +: ENTRY_BITS]", "CONTENT[i*ENTRY_BITS +: ENTRY_BITS] ^ (i == 3)")],
}


def try_mutants(widths):
    missed = {p.stem for p in MAPS.glob("*.v")} - MUTANTS.keys()
    for module, changes in MUTANTS.items():
        for before, after in changes:
            with tempfile.TemporaryDirectory() as name:
                maps = pathlib.Path(name) / "maps"
                shutil.copytree(MAPS, maps)
                text = (maps / f"{module}.v").read_text()
                if before not in text:
                    raise SystemExit(f"{module}: no {before!r} to be changed")
                (maps / f"{module}.v").write_text(text.replace(before, after))
                try:
                    prove(maps, widths)
                    missed.add(module)
                    print(f"NOT FOUND {module}: {after}")
                except Refused as refused:
                    print(f"found {module}: {after}: {str(refused).strip().splitlines()[-1][:120]}", flush=True)
    return missed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--every-width", action="store_true")
    parser.add_argument("--mutants", action="store_true")
    options = parser.parse_args()
    if options.mutants:
        sys.exit(1 if try_mutants([("compact", 7, 7)]) else 0)
    some = [("compact", 6, 6), ("compact", 8, 6), ("compact", 9, 9), ("compact", 10, 13), ("compact", 16, 5),
            ("lite", 8, 9)]
    groups = [some] if not options.every_width else [
        [(kind, f, v) for kind in KINDS for v in range(5, 24)] for f in range(6, 17)]
    for group in groups:
        try:
            sums, solved = prove(MAPS, group)
        except Refused as refused:
            sys.exit(f"NOT EQUAL {group[0]} to {group[-1]}: {refused}")
        print(f"{group[0]} to {group[-1]}: {sums} sums, {solved} other modules proven equal", flush=True)


if __name__ == "__main__":
    main()
