/** What differs between two models, in words. */

import { shapeOf, valueOf, type Model, type Patch } from "../numerics/model";
import { short } from "../ui/format";

const SHAPE = { 4: ["α1", "ζ1", "α2", "ζ2"], 2: ["α", "ζ"] } as const;
const SKIPPED = new Set(["name", "kind", "shape"]);

/** One phrase for each thing in which `now` differs from `before`; empty when nothing does. */
export function differences(before: Model, now: Model): string[] {
  const several = now.patches.length > 1, found: string[] = [];
  if (before.unit !== now.unit) found.push(`unit ${before.unit || "none"} → ${now.unit || "none"}`);
  if (before.patches.length !== now.patches.length) found.push(`${before.patches.length} → ${now.patches.length} patches`);
  now.patches.forEach((patch, i) => {
    const old = before.patches[i];
    if (!old || old === patch) return;
    found.push(...between(old, patch, now.unit).map((text) => (several ? `${patch.name}: ${text}` : text)));
  });
  return found;
}

function between(before: Patch, now: Patch, unit: string): string[] {
  if (before.kind !== now.kind) return [`${before.kind} → ${now.kind}`.replaceAll("_", " ")];
  const old = shapeOf(before), found = shapeOf(now).flatMap((x, i) => (x === old[i] ? [] : [`${SHAPE[old.length as 2 | 4]?.[i] ?? `shape ${i}`} ${short(old[i] ?? NaN)} → ${short(x)}`]));
  for (const key of new Set([...Object.keys(before), ...Object.keys(now)])) {
    const a = valueOf(before, key), b = valueOf(now, key);
    if (SKIPPED.has(key) || JSON.stringify(a) === JSON.stringify(b)) continue;
    if (typeof a === "number" && typeof b === "number") found.push(`${key} ${short(a)} → ${short(b)}`);
    else if (Array.isArray(a) && Array.isArray(b)) found.push(moves(key, rows(a), rows(b), unit));
    else found.push(`${key} ${String(a)} → ${String(b)}`);
  }
  return found;
}

/** How many rows of numbers differ, and by how much at most. */
function moves(key: string, before: readonly number[][], now: readonly number[][], unit: string): string {
  if (before.length !== now.length) return `${key}: ${before.length} → ${now.length} points`;
  const away = now.map((row, i) => Math.hypot(...row.map((x, k) => x - (before[i]![k] ?? 0)))), count = away.filter((x) => x > 0).length;
  const most = short(Math.max(...away)), length = key === "planes" || key === "bounds" ? "" : unit && ` ${unit}`;
  return `${key}: ${count} of ${now.length} moved, by ${count > 1 ? "up to " : ""}${most}${length}`;
}

/** The innermost rows of nested lists of numbers. */
const rows = (value: readonly unknown[]): number[][] =>
  value.every((x) => typeof x === "number") ? [value as number[]] : value.flatMap((x) => (Array.isArray(x) ? rows(x as unknown[]) : []));
