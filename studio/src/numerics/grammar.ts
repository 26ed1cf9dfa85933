/**
 * The small grammar in which the functions of a basis are written, read as Python reads it (basis/grammar.py): the same
 * trees, the same messages. Differences that would cancel, such as 1 - s or x - sin(x), are nodes of their own.
 */

/** A number, a name, an operation, a whole power, or a function of an argument. */
export type Node =
  | { readonly is: "number"; readonly value: number }
  | { readonly is: "name"; readonly name: string }
  | { readonly is: "binary"; readonly sign: string; readonly left: Node; readonly right: Node }
  | { readonly is: "power"; readonly base: Node; readonly exponent: number }
  | { readonly is: "call"; readonly name: string; readonly argument: Node };

/** The names that stand for functions of t: t, 1 - t, sin and cos of πt/2, and what these two lack of 1. */
export const VARIABLES: readonly string[] = ["t", "r", "s", "c", "a", "b"];
const FUNCTIONS: readonly string[] = ["sin", "cos", "sinh", "cosh", "sqrt", "exp"];
/** Names that no parameter may have. */
export const RESERVED: readonly string[] = [...VARIABLES, "pi", ...FUNCTIONS];

const LONGEST = 4000, DEEPEST = 40, HIGHEST_POWER = 64, LARGEST_TREE = 200;
const TOKEN = /\s*(?:(?<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)|(?<name>[\p{L}_][\p{L}\p{N}_]*)|(?<sign>\*\*|.))/suy;
const COMPLEMENT: Readonly<Record<string, string>> = { s: "a", c: "b", t: "r", a: "s", b: "c", r: "t" };

/** The tree of a formula; Error naming the character (from 1), what was expected and what was found. */
export function parse(text: unknown, parameters: readonly string[] = []): Node {
  if (typeof text !== "string") throw new Error(`expected a formula in quotation marks, found ${JSON.stringify(text)}`.slice(0, 200));
  if (text.length > LONGEST) throw new Error(`expected at most ${LONGEST} characters, found ${text.length}; shorten the formula`);
  return new Parser(text, parameters).whole();
}

/** The nodes that a node is made of. */
export function children(node: Node): readonly Node[] {
  if (node.is === "binary") return [node.left, node.right];
  return node.is === "power" ? [node.base] : node.is === "call" ? [node.argument] : [];
}

type Levelled = readonly [Node, number];

/** One pass over the tokens of one formula. */
class Parser {
  private place = 0;
  private depth = 0;
  private kind = "";
  private token = "";
  private start = 0;

  constructor(private readonly text: string, private readonly parameters: readonly string[]) {
    this.advance();
  }

  whole(): Node {
    const [node] = this.sum();
    if (this.kind) this.fail("expected an operator + - * / ^ or the end", this.kind === "sign" ? this.remedy() : "write 2*t for a product");
    return node;
  }

  private advance(): void {
    TOKEN.lastIndex = this.place;
    const groups = TOKEN.exec(this.text)?.groups;
    const found = Object.entries(groups ?? {}).find(([, token]) => token !== undefined && token.trim() !== "");
    [this.kind, this.token] = found ?? ["", ""]; // only blanks are left
    this.start = found ? TOKEN.lastIndex - this.token.length : this.text.trimEnd().length;
    if (found) this.place = TOKEN.lastIndex;
  }

  private fail(expected: string, remedy = ""): never {
    const found = this.kind ? quoted(this.token.slice(0, 40)) : "the end of the formula";
    throw new Error(`character ${this.start + 1}: ${expected}, found ${found}${remedy ? `; ${remedy}` : ""}`);
  }

  private sign(signs: string): boolean {
    return this.kind === "sign" && this.token.length === 1 && signs.includes(this.token);
  }

  private sum(): Levelled {
    return this.chain("+-", () => this.product());
  }

  private product(): Levelled {
    return this.chain("*/", () => this.factor());
  }

  private chain(signs: string, next: () => Levelled): Levelled {
    let [left, level] = next();
    while (this.sign(signs)) {
      const sign = this.token;
      this.advance();
      const [right, other] = next();
      [left, level] = [binary(sign, left, right), this.higher(level, other)];
    }
    return [left, level];
  }

  private factor(): Levelled {
    if (this.sign("-")) {
      this.deeper();
      this.advance();
      const [node, level] = this.factor();
      this.depth--;
      const minus: Node = { is: "number", value: node.is === "number" ? -node.value : -1 };
      return [node.is === "number" ? minus : { is: "binary", sign: "*", left: minus, right: node }, this.higher(level)];
    }
    let [node, level] = this.atom();
    if (this.token === "**") this.fail("expected an operator + - * / ^", "write ^ for a power");
    if (this.sign("^")) {
      this.advance();
      [node, level] = [{ is: "power", base: node, exponent: this.exponent() }, this.higher(level)];
      if (this.sign("^") || this.token === "**") this.fail("expected one power only", "set parentheses: (x^2)^3");
    }
    return [node, level];
  }

