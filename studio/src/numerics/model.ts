/** Models: the same keys as a model file, checked, and the surfaces built from them. */

import data from "../data.json";
import { buildHere, drawnHere } from "./builders";
import { learn, Pending, surfaceOf, type Built } from "./built";
import { curveOf, isCurve } from "./curve";
import { KINDS, ModelError, SHAPE_RANGE, type Patch } from "./kinds";
import { learnBases, ownBases, type Tables, type ToldBasis } from "./library";
import type { Surface } from "./surface";

export { shapeOf, shapeParameters } from "./chosen";
export { install, KINDS, ModelError, STARTERS, valueOf, type Field, type Kind, type Patch } from "./kinds";

export const UNITS: readonly string[] = data.units;
const { largest: LARGEST, largestPolygon: LARGEST_POLYGON } = data.limits;

/** A model: name, unit of length (empty: plain numbers) and patches, or curves. Values, never changed. */
export interface Model {
  readonly name: string;
  readonly unit: string;
  readonly patches: readonly Patch[];
  /** The [[join]] tables of the file, kept as they are: the server moves what follows. */
  readonly join?: readonly unknown[];
}

/** Read the keys of a model file; ModelError in one line. */
export function fromDict(source: unknown): Model {
  if (!isTable(source)) throw new ModelError(`model: expected keys and values, got ${spell(source)}`);
  const { schema = data.schema, name = "", unit = "", patch, join, built, library, ...rest } = source;
  if (built) learn(built as Built[]); // what Python built of it comes with a model,
  if (library) learnBases(library as ToldBasis[]); // and the bases that the page does not hold
  if (schema !== data.schema) throw new ModelError(`schema: expected ${data.schema}, got ${spell(schema)}; this quintrig reads version 1`);
  if (unit !== "" && !UNITS.includes(unit as string)) {
    throw new ModelError(`unit: expected one of ${UNITS.join(", ")}, got ${spell(unit)}; leave it out for plain numbers`);
  }
  if (typeof name !== "string" || name.length > 200) throw new ModelError(`name: expected a short text, got ${spell(name)}`);
  if (patch === undefined) {
    const only = checked({ ...rest, name: name || String(rest["kind"] ?? "surface") });
    return { name: name || only.name, unit: unit as string, patches: [only] };
  }
  if (!Array.isArray(patch) || !patch.length) throw new ModelError(`patch: expected one or more [[patch]] tables, got ${spell(patch)}`);
  const { bases, ...others } = rest, extra = Object.keys(others)[0];
  if (extra) throw new ModelError(`unknown key '${extra}' beside [[patch]] tables; move it into a patch`);
  if (bases !== undefined) told(() => ownBases(bases));
  const patches = patch.map((table: unknown, index) => {
    if (!isTable(table)) throw new ModelError(`patch ${index + 1}: expected a table of keys, got ${spell(table)}`);
    const shared = bases !== undefined && KINDS[String(table["kind"])]?.fields["bases"] ? { bases } : {};
    return checked({ ...shared, ...table, name: table["name"] ?? `patch ${index + 1}` });
  });
  const curves = patches.filter(isCurve);
  if (new Set(curves.map((one) => curveOf(one).flat)).size > 1) throw new ModelError("points: expected curves all in the plane or all in space, found both in one model");
  if (join !== undefined && !Array.isArray(join)) throw new ModelError(`join: expected one or more [[join]] tables, got ${spell(join)}`);
  return { name: name || patches[0]!.name, unit: unit as string, patches, ...(join ? { join } : {}) };
}

/** The keys of a model file that gives this model back. */
export function toDict(model: Model): Record<string, unknown> {
  const header: Record<string, unknown> = { schema: data.schema, name: model.name };
  if (model.unit) header["unit"] = model.unit;
  if (model.patches.length === 1) {
    const { name: _, ...keys } = model.patches[0]!;
    return { ...header, ...keys };
  }
  // Bases that all patches share stand once, beside them.
  const shared = [...new Set(model.patches.filter((one) => one["bases"]).map((one) => JSON.stringify(one["bases"])))];
  const bases = shared.length === 1 ? { bases: JSON.parse(shared[0]!) as Tables } : {};
  const patches = shared.length === 1 ? model.patches.map(({ bases: _, ...keys }) => keys) : model.patches;
  return { ...header, ...bases, patch: patches, ...(model.join ? { join: model.join } : {}) };
}

/** The surface of a patch, built here or by Python; ModelError where its values do not go together. */
export function build(patch: Patch): Surface {
  if (!drawnHere(patch)) return surfaceOf(patch);
  try {
    return buildHere(patch);
  } catch (error) {
    throw new ModelError(`patch "${patch.name}": ${(error as Error).message}`);
  }
}

