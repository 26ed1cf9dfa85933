/** Patches added to a model, doubled, mirrored and taken away, with the joins that name them. */

import { KINDS, valueOf, type Model, type Patch } from "../numerics/model";
import type { Rule } from "./follow";

/** The model with a patch more, under a name that no other has. */
export function added(model: Model, patch: Patch): Model {
  const names = model.patches.map((one) => one.name);
  let name = patch.name;
  for (let k = 2; names.includes(name); k++) name = `${patch.name} ${k}`;
  return { ...model, patches: [...model.patches, { ...patch, name }] };
}

/** The model without a patch and its joins; a model keeps its last patch. */
export function removed(model: Model, at: number): Model {
  if (model.patches.length < 2) return model;
  const { name } = model.patches[at]!, names = (end: string) => end.slice(0, end.lastIndexOf(":")) === name;
  return withJoins({ ...model, patches: model.patches.filter((_, i) => i !== at) }, ((model.join ?? []) as Rule[]).filter((rule) => !names(rule.first) && !names(rule.second)));
}

/** The model with these joins; none leave no trace in the file. */
export function withJoins({ join: _, ...model }: Model, rules: readonly Rule[]): Model {
  return rules.length ? { ...model, join: rules } : model;
}

/** The patch mirrored across x = 0, y = 0 or z = 0, its normal as a mirror shows it; null for what is no set of points or planes. */
export function mirrored(patch: Patch, axis: 0 | 1 | 2): Patch | null {
  const fields = Object.entries(KINDS[patch.kind]!.fields), points = fields.filter(([, field]) => field.type === "points");
  if (!points.length || valueOf(patch, "flip") === undefined) return null;
  const turn = (value: unknown, at: number): unknown =>
    Array.isArray(value) && Array.isArray(value[0]) ? value.map((one) => turn(one, at)) : (value as number[]).map((x, i) => (i === at ? 0 - x : x));
  const result: Record<string, unknown> = { ...patch, name: `${patch.name} mirrored`, flip: valueOf(patch, "flip") !== true };
  for (const [key] of [...points, ...fields.filter(([, field]) => field.type === "plane")]) {
    const value = valueOf(patch, key);
    // A swung surface keeps its profile as (r, z) and its trajectory as (x, y).
    const at = patch.kind !== "swung" ? axis : key === "profile" ? (axis === 2 ? 1 : -1) : axis === 2 ? -1 : axis;
    if (value !== undefined) result[key] = turn(value, at);
  }
  return result as Patch;
}
