/** Models: the same keys as a model file, checked, and the surfaces built from them. */

import data from "../data.json";
import type { BasisName } from "./basis";
import { ruled, swept, swung, symmetric, tensor, type Options, type Vector } from "./construct";
import { developable } from "./envelope";
import { nurbs } from "./nurbs";
import * as reference from "./reference";
import type { Surface } from "./surface";

export interface Field {
  readonly type: "points" | "shape" | "plane" | "number" | "positive" | "boolean" | "choice" | "raw";
  readonly description: string;
  readonly required: boolean;
  readonly default?: unknown;
  readonly counts?: readonly number[];
  readonly dimension?: number;
  readonly choices?: readonly string[];
}

export interface Kind {
  readonly title: string;
  readonly construction: boolean;
  readonly fields: Readonly<Record<string, Field>>;
}

export const KINDS = data.kinds as unknown as Readonly<Record<string, Kind>>;
export const UNITS: readonly string[] = data.units;
export const SHAPE_RANGE = data.shapeRange as [number, number];
const LARGEST = 1e50;

/** What a model file says of one surface; never changed, only replaced. */
export interface Patch {
  readonly kind: string;
  readonly name: string;
  readonly [key: string]: unknown;
}

/** A model: name, unit of length (empty: plain numbers) and patches. Values, never changed. */
export interface Model {
  readonly name: string;
  readonly unit: string;
  readonly patches: readonly Patch[];
  /** The [[join]] tables of the file, kept as they are: the server moves what follows. */
  readonly join?: readonly unknown[];
}

/** A model that cannot be used: where, what was expected, what was found. */
export class ModelError extends Error {}

/** Read the keys of a model file; ModelError in one line. */
export function fromDict(source: unknown): Model {
  if (!isTable(source)) throw new ModelError(`model: expected keys and values, got ${spell(source)}`);
  const { schema = data.schema, name = "", unit = "", patch, join, ...rest } = source;
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
  const extra = Object.keys(rest)[0];
  if (extra) throw new ModelError(`unknown key '${extra}' beside [[patch]] tables; move it into a patch`);
  const patches = patch.map((table: unknown, index) => {
    if (!isTable(table)) throw new ModelError(`patch ${index + 1}: expected a table of keys, got ${spell(table)}`);
    return checked({ ...table, name: table["name"] ?? `patch ${index + 1}` });
  });
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
  return { ...header, patch: model.patches, ...(model.join ? { join: model.join } : {}) };
}

/** Build the surface of a patch; ModelError where its values do not go together. */
export function build(patch: Patch): Surface {
  const get = <T>(key: string): T => (patch[key] ?? KINDS[patch.kind]!.fields[key]!.default) as T;
  const flip = get<boolean>("flip");
  const size = (key: string) => get<number>(key);
  const curve = (key: string) => get<Vector[]>(key);
  const bezier = (): Options => ({ basis: get<BasisName>("basis"), flip });
  const shape = () => get<number[]>("shape");
  try {
    switch (patch.kind) {
      case "tensor": return tensor(get<Vector[][]>("points"), shape(), bezier());
      case "symmetric": return symmetric(get<Vector[][]>("points"), get<Vector>("mirror"), shape(), bezier());
      case "swept": return swept(curve("section"), curve("trajectory"), shape(), bezier());
      case "swung": return swung(curve("profile"), curve("trajectory"), shape(), size("scale"), bezier());
      case "ruled": return ruled(curve("first"), curve("second"), shape(), bezier());
      case "developable": return developable(curve("planes"), curve("bounds"), shape(), flip);
      case "nurbs": return nurbs(get<Vector[][]>("points"), get<Vector[] | null>("weights"), get<Vector>("degrees"), get<Vector[]>("knots"), flip);
      case "sphere": return reference.sphere(size("radius"), flip);
      case "ellipsoid": return reference.ellipsoid(size("a"), size("b"), size("c"), flip);
      case "cylinder": return reference.cylinder(size("radius"), size("height"), flip);
      case "cone": return reference.cone(size("radius"), size("height"), flip);
      case "torus": return reference.torus(size("major"), size("minor"), flip);
      case "catenoid": return reference.catenoid(size("waist"), size("height"), flip);
      case "helicoid": return reference.helicoid(size("radius"), size("pitch"), flip);
      case "hyperbolic_paraboloid": return reference.hyperbolicParaboloid(size("size"), flip);
      case "monkey_saddle": return reference.monkeySaddle(size("size"), flip);
      case "enneper": return reference.enneper(size("size"), flip);
    }
  } catch (error) {
    throw new ModelError(`patch "${patch.name}": ${(error as Error).message}`);
  }
  throw new ModelError(`patch "${patch.name}": kind: a ${patch.kind} cannot be drawn in the browser`);
}

