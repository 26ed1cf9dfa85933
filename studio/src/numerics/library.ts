/**
 * Bases by name: those of quintrig, whose formulas come from Python's library (data.json); those that came with a model,
 * as of an installed package or for very many points; and a model's own, from its [bases.NAME] tables.
 */

import data from "../data.json";
import { Bernstein, binomial, MOVING, Trigonometric, type Still } from "./basis";
import { Basis, Formulas, parameterOf, type Parameter } from "./formulas";
import type { Functions } from "./functions";
import { closest, quoted } from "./grammar";

/** A basis for one number of points, as Python tells it: each parameter is name, low, high, start and which ends are open. */
export interface Told {
  readonly functions: readonly string[];
  readonly parameters: readonly (readonly [string, number, number, number, boolean, boolean])[];
}

/** A basis as Python tells it; `formulas` are those that the page holds, by the number of points. */
export interface ToldBasis {
  readonly name: string;
  readonly title: string;
  readonly counts: string;
  readonly sizes: readonly number[];
  readonly usual: number;
  readonly formulas: Readonly<Record<string, Told>>;
}

/** A basis by name, for any number of control points that it has functions for. */
export interface Entry {
  readonly name: string;
  readonly title: string;
  /** How many control points it takes, in words and one by one. */
  readonly counts: string;
  readonly sizes: readonly number[];
  /** Whether the page holds it for so many points. */
  has(points: number): boolean;
  basis(points: number): Basis;
}

const MOST_BASES = 64;
const entries: Record<string, Entry> = {};
const known: Record<string, ToldBasis> = {};

/** All bases by name that are not a model's own. */
export const LIBRARY: Readonly<Record<string, Entry>> = entries;

function entryOf(told: ToldBasis): Entry {
  const made = new Map<number, Basis>();
  const { name, title, counts, sizes, formulas } = told;
  const has = (points: number) => sizes.includes(points) && (points in formulas || name === "bernstein");
  return {
    name, title, counts, sizes, has,
    basis(points) {
      const found = made.get(points);
      if (found) return found;
      if (!has(points)) throw new Error(`points: a page from disk holds no formulas of the ${name} basis for ${points} points; open the model with: quintrig view MODEL`);
      const { functions, parameters } = formulas[points] ?? bernstein(points);
      const basis = new Basis(name, functions, parameters.map(([one, low, high, start, below, above]) => ({ name: one, low, high, start, open: [below, above] as const })), true);
      made.set(points, basis);
      return basis;
    },
  };
}

const bernstein = (points: number): Told => ({
  functions: Array.from({ length: points }, (_, i) => `${binomial(points - 1, i)}*t^${i}*r^${points - 1 - i}`), parameters: [],
});

/** Take up bases that came with a model or a page, beside what is known of them. */
export function learnBases(told: readonly ToldBasis[]): void {
  for (const one of told) {
    const before = known[one.name];
    const whole = before ? { ...before, formulas: { ...before.formulas, ...one.formulas } } : one;
    known[one.name] = whole;
    entries[one.name] = entryOf(whole);
  }
}

learnBases(data.library as unknown as ToldBasis[]);
const shipped = { ...known };

/** What the page was told of bases beside those that it has by itself. */
export const toldBases = (): readonly ToldBasis[] => Object.values(known).filter((one) => one !== shipped[one.name]);

/** Tables of a model's own bases, by name. */
export type Tables = Readonly<Record<string, unknown>>;

const parsed = new WeakMap<Tables, Readonly<Record<string, Entry>>>();

/** A model's own bases; Error naming the basis, the formula and the character. */
export function ownBases(tables: unknown): Readonly<Record<string, Entry>> {
  if (tables === undefined) return {};
  if (typeof tables === "string") throw new Error(`bases: a page from disk reads no file ${quoted(tables)}; put its tables into the model as [bases.NAME], or use: quintrig view MODEL`);
  if (!isTable(tables)) throw new Error(`bases: expected [bases.NAME] tables, found ${spelt(tables)}`);
  const before = parsed.get(tables);
  if (before) return before;
  const count = Object.keys(tables).length;
  if (count > MOST_BASES) throw new Error(`bases: expected at most ${MOST_BASES} bases, found ${count}`);
  const made = Object.fromEntries(Object.entries(tables).map(([name, table]) => {
    try {
      return [name, entryOfOwn(ownBasis(name, table))];
    } catch (error) {
      throw new Error(`bases.${name.slice(0, 60)}: ${(error as Error).message}`);
    }
  }));
  parsed.set(tables, made);
  return made;
}

