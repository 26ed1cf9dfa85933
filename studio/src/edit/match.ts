/**
 * The least change of a patch that joins its sides to others: Python's `multipatch.match` and the same numbers.
 *
 * With y out of the lead and x into the patch, S2' = κ S1', S2'' = κ² S1'' + μ S1' and S2''' = κ³ S1''' + 3κμ S1'' + ν S1'
 * along the whole side (Farin 2002, §21): linear in the control points, μ and ν.
 */

import { place, SIDES, type Side } from "../numerics/across";
import { chosenOf, type Chosen } from "../numerics/chosen";
import { pseudoInverse, size, times, transposed, type Matrix } from "../numerics/least";
import { build, valueOf, type Patch } from "../numerics/model";
import { Net } from "../numerics/surface";

export interface Condition {
  readonly lead: Patch;
  readonly leadSide: Side;
  readonly side: Side;
  readonly order: number;
  readonly ratio: number;
}

type Points = readonly (readonly (readonly number[])[])[];

const KINDS = ["tensor", "swept"];
const POINTS = 16, ENDS = 30, RANK = 1e-11, STANDS = 1e-12;

/** The patch moved to meet all conditions at once, as well as may be; itself where it does, null where only Python can move it. */
export function matched(patch: Patch, conditions: readonly Condition[]): Patch | null {
  const own = handleOf(patch);
  if (!own) return null;
  const [n, m] = [own.net.length, own.net[0]!.length], extent = Math.max(...[0, 1, 2].map((x) => span(own.net.flat().map((p) => p[x]!))));
  const rows: number[][] = [], right: number[][] = [], free: { row: number; column: number; values: readonly (readonly number[])[] }[] = [];
  let more = 0;
  for (const { lead, leadSide, side, order, ratio } of conditions) {
    const u = side[0] === "u", across = u ? own.bases[0]! : own.bases[1]!, along = u ? own.bases[1]! : own.bases[0]!;
    const count = Math.max(POINTS, 2 * n, 2 * m), t = nodes(count), back = runsBack(lead, leadSide, patch, side);
    if (order >= (u ? n : m)) return null;
    const target = outOf(lead, leadSide, t, order);
    if (!target || back === null) return null;
    const weights = derivativesAt(across, side[1] === "1", order), functions = valuesAt(along, back ? t.toReversed() : t);
    const fit = fitting(functions), wanted = target.map((values) => times(fit, values));
    const j = u ? m : n, cell = (i: number, k: number) => (u ? i * m + k : k * m + i);
    for (let k = 0; k <= order; k++) {
      const by = Math.PI ** -k, sign = side[1] === "0" ? 1 : (-1) ** k;
      for (let at = 0; at < j; at++) {
        const row = new Array<number>(n * m).fill(0);
        weights[k]!.forEach((weight, i) => (row[cell(i, at)] = by * sign * weight));
        const now = [0, 1, 2].map((x) => row.reduce((sum, weight, c) => sum + weight * own.net[Math.floor(c / m)]![c % m]![x]!, 0));
        rows.push(own.folded(row));
        right.push(now.map((value, x) => by * ratio ** k * wanted[k]![at]![x]! - value));
      }
    }
    const start = rows.length - (order + 1) * j, scaled = (k: number, d: number, factor: number) => wanted[d]!.map((p) => p.map((x) => x * factor * Math.PI ** -k));
    if (order > 1) free.push({ row: start + 2 * j, column: more, values: scaled(2, 1, 1) });
    if (order > 2) free.push({ row: start + 3 * j, column: more, values: scaled(3, 2, 3 * ratio) }, { row: start + 3 * j, column: more + 1, values: scaled(3, 1, 1) });
    more += Math.max(0, order - 1);
  }
  const key = JSON.stringify([own.key, conditions.map(({ side, order }) => [side, order])]), inverse = inverseOf(key, rows);
  const bent = [0, 1, 2].map((x) => rows.map((_, r) => Array.from({ length: more }, (_, c) => free.reduce((sum, one) => (one.column === c && r >= one.row && r < one.row + one.values.length ? sum + one.values[r - one.row]![x]! : sum), 0))));
  const change = transposed(solved(rows, inverse, right, bent, more));
  if (!(Math.max(...change.flat().map(Math.abs)) > STANDS * extent)) return patch;
  return own.moved(change);
}

