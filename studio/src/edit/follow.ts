/** What moves with a patch: points that it shares with others, and sides that a [[join]] holds to it. */

import { build, valueOf, type Model, type Patch } from "../numerics/model";
import type { Functions } from "../numerics/functions";
import { Net } from "../numerics/surface";
import { replaced } from "./handles";
import { SIDES, type Side } from "../numerics/across";

type Vec = readonly number[];

export interface Rule {
  readonly first: string;
  readonly second: string;
  readonly order?: string;
  readonly ratio?: number;
}

const SAME = 1e-9; // of a patch's size: points this near are one

/** The model with a patch in another's place, and all that moves with it. */
export function followed(model: Model, at: number, patch: Patch): Model {
  const before = model.patches, now = before.slice();
  spread(now, at, patch);
  const rules = (model.join ?? []) as readonly Rule[];
  // Joins run in no circle: as many rounds as there are joins settle them all.
  for (let round = 0; round < rules.length && rules.filter((rule) => follow(before, now, rule)).length; round++);
  return { ...model, patches: now };
}

/** The model with a join more, its second side moved to the first; null where only Python can move it. */
export function joined(model: Model, rule: Rule): Model | null {
  const now = model.patches.slice(), moved = follow(null, now, rule);
  return moved === null ? null : { ...model, patches: now, join: [...(model.join ?? []), rule] };
}

/** The patch's number and the side that `patch:side` names. */
export function sideOf(patches: readonly Patch[], text: string): [number, Side] {
  const colon = text.lastIndexOf(":");
  return [patches.findIndex((one) => one.name === text.slice(0, colon)), text.slice(colon + 1) as Side];
}

/** Put a patch in its place; points on its sides that others share go along with it. */
function spread(patches: Patch[], at: number, next: Patch): void {
  const old = patches[at]!, was = border(old), is = border(next);
  patches[at] = next;
  if (was.length !== is.length || old.kind !== next.kind) return;
  const size = Math.max(...[0, 1, 2].map((x) => Math.max(...was.map((p) => p.point[x]!)) - Math.min(...was.map((p) => p.point[x]!))));
  const moved = was.flatMap((from, i) => (apart(from.point, is[i]!.point) > 0 ? [{ from: from.point, to: is[i]!.point }] : []));
  if (!moved.length) return;
  patches.forEach((other, k) => {
    if (k === at) return;
    let changed = other;
    for (const { key, index, point } of border(other)) {
      const match = moved.find(({ from }) => apart(from, point) <= SAME * size);
      if (match) changed = replaced(changed, key, index, match.to);
    }
    patches[k] = changed;
  });
}

interface Place { readonly key: string; readonly index: readonly number[]; readonly point: Vec }

const borders = new WeakMap<Patch, readonly Place[]>();

/** The control points on the sides of a patch whose sides are curves of them. */
function border(patch: Patch): readonly Place[] {
  let found = borders.get(patch);
  if (!found) borders.set(patch, (found = ["tensor", "nurbs", "symmetric", "ruled"].includes(patch.kind) ? places(patch) : []));
  return found;
}

function places(patch: Patch): Place[] {
  if (patch.kind === "ruled") return ["first", "second"].flatMap((key) => (valueOf(patch, key) as Vec[]).map((point, i) => ({ key, index: [i], point })));
  const rows = valueOf(patch, "points") as Vec[][], last = patch.kind === "symmetric" ? -1 : rows.length - 1;
  return rows.flatMap((row, i) => row.flatMap((point, j) => (i === 0 || i === last || j === 0 || j === row.length - 1 ? [{ key: "points", index: [i, j], point }] : [])));
}

