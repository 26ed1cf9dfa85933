/** What can be wrong with formulas that are well spelt: division by zero, values that are not real or infinite, a wrong sum. */

import type { Parameter } from "./formulas";
import { children, type Node } from "./grammar";
import { Tape } from "./tape";

const MOST_CORNERS = 64, BETWEEN = 7, INSET = 1e-3, ZERO = 1e-9, LARGEST = 1e12, STEPS = 64;
/** Parameters t, denser at the ends. */
const SAMPLES = Array.from({ length: STEPS + 1 }, (_, i) => 0.5 - 0.5 * Math.cos((Math.PI * i) / STEPS));

type Sample = readonly number[];

/** Error, naming function and place, where formulas have no finite real value in the range of the parameters. */
export function checkValues(trees: readonly Node[], parameters: readonly Parameter[]): void {
  const samples = corners(parameters);
  trees.forEach((tree, index) => {
    for (const [inner, isRoot, what] of delicate(tree)) {
      const at = zero(inner, isRoot, samples, parameters);
      if (at) throw new Error(`functions[${index}]: ${what} ${at}; rewrite it, or narrow the range of the parameters`);
    }
  });
  const all = samples.map((sample) => valuesAt(trees, parameters, sample));
  trees.forEach((_, index) => all.forEach((rows, k) => rows.forEach((row, i) => {
    if (Math.abs(row[index]!) <= LARGEST) return;
    const at = place(parameters, samples[k]!, SAMPLES[i]!);
    throw new Error(`functions[${index}]: expected values of size at most ${LARGEST.toExponential()}, found none such ${at}; rewrite it, or narrow the range`);
  })));
}

/** By how much the sum of the functions misses 1 at worst, relative to the largest, and where. */
export function sums(trees: readonly Node[], parameters: readonly Parameter[]): { by: number; told: string } {
  let by = -1, told = "";
  for (const sample of corners(parameters)) {
    valuesAt(trees, parameters, sample).forEach((row, i) => {
      const found = row.reduce((sum, x) => sum + x, 0), off = Math.abs(found - 1) / Math.max(1, ...row.map(Math.abs));
      if (off > by) [by, told] = [off, `their sum is ${Number(found.toPrecision(12))} ${place(parameters, sample, SAMPLES[i]!)}`];
    });
  }
  return { by, told };
}

/** Samples of the range: its corners (some of many), its centre and points between. */
function corners(parameters: readonly Parameter[]): Sample[] {
  const count = parameters.length, bits = Array.from({ length: count }, (_, i) => i);
  const ends = 2 ** count <= MOST_CORNERS
    ? Array.from({ length: 2 ** count }, (_, n) => bits.map((i) => (n >> (count - 1 - i)) & 1))
    : Array.from({ length: MOST_CORNERS }, (_, n) => bits.map((i) => (n < 2 ? n : scattered(n, i) < 0.5 ? 0 : 1)));
  const between = count ? Array.from({ length: BETWEEN }, (_, n) => bits.map((i) => scattered(n + 1, i))) : [];
  return [...ends, bits.map(() => 0.5), ...between].map((shares) => parameters.map(({ low, high, open }, i) => {
    const from = low + INSET * (high - low) * Number(open[0]), to = high - INSET * (high - low) * Number(open[1]);
    return from + (to - from) * shares[i]!;
  }));
}

/** A share from 0 to 1 that looks like chance, the same every time. */
const scattered = (n: number, i: number): number => ((n + 1) * 0.754877666 + (i + 1) * (n + 3) * 0.569840291) % 1;

const valuesOf = (parameters: readonly Parameter[], sample: Sample) => Object.fromEntries(parameters.map(({ name }, i) => [name, sample[i]!]));

/** The values of trees at all SAMPLES. */
function valuesAt(trees: readonly Node[], parameters: readonly Parameter[], sample: Sample): number[][] {
  const tape = new Tape(trees, valuesOf(parameters, sample));
  return SAMPLES.map((t) => tape.at(t, 0).map((x) => x[0]!));
}

/** The denominators and radicands in a tree, those inside first. */
function* delicate(node: Node): Generator<readonly [Node, boolean, string]> {
  for (const child of children(node)) yield* delicate(child);
  if (node.is === "binary" && node.sign === "/") yield [node.right, false, "divides by zero"];
  if (node.is === "call" && node.name === "sqrt") yield [node.argument, true, "takes the root of a number that is not positive"];
}

/** Where a denominator, or a radicand, vanishes or changes sign; nothing where it does not. */
function zero(inner: Node, isRoot: boolean, samples: readonly Sample[], parameters: readonly Parameter[]): string {
  const all = samples.map((sample) => valuesAt([inner], parameters, sample).map((row) => row[0]!));
  if (!all.every((values) => values.every(Number.isFinite))) return ""; // told as a value that is not finite
  for (const [k, values] of all.entries()) {
    const largest = Math.max(...values.map(Math.abs)), i = values.findIndex((x) => Math.abs(x) <= ZERO * largest || (isRoot && x < 0));
    if (i >= 0) return place(parameters, samples[k]!, SAMPLES[i]!);
  }
  const signs = all.map((values) => values.map(Math.sign)), both = [-1, 1].every((sign) => signs.some((row) => row.includes(sign)));
  for (const [k, row] of both ? signs.entries() : []) {
    const i = row.findIndex((sign, at) => at + 1 < row.length && row[at + 1] !== sign);
    if (i >= 0) return place(parameters, samples[k]!, 0.5 * (SAMPLES[i]! + SAMPLES[i + 1]!), "near");
  }
  const measure = (values: readonly number[]) => Math.min(...(isRoot ? values : values.map(Math.abs)));
  const least = all.map(measure), worst = least.indexOf(Math.min(...least)), values = all[worst]!;
  const column = values.findIndex((x) => (isRoot ? x : Math.abs(x)) === least[worst]);
  if (both) return place(parameters, samples[worst]!, SAMPLES[column]!, "near");
  return touched(inner, samples[worst]!, column, ZERO * Math.max(...values.map(Math.abs)), parameters);
}

/** Where values touch zero between two samples about the least of them; nothing where they do not. */
function touched(inner: Node, sample: Sample, column: number, small: number, parameters: readonly Parameter[]): string {
  let low = SAMPLES[Math.max(column - 1, 0)]!, high = SAMPLES[Math.min(column + 1, STEPS)]!;
  const tape = new Tape([inner], valuesOf(parameters, sample));
  for (let round = 0; round < 4; round++) {
    const t = SAMPLES.map((_, i) => low + ((high - low) * i) / STEPS), near = t.map((x) => Math.abs(tape.at(x, 0)[0]![0]!));
    const best = near.indexOf(Math.min(...near));
    if (near[best]! <= small) return place(parameters, sample, t[best]!, "near");
    [low, high] = [t[Math.max(best - 1, 0)]!, t[Math.min(best + 1, STEPS)]!];
  }
  return "";
}

function place(parameters: readonly Parameter[], sample: Sample, t: number, near = "at"): string {
  const digits = (x: number) => String(Number(x.toPrecision(4)));
  return [`${near} t = ${digits(t)}`, ...parameters.map(({ name }, i) => `${name} = ${digits(sample[i]!)}`)].join(", ");
}
