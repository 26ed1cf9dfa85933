/** The seams of a model, measured in the browser: sides that meet, whole or in part, and whole ones that nearly do. */

import { across, apart, cross, dot, edgesOf, place, STEPS, type Edge, type Vec3 } from "./across";
import { build, type Model } from "./model";
import { extent, type Surface } from "./surface";

export const ORDERS = ["open", "G0", "G1", "G2", "G3"] as const;
export type Order = (typeof ORDERS)[number];

/** A side of a patch, and the stretch of it along which it meets another one: parameters from 0 to 1. */
export interface End { readonly patch: number; readonly side: Edge["side"]; readonly from: number; readonly to: number }

/** Largest values along two sides that meet: gap (length¹), angle of the normals (degrees), relative jumps of curvature and its rate. */
export interface Seam {
  readonly first: End;
  readonly second: End;
  readonly reversed: boolean;
  readonly gap: number;
  readonly angle: number;
  readonly curvature: number;
  readonly rate: number;
  readonly order: Order;
  readonly points: readonly Vec3[];
}

const IN_MM: Record<string, number> = { um: 1e3, mm: 1, cm: 0.1, m: 1e-3, km: 1e-6, in: 1 / 25.4, ft: 1 / 304.8 };
const NEAR = 0.2, FLAT = 1e-3; // as in Python: a near miss, of length and width; the curvature at a size that is none
const LITTLE = 0.05; // of a side: less than that in common is a corner
const GAP = 0.01, ANGLE = 0.1, JUMP = 0.05; // the engineering limits: mm, degrees, and relative

interface Measured extends Omit<Seam, "first" | "second" | "curvature" | "rate" | "order"> {
  readonly stretches: readonly [Stretch, Stretch];
  readonly curvatures: readonly (readonly [number, number])[];
  readonly rates: readonly (readonly [number, number])[];
}

const measuredPairs = new WeakMap<Edge, WeakMap<Edge, Measured | null>>();

/** The seams between surfaces (null where a patch has none). Pairs whose surfaces are the same objects as before are not measured again. */
export function seamsOf(surfaces: readonly (Surface | null)[], unit: string): Seam[] {
  const edges = surfaces.flatMap((surface, patch) => (surface ? edgesOf(surface).map((edge) => ({ patch, edge })) : []));
  if (!edges.length) return [];
  const least = Math.min(...surfaces.flatMap((surface) => (surface ? [sizeOf(surface)] : []))) || 1;
  const span = Math.hypot(...[0, 1, 2].map((x) => Math.max(...edges.map(({ edge }) => edge.high[x]!)) - Math.min(...edges.map(({ edge }) => edge.low[x]!))));
  const tolerance = GAP * (IN_MM[unit] ?? 1e-3 * span), floor = FLAT / least;
  const found: Seam[] = [];
  edges.forEach(({ patch, edge }, i) => {
    for (const other of edges.slice(i + 1)) {
      const pair = met(edge, other.edge, tolerance);
      if (!pair) continue;
      const { curvatures, rates, stretches, ...rest } = pair, curvature = largest(curvatures, floor), rate = largest(rates, floor / least);
      const steps = [rest.gap <= tolerance, rest.angle <= ANGLE, curvature <= JUMP, rate <= JUMP], fails = steps.indexOf(false);
      found.push({ first: { patch, side: edge.side, ...stretches[0] }, second: { patch: other.patch, side: other.edge.side, ...stretches[1] }, ...rest, curvature, rate, order: ORDERS[fails < 0 ? 4 : fails]! });
    }
  });
  // A side that meets another one is no near miss of a third.
  const key = (end: Seam["first"]) => `${end.patch} ${end.side}`, closed = new Set(found.filter((one) => one.order !== "open").flatMap((one) => [key(one.first), key(one.second)]));
  return found.filter((one) => one.order !== "open" || !(closed.has(key(one.first)) || closed.has(key(one.second))));
}

/** The seams of a model whose patches are built here. */
export const seams = (model: Model): Seam[] => seamsOf(model.patches.map(build), model.unit);

const sizes = new WeakMap<Surface, number>();
function sizeOf(surface: Surface): number {
  if (!sizes.has(surface)) sizes.set(surface, extent(surface).size);
  return sizes.get(surface)!;
}

const largest = (pairs: Measured["curvatures"], floor: number): number => Math.max(...pairs.map(([a, b]) => Math.abs(a - b) / Math.max(Math.abs(a) + Math.abs(b), floor)));

function met(first: Edge, second: Edge, tolerance: number): Measured | null {
  const reach = Math.max(tolerance, NEAR * Math.min(first.length, first.width, second.length, second.width));
  for (const x of [0, 1, 2] as const) if (first.low[x] > second.high[x] + reach || second.low[x] > first.high[x] + reach) return null;
  const cache = measuredPairs.get(first) ?? new WeakMap<Edge, Measured | null>();
  measuredPairs.set(first, cache);
  if (!cache.has(second)) cache.set(second, measured(first, second, reach, tolerance));
  return cache.get(second)!;
}

interface Stretch { readonly from: number; readonly to: number }
/** Points of the first side by their parameters, and the nearest ones of the second. */
interface Contact { readonly t: Float64Array; readonly feet: Float64Array; readonly reversed: boolean }