/** Move the second side of a rule as its first moved since `before`, or, without that, to it; null where that is Python's. */
function follow(before: readonly Patch[] | null, now: Patch[], rule: Rule): true | false | null {
  const [a, sideA] = sideOf(now, rule.first), [b, sideB] = sideOf(now, rule.second);
  if (a < 0 || b < 0 || (before && before[a] === now[a] && before[b] === now[b])) return false;
  const lead = rowsOf(now[a]!, sideA), own = rowsOf(now[b]!, sideB);
  if (!lead || !own || lead.rows[0]!.length !== own.rows[0]!.length) return null;
  const level = Math.min(2, Number(rule.order?.[1] ?? 1), lead.rows.length - 1, own.rows.length - 1), ratio = rule.ratio ?? 1;
  const first = lead.rows[0]!, second = own.rows[0]!, count = first.length;
  const total = (back: boolean) => first.reduce((sum, p, j) => sum + apart(p, second[back ? count - 1 - j : j]!), 0);
  const back = total(true) < total(false);
  const old = before && { lead: rowsOf(before[a]!, sideA), own: rowsOf(before[b]!, sideB) };
  if (old && (!old.lead || !old.own || old.lead.rows[0]!.length !== count || old.own.rows[0]!.length !== count)) return null;
  let patch = now[b]!, changed = false;
  for (let j = 0; j < count; j++) {
    const at = back ? count - 1 - j : j, missing: number[][] = [];
    for (let k = 0; k <= level; k++) {
      const by = (-ratio) ** k; // out of the first, into the second
      missing.push([0, 1, 2].map((x) => {
        const wanted = by * (lead.derivative(k, j, x) - (old?.lead?.derivative(k, j, x) ?? 0)) + (old?.own?.derivative(k, at, x) ?? 0);
        return wanted - own.derivative(k, at, x);
      }));
    }
    // The k-th derivative at an end hangs on the first k + 1 rows: one row after the other.
    const shift: number[][] = [];
    for (let k = 0; k <= level; k++) shift.push(missing[k]!.map((m, x) => (m - shift.reduce((sum, s, i) => sum + own.weight(k, i) * s[x]!, 0)) / own.weight(k, k)));
    shift.forEach((by, k) => {
      if (!(Math.hypot(...by) > 1e-11 * own.size)) return;
      changed = true;
      patch = replaced(patch, "points", own.index(k, at), own.rows[k]![at]!.map((x, i) => x + by[i]!));
    });
  }
  if (changed) spread(now, b, patch);
  return changed;
}

interface SideRows {
  /** Rows of control points from the side inwards. */
  readonly rows: readonly (readonly Vec[])[];
  readonly size: number;
  index(k: number, j: number): number[];
  /** The weight of row i in the k-th derivative into the patch. */
  weight(k: number, i: number): number;
  derivative(k: number, j: number, x: number): number;
}

/** The rows of a tensor-product patch as seen from a side; null for others. */
function rowsOf(patch: Patch, side: Side): SideRows | null {
  if (patch.kind !== "tensor" || !SIDES.includes(side)) return null;
  const surface = build(patch), net = valueOf(patch, "points") as Vec[][], u = side[0] === "u", end = side[1] === "1";
  if (!(surface.rows instanceof Net)) return null;
  const functions: Functions = u ? surface.rows.functions : surface.blend, n = functions.size, f = new Float64Array(3 * n);
  functions.derivatives(Float64Array.of(end ? 1 : 0), 1, f);
  const from = (k: number) => (end ? n - 1 - k : k), index = (k: number, j: number) => (u ? [from(k), j] : [j, from(k)]);
  const across = u ? net[0]!.length : net.length;
  const rows = Array.from({ length: n }, (_, k) => Array.from({ length: across }, (_, j) => { const [p, q] = index(k, j); return net[p!]![q!]!; }));
  const weight = (k: number, i: number) => (end ? -1 : 1) ** k * f[k * n + from(i)]!;
  const size = Math.max(...rows.flat(2).map(Math.abs));
  return { rows, size, index, weight, derivative: (k, j, x) => rows.reduce((sum, row, i) => sum + (i <= k ? weight(k, i) * row[j]![x]! : 0), 0) };
}

const apart = (a: Vec, b: Vec): number => Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!, a[2]! - b[2]!);
