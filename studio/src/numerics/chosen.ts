/** The bases that a patch is built on, one for each direction or curve, and the shape parameters of all of them. */

import { MOVING, standing, Trigonometric, type Still } from "./basis";
import { Formulas, holds, rangeOf, type Basis, type Parameter } from "./formulas";
import type { Dual } from "./envelope";
import type { Functions } from "./functions";
import { KINDS, SHAPE_RANGE, valueOf, type Patch } from "./kinds";
import { entry, family, LIBRARY, ownBases, type Entry } from "./library";

/** One basis of a patch: which, for how many control points, and where these stand in the keys. */
export interface Choice {
  readonly entry: Entry;
  readonly points: number;
  readonly place: string;
}

/** A shape parameter of a patch, numbered by its basis where there are two. */
export interface Shaped extends Parameter {
  readonly label: string;
  /** Which of the bases it is of. */
  readonly of: number;
}

/** The bases of a patch; none for kinds that have none. Error where a name or a number of points does not fit. */
export function choicesOf(patch: Patch): readonly Choice[] {
  const names = valueOf(patch, "basis");
  if (names === undefined) return [];
  const own = ownBases(valueOf(patch, "bases"));
  const list = (key: string) => (valueOf(patch, key) ?? []) as readonly unknown[];
  const nets = netsOf(patch), first = list(nets[0]!), columns = ((first[0] ?? []) as readonly unknown[]).length;
  const places: readonly (readonly [string, number])[] =
    patch.kind === "symmetric" ? [["points", mirrored(entry([names].flat()[0] as string, own), first.length)], ["points[0]", columns]]
    : patch.kind === "curve" ? [["points", first.length + Number(valueOf(patch, "close") === true)]]
    : patch.kind === "developable" ? [["planes", first.length]]
    : KINDS[patch.kind]!.fields[nets[0]!]!.counts!.length === 2 ? [[nets[0]!, first.length], [`${nets[0]!}[0]`, columns]]
    : [[nets[0]!, first.length], [nets.at(-1)!, list(nets.at(-1)!).length]];
  if (Array.isArray(names) && names.length !== places.length) throw new Error(`basis: expected one basis, or ${places.length}, found ${names.length}`);
  return places.map(([place, points], i) => {
    const found = entry(Array.isArray(names) ? (names[i] as string) : (names as string), own);
    if (!found.sizes.includes(points)) {
      const closed = patch.kind === "curve" && valueOf(patch, "close") === true ? "; close = true adds the first once more, as the last" : "";
      throw new Error(`${place}: expected ${place === "planes" ? found.counts.replace("points", "planes") : found.counts} for the ${found.name} basis, found ${points}${closed}`);
    }
    return { entry: found, points, place };
  });
}

const netsOf = (patch: Patch): string[] => Object.entries(KINDS[patch.kind]!.fields).flatMap(([key, field]) => (field.type === "points" ? [key] : []));

/** How many rows a net has of which so many, half of them, are given: the last is the middle one if that is odd. */
export function mirrored(one: Entry, rows: number): number {
  const whole = [2 * rows, 2 * rows - 1].find((n) => one.sizes.includes(n));
  if (whole !== undefined) return whole;
  const halves = [...new Set(one.sizes.map((n) => (n + 1) >> 1))].sort((p, q) => p - q);
  throw new Error(`points: expected ${halves.length < 4 ? halves.join(" or ") : `${halves[0]} to ${halves.at(-1)}`} rows, half of the net, found ${rows}`);
}

/** Whether every basis of a patch is the quintic one, with which the thesis's sets of shape parameters go. */
export const isStandard = (patch: Patch): boolean => allOf(patch, "trigonometric", "quintic");
/** Whether every basis is Bernstein's, on which shape parameters do not act. */
export const isClassical = (patch: Patch): boolean => allOf(patch, "bernstein");

function allOf(patch: Patch, ...names: string[]): boolean {
  const basis = valueOf(patch, "basis");
  return basis !== undefined && [basis].flat().every((name) => names.includes(name as string));
}

const shaped = new WeakMap<Patch, readonly Shaped[]>();

/** The shape parameters of a patch in their order; none where its bases or points are not right. */
export function shapeParameters(patch: Patch): readonly Shaped[] {
  let found = shaped.get(patch);
  if (!found) {
    try {
      found = valueOf(patch, "basis") === undefined ? plain(patch) : parametersOf(choicesOf(patch));
    } catch {
      found = [];
    }
    shaped.set(patch, found);
  }
  return found;
}

/** The shape parameters of a kind that has some, and no basis. */
const plain = (patch: Patch): Shaped[] => (KINDS[patch.kind]?.fields["shape"] ? KINDS[patch.kind]!.shapeNames : [])
  .map((name) => ({ name, label: name, low: SHAPE_RANGE[0], high: SHAPE_RANGE[1], start: 0, open: [false, false], of: 0 }));

