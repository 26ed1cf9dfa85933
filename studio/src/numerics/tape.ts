/** Formulas as a tape of operations: numbers folded, shared parts done once; run in Taylor arithmetic of any order. */

import { cosine, sinCos, sine } from "./functions";
import { VARIABLES, type Node } from "./grammar";
import { exponential, over, rest, root, times, waves, type Series } from "./series";

/** What an operation does, on which operations before it, and with which number. */
interface Operation {
  readonly name: string;
  readonly x: number;
  readonly y: number;
  readonly value: number;
}

type Values = Readonly<Record<string, number>>;
/** A number, or the place of the operation that gives a series. */
type Found = { readonly number: number } | { readonly at: number };

const CALLS: Readonly<Record<string, (x: Series, out: Series) => void>> = {
  sin: (x, out) => out.set(waves(x, false).sine),
  cos: (x, out) => out.set(waves(x, false).cosine),
  versin: (x, out) => out.set(waves(x, false).versine),
  sinrest: (x, out) => rest(x, false, out),
  sinh: (x, out) => out.set(waves(x, true).sine),
  cosh: (x, out) => out.set(waves(x, true).cosine),
  coshless: (x, out) => out.set(waves(x, true).versine),
  sinhrest: (x, out) => rest(x, true, out),
  sqrt: root,
  exp: exponential,
};

/** The value of a function of the grammar at a number. */
function called(name: string, x: number): number {
  const out = new Float64Array(1);
  CALLS[name]!(Float64Array.of(x), out);
  return out[0]!;
}

/** The operations that trees come down to at values of the parameters, and the places of their results. */
export class Tape {
  private readonly operations: Operation[] = [];
  private readonly places = new Map<string, number>();
  private readonly found = new Map<Node, Found>();
  private readonly roots: readonly number[];
  private registers: Series[] = [];

  constructor(trees: readonly Node[], private readonly values: Values) {
    this.roots = trees.map((tree) => this.placed(this.node(tree)));
  }

  /** The Taylor series of the trees at t up to an order, one each; they hold until the next call. */
  at(t: number, order: number): readonly Series[] {
    if (this.registers[0]?.length !== order + 1) this.registers = this.operations.map(() => new Float64Array(order + 1));
    const { registers } = this;
    sinCos(t);
    const s = sine, c = cosine;
    this.operations.forEach(({ name, x, y, value }, i) => {
      const out = registers[i]!, p = registers[x]!, q = registers[y]!;
      switch (name) {
        case "t":
        case "r":
          out.fill(0);
          out[0] = name === "t" ? t : 1 - t;
          if (order) out[1] = name === "t" ? 1 : -1;
          break;
        case "s": return turning(s, c, out);
        case "c": return turning(c, -s, out);
        case "a": return turning(-s, -c, out, 2 * Math.sin(0.25 * Math.PI * (1 - t)) ** 2);
        case "b": return turning(-c, s, out, 2 * Math.sin(0.25 * Math.PI * t) ** 2);
        case "number":
          out.fill(0);
          out[0] = value;
          break;
        case "add":
          for (let k = 0; k <= order; k++) out[k] = p[k]! + q[k]!;
          break;
        case "subtract":
          for (let k = 0; k <= order; k++) out[k] = p[k]! - q[k]!;
          break;
        case "multiply": return times(p, q, out);
        case "divide": return over(p, q, out);
        case "scale":
          for (let k = 0; k <= order; k++) out[k] = value * p[k]!;
          break;
        case "shift":
          out.set(p);
          out[0]! += value;
          break;
        default: return CALLS[name]!(p, out);
      }
    });
    return this.roots.map((at) => registers[at]!);
  }

  private put(name: string, x = 0, y = 0, value = 0): Found {
    const key = `${name} ${x} ${y} ${Object.is(value, -0) ? "-0" : value}`, known = this.places.get(key);
    if (known !== undefined) return { at: known };
    this.places.set(key, this.operations.length);
    return { at: this.operations.push({ name, x, y, value }) - 1 };
  }

  private placed(found: Found): number {
    const there = "at" in found ? found : this.put("number", 0, 0, found.number);
    return (there as { at: number }).at;
  }

  private node(node: Node): Found {
    const known = this.found.get(node);
    if (known) return known;
    const made = this.made(node);
    this.found.set(node, made);
    return made;
  }

  private made(node: Node): Found {
    switch (node.is) {
      case "number": return { number: node.value };
      case "name": return VARIABLES.includes(node.name) ? this.put(node.name) : { number: node.name === "pi" ? Math.PI : this.values[node.name]! };
      case "power": return this.power(this.node(node.base), node.exponent);
      case "binary": return this.binary(node.sign, this.node(node.left), this.node(node.right));
      case "call": {
        const x = this.node(node.argument);
        return "number" in x ? { number: called(node.name, x.number) } : this.put(node.name, x.at);
      }
    }
  }

  private binary(sign: string, x: Found, y: Found): Found {
    if ("number" in x && "number" in y) {
      const [p, q] = [x.number, y.number];
      return { number: sign === "+" ? p + q : sign === "-" ? p - q : sign === "*" ? p * q : p / q };
    }
    if ("number" in y) {
      const q = y.number, at = this.placed(x);
      return sign === "*" || sign === "/" ? this.put("scale", at, 0, sign === "*" ? q : 1 / q) : this.put("shift", at, 0, sign === "+" ? q : -q);
    }
    if (sign === "/") return this.put("divide", this.placed(x), y.at);
    if ("number" in x) {
      if (sign === "*") return this.put("scale", y.at, 0, x.number);
      return this.put("shift", sign === "-" ? this.placed(this.put("scale", y.at, 0, -1)) : y.at, 0, x.number);
    }
    return this.put(sign === "+" ? "add" : sign === "-" ? "subtract" : "multiply", x.at, y.at);
  }

  private power(x: Found, exponent: number): Found {
    if ("number" in x) return { number: x.number ** exponent };
    let result: Found | null = null, square: Found = x;
    for (let left = exponent; left; left >>= 1) {
      if (left & 1) result = result ? this.binary("*", result, square) : square;
      if (left > 1) square = this.binary("*", square, square);
    }
    return result ?? { number: 1 };
  }
}

/** Write the series of f with f'' = -(π/2)² f, from f and f' / (π/2); `value` stands in for f itself, as in 1 - sin. */
function turning(f: number, slope: number, out: Series, value = f): void {
  const rate = 0.5 * Math.PI;
  for (let k = 0, factor = 1; k < out.length; k++) {
    out[k] = factor * (k % 4 === 0 ? f : k % 4 === 1 ? slope : k % 4 === 2 ? -f : -slope);
    factor *= rate / (k + 1);
  }
  out[0] = value;
}
