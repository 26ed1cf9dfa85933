/** What moves with a patch: points that it shares with others, and sides that a [[join]] holds to it. */

import { valueOf, type Model, type Patch } from "../numerics/model";
import { replaced } from "./handles";
import { matched, possible, type Condition } from "./match";
import type { Side } from "../numerics/across";

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
  const changed = (name: string) => { const k = now.findIndex((one) => one.name === name); return k >= 0 && now[k] !== before[k]; };
  for (const name of inOrder(rules)) {
    if (changed(name) || rules.some((rule) => nameOf(rule.second) === name && changed(nameOf(rule.first)))) follow(now, name, rules);
  }
  return { ...model, patches: now };
}

/** The model with a join more, its second side moved to the first; null where only Python can move it. */
export function joined(model: Model, rule: Rule): Model | null {
  const now = model.patches.slice(), join = [...((model.join ?? []) as readonly Rule[]), rule];
  return follow(now, nameOf(rule.second), join) === null ? null : { ...model, patches: now, join };
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

/** Move a patch to all that its sides follow, by the least change, as Python does on reading; null where only Python can. */
function follow(now: Patch[], name: string, rules: readonly Rule[]): Patch | null {
  const at = now.findIndex((one) => one.name === name), own = rules.filter((rule) => nameOf(rule.second) === name);
  const conditions: Condition[] = [];
  for (const { first, second, order, ratio } of own) {
    const [lead, leadSide] = sideOf(now, first), [, side] = sideOf(now, second);
    if (at < 0 || lead < 0) return null;
    conditions.push({ lead: now[lead]!, leadSide, side, order: Number(order?.[1] ?? 1), ratio: ratio ?? 1 });
  }
  let moved: Patch | null = null;
  try {
    moved = matched(now[at]!, conditions);
  } catch {
    // a patch that Python builds, or that cannot be built now
  }
  if (moved && moved !== now[at]) spread(now, at, moved);
  return moved;
}

/** The names of the patches that follow others, those that lead first. */
function inOrder(rules: readonly Rule[]): string[] {
  const waiting = [...new Set(rules.map((rule) => nameOf(rule.second)))], found: string[] = [];
  while (waiting.length) {
    const next = waiting.findIndex((name) => rules.every((rule) => nameOf(rule.second) !== name || !waiting.includes(nameOf(rule.first))));
    found.push(...waiting.splice(Math.max(next, 0), 1));
  }
  return found;
}

/** The joins that a page cannot keep under the pointer, because Python alone moves such patches: when the model is read. */
export function leftToPython(model: Model): Rule[] {
  return ((model.join ?? []) as readonly Rule[]).filter(({ first, second, order }) => {
    const [a] = sideOf(model.patches, first), [b, side] = sideOf(model.patches, second);
    return !model.patches[a] || !model.patches[b] || !possible(model.patches[b], side, Number(order?.[1] ?? 1), model.patches[a]);
  });
}

const nameOf = (end: string): string => end.slice(0, end.lastIndexOf(":"));
const apart = (a: Vec, b: Vec): number => Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!, a[2]! - b[2]!);