function measured(first: Edge, second: Edge, reach: number, tolerance: number): Measured | null {
  const all = whole(first, second, reach), contact = all && gapOf(first, second, all) <= tolerance ? all : part(first, second, tolerance) ?? all;
  if (!contact) return null;
  const { t, feet, reversed } = contact, gap = gapOf(first, second, contact), last = STEPS - 1;
  const points = contact === all ? first.points : place(first.surface, first.side, t).map((s) => [s[0], s[1], s[2]] as Vec3);
  const stretch = (x: Float64Array): Stretch => ({ from: Math.min(x[0]!, x[last]!), to: Math.max(x[0]!, x[last]!) });
  const same = { reversed, gap, points, stretches: [stretch(t), stretch(feet)] as const };
  const one = across(first, t, true, false), two = across(second, feet, false, reversed);
  const good = one.flatMap((a, i) => (Number.isFinite(a.curvature + two[i]!.curvature) ? [i] : []));
  if (!good.length) return { ...same, angle: NaN, curvatures: [], rates: [] };
  return {
    ...same,
    angle: Math.max(...good.map((i) => (180 / Math.PI) * Math.atan2(Math.hypot(...cross(one[i]!.normal, two[i]!.normal)), dot(one[i]!.normal, two[i]!.normal)))),
    curvatures: good.map((i) => [one[i]!.curvature, two[i]!.curvature]), rates: good.map((i) => [one[i]!.rate, two[i]!.rate]),
  };
}

const even = Float64Array.from({ length: STEPS }, (_, i) => i / (STEPS - 1));

function gapOf(first: Edge, second: Edge, { t, feet }: Contact): number {
  const here = place(first.surface, first.side, t), there = place(second.surface, second.side, feet);
  return Math.max(...here.map((s, i) => apart([s[0]!, s[1]!, s[2]!], [there[i]![0]!, there[i]![1]!, there[i]![2]!])));
}

/** The contact of two sides along all of both, or null where they are farther apart than that. */
function whole(first: Edge, second: Edge, reach: number): Contact | null {
  const last = STEPS - 1;
  const ends = (back: boolean) => Math.max(apart(first.points[0]!, second.points[back ? last : 0]!), apart(first.points[last]!, second.points[back ? 0 : last]!));
  const middle = (back: boolean) => first.points.reduce((sum, p, i) => sum + apart(p, second.points[back ? last - i : i]!), 0);
  const reversed = middle(true) < middle(false);
  if (ends(reversed) > reach) return null;
  const contact = { t: even, feet: feetOf(first.points, second, even.map((x) => (reversed ? 1 - x : x))), reversed };
  return gapOf(first, second, contact) > reach ? null : contact;
}

/** The contact of two sides that meet along a part of one or of both, between ends of either: a T-junction, say. */
function part(first: Edge, second: Edge, tolerance: number): Contact | null {
  const on = (edge: Edge, p: Vec3): number | null => {
    const near = edge.points.reduce((best, q, i) => (apart(q, p) < apart(edge.points[best]!, p) ? i : best), 0), last = STEPS - 1;
    // Beside its samples a side is no farther from them than they are from each other.
    if (apart(edge.points[near]!, p) > tolerance + Math.max(apart(edge.points[near]!, edge.points[Math.max(near - 1, 0)]!), apart(edge.points[near]!, edge.points[Math.min(near + 1, last)]!))) return null;
    const [foot] = feetOf([p], edge, Float64Array.of(near / last)), [s] = place(edge.surface, edge.side, Float64Array.of(foot!));
    return apart(p, [s![0]!, s![1]!, s![2]!]) <= tolerance ? foot! : null;
  };
  const corner = (edge: Edge, end: 0 | 1): Vec3 => edge.points[end * (STEPS - 1)]!;
  const ends = ([0, 1] as const).flatMap((end) => [
    ...(on(second, corner(first, end)) === null ? [] : [end as number]),
    ...[on(first, corner(second, end))].filter((x) => x !== null),
  ]);
  const low = Math.min(...ends), high = Math.max(...ends);
  if (!(high - low > LITTLE)) return null;
  const t = even.map((x) => low + (high - low) * x), points = place(first.surface, first.side, t).map((s) => [s[0], s[1], s[2]] as Vec3);
  const starts = [points[0]!, points[STEPS - 1]!].map((p) => on(second, p));
  if (starts[0] == null || starts[1] == null || !(Math.abs(starts[1] - starts[0]) > LITTLE * LITTLE)) return null;
  const contact = { t, feet: feetOf(points, second, even.map((x) => starts[0]! + (starts[1]! - starts[0]!) * x)), reversed: starts[1] < starts[0] };
  return gapOf(first, second, contact) <= tolerance ? contact : null;
}

/** The parameters of the points of a side nearest to others, from a start, by Gauss-Newton. */
function feetOf(points: readonly Vec3[], second: Edge, start: Float64Array): Float64Array {
  let feet = start;
  const way = second.side[0] === "u" ? 6 : 3;
  for (let step = 0; step < 10; step++) {
    const there = place(second.surface, second.side, feet);
    const next = feet.map((x, i) => {
      const s = there[i]!, d: Vec3 = [s[way]!, s[way + 1]!, s[way + 2]!], p = points[i]!;
      const by = dot([p[0] - s[0]!, p[1] - s[1]!, p[2] - s[2]!], d) / Math.max(dot(d, d), 1e-300);
      return Math.min(1, Math.max(0, x + by));
    });
    const most = Math.max(...next.map((x, i) => Math.abs(x - feet[i]!)));
    feet = next;
    if (most < 1e-13) break;
  }
  return feet;
}