function parametersOf(choices: readonly Choice[]): Shaped[] {
  const number = (name: string, i: number) => (choices.length < 2 ? name : /\d$/.test(name) ? `${name}_${i + 1}` : `${name}${i + 1}`);
  return choices.flatMap(({ entry: one, points }, i) => one.basis(points).parameters.map((p) => ({ ...p, label: number(p.name, i), of: i })));
}

/** The values of the shape parameters of a patch: those of the model, or where its bases start. */
export function shapeOf(patch: Patch): readonly number[] {
  if (!KINDS[patch.kind]?.fields["shape"]) return [];
  const given = (patch["shape"] ?? []) as readonly number[];
  if (given.length) return given;
  return isClassical(patch) || !KINDS[patch.kind]!.fields["basis"] ? ((valueOf(patch, "shape") ?? []) as number[]) : shapeParameters(patch).map((one) => one.start);
}

/** The values for each basis of a patch; Error, naming the place, where their number or one of them does not fit. */
export function valuesFor(patch: Patch, choices: readonly Choice[]): readonly (readonly number[])[] {
  const parameters = parametersOf(choices), given = (patch["shape"] ?? []) as readonly number[];
  if (given.length === 0) return choices.map(({ entry: one, points }) => one.basis(points).parameters.map((p) => p.start));
  if (choices.every((one) => one.entry === LIBRARY["bernstein"])) {
    if (given.length !== 2 * choices.length) throw new Error(`shape: expected none or ${2 * choices.length} numbers, which do not act in the bernstein basis, found ${given.length}`);
    return choices.map(() => []);
  }
  if (given.length !== parameters.length) {
    const names = parameters.length ? ` (${parameters.map((one) => one.label).join(", ")})` : ", as the basis has no shape parameters";
    throw new Error(`shape: expected ${parameters.length} numbers${names}, found ${given.length}`);
  }
  if (patch["unchecked_shape"] !== true) {
    const wrong = given.findIndex((value, i) => !holds(parameters[i]!, value));
    if (wrong >= 0) {
      throw new Error(
        `shape[${wrong}] (${parameters[wrong]!.label}) = ${given[wrong]!} is outside ${rangeOf(parameters[wrong]!)}, the range of this basis; choose a ` +
          "value in the range, or set unchecked_shape = true and lose what the range warrants, such as the convex-hull property",
      );
    }
  }
  return choices.map((_, i) => given.filter((_, k) => parameters[k]!.of === i));
}

/** Error where the functions of a basis do not sum to 1 and nobody said that this may be. */
export function checkSums(patch: Patch, choices: readonly Choice[]): void {
  if (patch["unchecked_basis"] === true) return;
  for (const basis of choices.map(({ entry: one, points }) => one.basis(points))) {
    if (basis.partition) continue;
    throw new Error(
      `basis: the functions of '${basis.name}' do not sum to 1 (${basis.offSum.told}); correct the formulas, or set ` +
        "unchecked_basis = true and have a surface that moves with the origin",
    );
  }
}

/** The bases whose functions do not sum to 1: what is built on them moves with the origin. */
export const moving = (choices: readonly Choice[]): readonly Basis[] =>
  choices.map(({ entry: one, points }) => one.basis(points)).filter((basis) => !basis.partition);

/** One basis of a patch with the values of its parameters, ready to be built on. */
export interface Chosen {
  readonly partition: boolean;
  functions(still?: Still): Functions;
  /** The functions as formulas, with derivatives of any order. */
  formulas(): Formulas;
  /** The functions for the dual construction. */
  dual(): Dual;
  /** Whether what is built on these rows of points stands still at either end, in a way that the functions know of. */
  still(rows: readonly (readonly (readonly number[])[])[]): Still;
}

/** The bases of a patch with their values; Error where they, the points and the values do not go together. */
export function chosenOf(patch: Patch): readonly Chosen[] {
  const choices = choicesOf(patch), values = valuesFor(patch, choices);
  checkSums(patch, choices);
  return choices.map(({ entry: one, points }, i) => {
    const own = values[i]!, knows = one === LIBRARY["trigonometric"] || one === LIBRARY["quintic"];
    const formulas = () => new Formulas(one.basis(points), own);
    return {
      partition: one.basis(points).partition,
      formulas,
      dual: () => (knows ? new Trigonometric(own[0]!, own[1]!) : formulas()),
      functions: (still = MOVING) => family(one, points, own, still),
      still: (rows) => (knows ? standing(own[0]!, own[1]!, rows) : MOVING),
    };
  });
}