const entryOfOwn = (basis: Basis): Entry => {
  const { name, size } = basis;
  return { name, title: name, counts: `${size} control points`, sizes: [size], has: (points) => points === size, basis: () => basis };
};

const KEYS: readonly string[] = data.basisKeys;
const SHIPPED: readonly string[] = (data.library as unknown as ToldBasis[]).map(({ name }) => name);

/** A basis from a table with `functions`, and `parameters` and `source` if it likes. */
function ownBasis(name: string, table: unknown): Basis {
  if (SHIPPED.includes(name)) throw new Error(`${quoted(name)} is the name of a basis that quintrig brings; choose another name`);
  if (!/^[A-Za-z_]\w{0,59}$/.test(name)) throw new Error(`expected a name of letters, digits and _, found ${quoted(name.slice(0, 60))}`);
  if (!isTable(table)) throw new Error(`expected a table with functions = [...] and parameters = {...}, found ${spelt(table)}`);
  const unknown = Object.keys(table).find((key) => !KEYS.includes(key));
  if (unknown !== undefined) {
    const near = closest(unknown, KEYS);
    throw new Error(`unknown key ${quoted(unknown)}${near ? `; did you mean ${quoted(near)}?` : ""}; the keys are ${KEYS.join(", ")}`);
  }
  const { functions, parameters = {}, source = "" } = table;
  if (!Array.isArray(functions)) throw new Error(`functions: expected a list of formulas, such as ["1-t", "t"], found ${spelt(functions)}`);
  if (!isTable(parameters)) throw new Error(`parameters: expected a table such as { lam = [-1, 1] }, found ${spelt(parameters)}`);
  if (typeof source !== "string" || source.length > 400) throw new Error(`source: expected a text of at most 400 letters, found ${spelt(source)}`);
  const ranges = Object.entries(parameters).map(([one, ends]): Parameter => {
    const place = `parameters.${one.slice(0, 40)}`;
    if (!Array.isArray(ends) || ends.length < 2 || ends.length > 3) throw new Error(`${place}: expected its range [low, high], such as [-1, 1], found ${spelt(ends)}`);
    const wrong: unknown = ends.find((end) => typeof end !== "number" || !Number.isFinite(end));
    if (wrong !== undefined) throw new Error(`parameters.${one}: expected a finite number, found ${spelt(wrong)}`);
    return parameterOf(one, ...(ends as [number, number, number?]));
  });
  return new Basis(name, functions as string[], ranges);
}

/** A basis by name, of a model's `own` or of all; Error with the nearest known name. */
export function entry(name: string, own: Readonly<Record<string, Entry>> = {}): Entry {
  const all = { ...LIBRARY, ...own };
  if (Object.hasOwn(all, name)) return all[name]!;
  const near = closest(name, Object.keys(all));
  throw new Error(`basis: expected one of ${Object.keys(all).join(", ")}, found ${quoted(name)}${near ? `; did you mean ${quoted(near)}?` : ""}`);
}

/** The functions of a basis for so many points: the quintic and Bernstein's have faster ones than their formulas. */
export function family(one: Entry, points: number, values: readonly number[], still: Still = MOVING): Functions {
  if (points === 6 && (one === LIBRARY["trigonometric"] || one === LIBRARY["quintic"])) return new Trigonometric(values[0]!, values[1]!, still);
  return one === LIBRARY["bernstein"] ? new Bernstein(points - 1) : new Formulas(one.basis(points), values);
}

const isTable = (value: unknown): value is Record<string, unknown> => typeof value === "object" && value !== null && !Array.isArray(value);
const spelt = (value: unknown): string => (value === undefined ? "none" : typeof value === "string" ? quoted(value) : (JSON.stringify(value) ?? String(value))).slice(0, 60);