function checked(keys: Record<string, unknown>): Patch {
  const place = `patch "${String(keys["name"])}"`;
  const known = Object.hasOwn(KINDS, String(keys["kind"])), kind = KINDS[String(keys["kind"])];
  if (!known || !kind) throw new ModelError(`${place}: kind: expected one of ${Object.keys(KINDS).join(", ")}, got ${spell(keys["kind"])}`);
  const fail = (message: string): never => {
    throw new ModelError(`${place}: ${message}`);
  };
  for (const key of Object.keys(keys)) if (key !== "kind" && key !== "name" && !Object.hasOwn(kind.fields, key)) fail(`unknown key '${key}'`);
  if (kind.fields["bases"]) told(() => ownBases(keys["bases"]), `${place}: `);
  // Counts and shape parameters hang on the basis, where there is one: they are checked with what is built on it.
  const based = kind.fields["basis"] !== undefined;
  const standard = kind.surface && (!based || ["trigonometric", "quintic", undefined].includes(keys["basis"] as string | undefined));
  for (const [key, field] of Object.entries(kind.fields)) {
    const value = keys[key];
    if (value === undefined) {
      if (field.required) fail(`missing key '${key}': expected ${field.description}`);
      continue;
    }
    if (field.type === "number" || field.type === "positive") number(value, key, fail, field.type === "positive");
    else if (field.type === "boolean" && typeof value !== "boolean") fail(`${key}: expected true or false, got ${spell(value)}`);
    else if (field.type === "choice" && !field.choices!.includes(value as string)) fail(`${key}: expected one of ${field.choices!.join(", ")}, got ${spell(value)}`);
    else if (field.type === "plane") numbers(value, key, 4, fail);
    else if (field.type === "basis" && !isBasis(value)) fail(`${key}: expected the name of a basis, or two, got ${spell(value)}`);
    else if (field.type === "shape" && based) numbers(value, key, null, fail);
    else if (field.type === "shape") shape(value, key, kind.shapeNames, keys["unchecked_shape"] === true, fail);
    else if (field.type === "points") points(value, key, standard ? field.counts! : field.counts!.map(() => 0), field.dimension!, fail);
  }
  const patch = keys as unknown as Patch;
  try {
    if (isCurve(patch)) curveOf(patch);
    else build(patch);
  } catch (error) {
    if (!(error instanceof Pending)) throw error;
  }
  return patch;
}

/** Turn what is said to be wrong into what is said of a model. */
function told(act: () => unknown, place = ""): void {
  try {
    act();
  } catch (error) {
    throw new ModelError(`${place}${(error as Error).message}`);
  }
}

type Fail = (message: string) => never;

const isBasis = (value: unknown): boolean => [value].flat().every((name) => typeof name === "string" && name !== "");

function shape(value: unknown, key: string, names: readonly string[], unchecked: boolean, fail: Fail): void {
  numbers(value, key, names.length, fail).forEach((x, i) => {
    if (!unchecked && !(x >= SHAPE_RANGE[0] && x <= SHAPE_RANGE[1])) {
      fail(`shape[${i}] (${names[i]}) = ${x} is outside [${SHAPE_RANGE.join(", ")}], where the basis is non-negative; choose a value in the range, or set unchecked_shape = true and lose the convex-hull property`);
    }
  });
}

function points(value: unknown, key: string, counts: readonly number[], dimension: number, fail: Fail): void {
  if (!counts.length) return void numbers(value, key, dimension, fail);
  if (!Array.isArray(value)) return fail(`${key}: expected a list, got ${spell(value)}`);
  const wanted = counts[0]!;
  const rows = counts.length === 2;
  if (wanted ? value.length !== wanted : value.length < 2 || value.length > LARGEST_POLYGON) {
    fail(`${key}: expected ${wanted || `2 to ${LARGEST_POLYGON}`} ${rows ? "rows" : "points"}, got ${value.length}`);
  }
  value.forEach((row, i) => points(row, `${key}[${i}]`, counts.slice(1), dimension, fail));
  if (rows && value.some((row: unknown[]) => row.length !== (value[0] as unknown[]).length)) fail(`${key}: expected rows of equal length`);
}

/** Check a list of so many numbers; 0 stands for the 2 or 3 of a point in the plane or in space, null for any number. */
function numbers(value: unknown, key: string, count: number | null, fail: Fail): number[] {
  if (!Array.isArray(value)) return fail(`${key}: expected a list, got ${spell(value)}`);
  const good = count === null || (count === 0 ? value.length === 2 || value.length === 3 : value.length === count);
  if (!good) fail(`${key}: expected ${count === 0 ? "2 or 3" : count} numbers, got ${value.length}`);
  value.forEach((x, i) => number(x, `${key}[${i}]`, fail, false));
  return value as number[];
}

/** The largest size of a number, as Python spells it. */
const MOST = LARGEST.toExponential().replace("e+", "e");

function number(value: unknown, key: string, fail: Fail, positive: boolean): void {
  if (typeof value !== "number") fail(`${key}: expected a number, got ${spell(value)}`);
  if (!Number.isFinite(value)) fail(`${key}: expected a finite number, got ${String(value)}`);
  if (Math.abs(value as number) > LARGEST) fail(`${key}: expected a number of size at most ${MOST}, got ${String(value)}`);
  if (positive && !((value as number) > 0)) fail(`${key}: expected a number greater than 0, got ${String(value)}`);
}

const isTable = (value: unknown): value is Record<string, unknown> => typeof value === "object" && value !== null && !Array.isArray(value);

function spell(value: unknown): string {
  const text = value === undefined ? "nothing" : (JSON.stringify(value) ?? String(value));
  return text.length <= 60 ? text : `${text.slice(0, 57)}...`;
}