/** The change x of least norm, by coordinates, with A x = right + B free as nearly as may be. */
function solved(rows: Matrix, inverse: Matrix, right: Matrix, bent: readonly Matrix[], more: number): number[][] {
  const columns = transposed(right);
  const missed = (b: Matrix): number[][] => { const back = times(rows, times(inverse, b)); return b.map((row, r) => row.map((x, c) => x - back[r]![c]!)); };
  const column = (values: readonly number[]): number[][] => values.map((x) => [x]);
  let free: number[][] = Array.from({ length: more }, () => [0]);
  if (more) {
    // The free numbers first serve what no change of the net can, then the least change.
    const scale = size(bent.flat()), rest = bent.flatMap(missed), lost = columns.flatMap((b) => missed(column(b)));
    const away = pseudoInverse(rest, () => 1e-9 * scale), onto = times(away, rest);
    free = times(away, lost).map(([x]) => [-x!]);
    const null_ = onto.map((row, i) => row.map((x, j) => Number(i === j) - x));
    const all = bent.flatMap((b) => times(inverse, b)), moves = times(all, null_), least = 1e-9 * size(all);
    const first = columns.flatMap((b, x) => times(inverse, column(b.map((value, r) => value + times([bent[x]![r]!], free)[0]![0]!))));
    const step = times(null_, times(pseudoInverse(moves, () => least), first));
    free = free.map(([x], i) => [x! - step[i]![0]!]);
  }
  return columns.map((b, x) => times(inverse, column(b.map((value, r) => value + (more ? times([bent[x]![r]!], free)[0]![0]! : 0)))).map(([value]) => value!));
}

interface Handle {
  readonly key: unknown;
  readonly net: Points;
  readonly bases: readonly Chosen[];
  /** A row of weights of the net's points, as weights of what may move. */
  folded(row: readonly number[]): number[];
  moved(change: Matrix): Patch;
}

/** Whether a page can move this side of a patch to that order, or must leave it to Python. */
export function possible(patch: Patch, side: Side, order: number, lead: Patch): boolean {
  if (!KINDS.includes(patch.kind)) return false;
  const rows = valueOf(patch, patch.kind === "tensor" ? "points" : side[0] === "u" ? "section" : "trajectory") as Points;
  return (patch.kind === "tensor" && side[0] === "v" ? rows[0]!.length : rows.length) > order && (order < 3 || valueOf(lead, "basis") !== undefined);
}

/** What may be moved of a patch: the points of a tensor-product patch, both curves of a swept one. */
function handleOf(patch: Patch): Handle | null {
  if (!KINDS.includes(patch.kind)) return null;
  const bases = chosenOf(patch), key = [patch.kind, valueOf(patch, "basis"), valueOf(patch, "shape"), patch["bases"]];
  const shifted = (points: readonly (readonly number[])[], change: Matrix, from: number) => points.map((p, i) => p.map((x, k) => x + change[from + i]![k]!));
  if (patch.kind === "tensor") {
    const net = valueOf(patch, "points") as Points, m = net[0]!.length;
    return { key: [...key, net.length, m], net, bases, folded: (row) => [...row], moved: (change) => ({ ...patch, points: net.map((row, i) => shifted(row, change, i * m)) }) };
  }
  const section = valueOf(patch, "section") as Points[0], trajectory = valueOf(patch, "trajectory") as Points[0], m = trajectory.length;
  const sums = (row: readonly number[], of: (cell: number) => number, count: number) => row.reduce((out, x, c) => { out[of(c)]! += x; return out; }, new Array<number>(count).fill(0));
  return {
    key: [...key, section.length, m], bases,
    net: section.map((c) => trajectory.map((p) => c.map((x, k) => x + p[k]!))),
    folded: (row) => [...sums(row, (c) => Math.floor(c / m), section.length), ...sums(row, (c) => c % m, m)],
    moved: (change) => ({ ...patch, section: shifted(section, change, 0), trajectory: shifted(trajectory, change, section.length) }),
  };
}