/** Shape parameters of a patch, empty for kinds that have none. */
export function shapeOf(patch: Patch): readonly number[] {
  return (patch["shape"] ?? KINDS[patch.kind]?.fields["shape"]?.default ?? []) as number[];
}

/** The value of a key, or its default. */
export function valueOf(patch: Patch, key: string): unknown {
  return patch[key] ?? KINDS[patch.kind]?.fields[key]?.default;
}

function checked(keys: Record<string, unknown>): Patch {
  const place = `patch "${String(keys["name"])}"`;
  const kind = KINDS[String(keys["kind"])];
  if (!kind) throw new ModelError(`${place}: kind: expected one of ${Object.keys(KINDS).join(", ")}, got ${spell(keys["kind"])}`);
  const fail = (message: string): never => {
    throw new ModelError(`${place}: ${message}`);
  };
  for (const key of Object.keys(keys)) if (key !== "kind" && key !== "name" && !kind.fields[key]) fail(`unknown key '${key}'`);
  const bernstein = keys["basis"] === "bernstein";
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
    else if (field.type === "shape") shape(value, key, (field.default as number[]).length, keys["unchecked_shape"] === true, fail);
    else if (field.type === "points") points(value, key, bernstein ? field.counts!.map(() => 0) : field.counts!, field.dimension!, fail);
  }
  const patch = keys as unknown as Patch;
  build(patch);
  return patch;
}

type Fail = (message: string) => never;

function shape(value: unknown, key: string, count: number, unchecked: boolean, fail: Fail): void {
  const names = count === 2 ? ["alpha", "zeta"] : ["alpha1", "zeta1", "alpha2", "zeta2"];
  numbers(value, key, count, fail).forEach((x, i) => {
    if (!unchecked && !(x >= SHAPE_RANGE[0] && x <= SHAPE_RANGE[1])) {
      fail(`shape[${i}] (${names[i]}) = ${x} is outside [-4, 1], where the basis is non-negative; choose a value in the range, or set unchecked_shape = true and lose the convex-hull property`);
    }
  });
}

function points(value: unknown, key: string, counts: readonly number[], dimension: number, fail: Fail): void {
  if (!counts.length) return void numbers(value, key, dimension, fail);
  if (!Array.isArray(value)) return fail(`${key}: expected a list, got ${spell(value)}`);
  const wanted = counts[0]!;
  const rows = counts.length === 2;
  if (wanted ? value.length !== wanted : value.length < 2 || value.length > 64) {
    fail(`${key}: expected ${wanted || "2 to 64"} ${rows ? "rows" : "points"}, got ${value.length}`);
  }
  value.forEach((row, i) => points(row, `${key}[${i}]`, counts.slice(1), dimension, fail));
  if (rows && value.some((row: unknown[]) => row.length !== (value[0] as unknown[]).length)) fail(`${key}: expected rows of equal length`);
}

function numbers(value: unknown, key: string, count: number, fail: Fail): number[] {
  if (!Array.isArray(value)) return fail(`${key}: expected a list, got ${spell(value)}`);
  if (value.length !== count) fail(`${key}: expected ${count} numbers, got ${value.length}`);
  value.forEach((x, i) => number(x, `${key}[${i}]`, fail, false));
  return value as number[];
}

function number(value: unknown, key: string, fail: Fail, positive: boolean): void {
  if (typeof value !== "number") fail(`${key}: expected a number, got ${spell(value)}`);
  if (!Number.isFinite(value)) fail(`${key}: expected a finite number, got ${String(value)}`);
  if (Math.abs(value as number) > LARGEST) fail(`${key}: expected a number of size at most 1e50, got ${String(value)}`);
  if (positive && !((value as number) > 0)) fail(`${key}: expected a number greater than 0, got ${String(value)}`);
}

const isTable = (value: unknown): value is Record<string, unknown> => typeof value === "object" && value !== null && !Array.isArray(value);

function spell(value: unknown): string {
  const text = value === undefined ? "nothing" : (JSON.stringify(value) ?? String(value));
  return text.length <= 60 ? text : `${text.slice(0, 57)}...`;
}