  private exponent(): number {
    if (this.kind !== "number" || !/^\d+$/.test(this.token)) {
      this.fail(`expected a whole power from 0 to ${HIGHEST_POWER}`, "write products, quotients or sqrt for others");
    }
    const value = Number(this.token);
    if (this.token.length > 4 || value > HIGHEST_POWER) this.fail(`expected a power of at most ${HIGHEST_POWER}`, "lower it");
    this.advance();
    return value;
  }

  private atom(): Levelled {
    if (this.kind === "number") {
      const value = Number(this.token);
      if (value > 1e100) this.fail("expected a number of at most 1e100");
      this.advance();
      return [{ is: "number", value }, 1];
    }
    if (this.kind === "name") return this.named();
    if (this.sign("(")) return this.bracket();
    return this.fail("expected a number, a name or '('", this.remedy());
  }

  private named(): Levelled {
    const name = this.token;
    if (FUNCTIONS.includes(name)) {
      this.advance();
      if (this.token !== "(") this.fail(`expected '(' after ${name}`, `write ${name}(...)`);
      const [argument, level] = this.bracket();
      return [{ is: "call", name, argument }, this.higher(level)];
    }
    const known = [...VARIABLES, "pi", ...this.parameters];
    if (!known.includes(name)) {
      const called = /^\s*\(/.test(this.text.slice(this.place));
      const list = called ? FUNCTIONS : known, near = closest(name, list);
      const hint = near ? `did you mean ${quoted(near)}?` : called ? "" : "list it under parameters";
      this.fail(`expected ${called ? "a function" : "a name"}, one of ${list.join(", ")}`, hint);
    }
    this.advance();
    if (this.sign("(")) this.fail("expected an operator + - * / ^", "write t*(...) for a product");
    return [{ is: "name", name }, 1];
  }

  private bracket(): Levelled {
    this.deeper();
    this.advance();
    const found = this.sum();
    if (this.token !== ")") this.fail("expected ')'", this.remedy());
    this.advance();
    this.depth--;
    return found;
  }

  private deeper(): void {
    if (++this.depth > DEEPEST) this.fail(`expected at most ${DEEPEST} levels of nesting`, "simplify the formula");
  }

  private higher(...levels: number[]): number {
    const level = Math.max(...levels) + 1;
    if (level > LARGEST_TREE) this.fail(`expected at most ${LARGEST_TREE} terms or factors in a row`, "simplify the formula");
    return level;
  }

  private remedy(): string {
    if ([".", "[", "{", "_", "'", '"', ";", ":", "@", "=", "!", "`"].includes(this.token)) {
      return "a formula holds numbers, names, + - * / ^ and parentheses only";
    }
    return this.token === "," ? "write one argument only" : "";
  }
}

/** The node of an operation, in a form that does not cancel where there is one. */
function binary(sign: string, left: Node, right: Node): Node {
  const same = (x: Node, y: Node) => JSON.stringify(x) === JSON.stringify(y);
  const one = (node: Node) => node.is === "number" && node.value === 1;
  const call = (name: string, argument: Node): Node => ({ is: "call", name, argument });
  if (sign === "-" && one(left)) {
    if (right.is === "name" && COMPLEMENT[right.name]) return { is: "name", name: COMPLEMENT[right.name]! };
    if (right.is === "call" && right.name === "cos") return call("versin", right.argument);
  }
  if (sign === "-" && right.is === "call" && right.name === "sin" && same(right.argument, left)) return call("sinrest", left);
  if (sign === "-" && left.is === "call") {
    if (left.name === "cosh" && one(right)) return call("coshless", left.argument);
    if (left.name === "sinh" && same(left.argument, right)) return call("sinhrest", right);
  }
  return { is: "binary", sign, left, right };
}

/** A text in quotation marks, as Python spells it. */
export function quoted(text: string): string {
  const mark = text.includes("'") && !text.includes('"') ? '"' : "'";
  return mark + text.replaceAll("\\", "\\\\").replaceAll("\n", "\\n").replaceAll(mark, `\\${mark}`) + mark;
}

/** The known word that is spelt most like another (Ratcliff and Obershelp 1988), or nothing when none is near. */
export function closest(word: string, known: readonly string[]): string {
  const rated = known.map((one) => [(2 * common(one, word)) / (one.length + word.length), one] as const).filter(([rate]) => rate >= 0.6);
  return rated.sort(([p, x], [q, y]) => q - p || (x < y ? 1 : -1))[0]?.[1] ?? "";
}

/** How many letters two words share: in their longest common piece, and to its left and right. */
function common(x: string, y: string): number {
  for (let size = Math.min(x.length, y.length); size > 0; size--) {
    for (let i = 0; i + size <= x.length; i++) {
      const k = y.indexOf(x.slice(i, i + size));
      if (k >= 0) return size + common(x.slice(0, i), y.slice(0, k)) + common(x.slice(i + size), y.slice(k + size));
    }
  }
  return 0;
}