const inverses = new Map<string, number[][]>();

/** The pseudo-inverse of conditions, which hang on the functions and sides alone: one for a whole drag. */
function inverseOf(key: string, rows: Matrix): number[][] {
  let found = inverses.get(key);
  if (!found) {
    if (inverses.size > 256) inverses.clear();
    inverses.set(key, (found = pseudoInverse(rows, (largest) => RANK * largest)));
  }
  return found;
}

/** Derivatives 0 to `order` out of a patch along a side, [order][n][3]; null where there are none. */
function outOf(patch: Patch, side: Side, t: readonly number[], order: number): number[][][] | null {
  const surface = build(patch), u = side[0] === "u", signs = (k: number) => (side[1] === "1" ? 1 : (-1) ** k), net = surface.net;
  if (net && net.dimension === 3 && surface.rows instanceof Net && !surface.trim?.length && valueOf(patch, "basis") !== undefined) {
    const bases = chosenOf(patch), across = derivativesAt(bases[u ? 0 : 1]!, side[1] === "1", order), along = valuesAt(bases[u ? 1 : 0]!, t);
    const point = (i: number, j: number, x: number) => net.values[(u ? i * net.m + j : j * net.m + i) * 3 + x]!;
    if (across[0]!.length === (u ? net.n : net.m) && along[0]!.length === (u ? net.m : net.n)) {
      return across.map((weights, k) => {
        const rows = along[0]!.map((_, j) => [0, 1, 2].map((x) => signs(k) * weights.reduce((sum, w, i) => sum + w * point(i, j, x), 0)));
        return times(along, rows);
      });
    }
  }
  if (order > 2) return null;
  const found = place(surface, side, Float64Array.from(t)), from = u ? [0, 3, 9] : [0, 6, 15];
  return from.slice(0, order + 1).map((at, k) => found.map((s) => [0, 1, 2].map((x) => signs(k) * s[at + x]!)));
}

/** The derivatives of functions at an end, [order][size]. */
function derivativesAt(chosen: Chosen, end: boolean, order: number): number[][] {
  const series = chosen.formulas().series(Number(end), order);
  return Array.from({ length: order + 1 }, (_, k) => series.map((one) => [1, 1, 2, 6][k]! * one[k]!));
}

const valuesAt = (chosen: Chosen, t: readonly number[]): number[][] => {
  const functions = chosen.formulas();
  return t.map((x) => functions.series(x, 0).map((one) => one[0]!));
};

/** Coefficients by values at points along a side: least squares that holds the ends. */
function fitting(functions: Matrix): number[][] {
  const weight = (p: number) => (p === 0 || p === functions.length - 1 ? ENDS : 1);
  const inverse = pseudoInverse(functions.map((row, p) => row.map((x) => x * weight(p))), (largest) => 1e-15 * largest);
  return inverse.map((row) => row.map((x, p) => x * weight(p)));
}

const nodes = (count: number): number[] => Array.from({ length: count }, (_, i) => 0.5 - 0.5 * Math.cos((Math.PI * i) / (count - 1)));
const span = (values: readonly number[]): number => Math.max(...values) - Math.min(...values);

/** Whether the side runs the other way than the one that leads. */
function runsBack(lead: Patch, leadSide: Side, patch: Patch, side: Side): boolean | null {
  if (!SIDES.includes(leadSide) || !SIDES.includes(side)) return null;
  const at = Float64Array.of(0, 0.25, 0.75, 1), [a, b] = [place(build(lead), leadSide, at), place(build(patch), side, at)];
  const total = (back: boolean) => a.reduce((sum, p, i) => sum + Math.hypot(...[0, 1, 2].map((x) => p[x]! - b[back ? 3 - i : i]![x]!)), 0);
  return total(true) < total(false);
}
