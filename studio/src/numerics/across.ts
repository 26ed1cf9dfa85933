/** A side of a patch, sampled, and how the surface runs across it: the numbers of a seam, as in Python's `multipatch`. */

import { SINGULAR } from "./kernel";
import { extent, type Surface } from "./surface";

export const SIDES = ["u0", "u1", "v0", "v1"] as const;
export type Side = (typeof SIDES)[number];
export type Vec3 = [number, number, number];

export const STEPS = 17;
const STEP = 1e-3; // of the domain, between points whose second partials give the third ones
const FORWARD = [-25 / 12, 4, -3, 4 / 3, -1 / 4]; // first derivative from five values, of fourth order

/** S, S_u, S_v, S_uu, S_uv, S_vv at pairs (u, v): 18 numbers each, length¹. */
export function partials(surface: Surface, u: Float64Array, v: Float64Array): Float64Array[] {
  const { rows, blend, origin = [0, 0, 0] } = surface, n = u.length, m = rows.size, d = rows.dimension;
  const q = new Float64Array(3 * n * m * d), f = new Float64Array(3 * n * m);
  rows.derivatives(u, n, q);
  blend.derivatives(v, n, f);
  const sum = (a: number, b: number, p: number, x: number) => {
    let total = 0;
    for (let j = 0; j < m; j++) total += q[((a * n + p) * m + j) * d + x]! * f[(b * n + p) * m + j]!;
    return total;
  };
  const orders = [[0, 0], [1, 0], [0, 1], [2, 0], [1, 1], [0, 2]] as const;
  return Array.from(u, (_, p) => {
    const out = new Float64Array(18);
    const w = d === 4 ? orders.map(([a, b]) => sum(a, b, p, 3)) : [1, 0, 0, 0, 0, 0];
    for (let x = 0; x < 3; x++) {
      const a = orders.map(([i, j]) => sum(i, j, p, x));
      const s = a[0]! / w[0]!, su = (a[1]! - w[1]! * s) / w[0]!, sv = (a[2]! - w[2]! * s) / w[0]!;
      out[x] = s + origin[x]!;
      out[3 + x] = su;
      out[6 + x] = sv;
      out[9 + x] = (a[3]! - 2 * w[1]! * su - w[3]! * s) / w[0]!;
      out[12 + x] = (a[4]! - w[1]! * sv - w[2]! * su - w[4]! * s) / w[0]!;
      out[15 + x] = (a[5]! - 2 * w[2]! * sv - w[5]! * s) / w[0]!;
    }
    return out;
  });
}

/** A side of a surface: its points at equal steps, length and the way across to the opposite side, length¹. */
export interface Edge {
  readonly surface: Surface;
  readonly side: Side;
  readonly points: readonly Vec3[];
  readonly length: number;
  readonly width: number;
  readonly low: Vec3;
  readonly high: Vec3;
}

const sizes = new WeakMap<Surface, number>();
/** The diagonal of a surface's bounding box, length¹. */
export function sizeOf(surface: Surface): number {
  if (!sizes.has(surface)) sizes.set(surface, extent(surface).size);
  return sizes.get(surface)!;
}

const known = new WeakMap<Surface, readonly Edge[]>();

/** The sides of a whole surface that are no poles; none of a trimmed one, whose sides are not its edges. */
export function edgesOf(surface: Surface): readonly Edge[] {
  let found = known.get(surface);
  if (!found) known.set(surface, (found = surface.trim?.length ? [] : sides(surface)));
  return found;
}

function sides(surface: Surface): Edge[] {
  const even = Float64Array.from({ length: STEPS }, (_, i) => i / (STEPS - 1));
  const lines = SIDES.map((side) => place(surface, side, even).map((s) => [s[0], s[1], s[2]] as Vec3));
  const size = sizeOf(surface), lengths = lines.map((line) => line.slice(1).reduce((sum, p, i) => sum + apart(p, line[i]!), 0));
  return SIDES.flatMap((side, k) => {
    const points = lines[k]!, opposite = lines[k ^ 1]!;
    const width = points.reduce((sum, p, i) => sum + apart(p, opposite[i]!), 0) / STEPS || (lengths[k < 2 ? 2 : 0]! + lengths[k < 2 ? 3 : 1]!) / 2;
    if (!(lengths[k]! > 1e-9 * size)) return [];
    const low = [0, 1, 2].map((x) => Math.min(...points.map((p) => p[x]!))) as Vec3, high = [0, 1, 2].map((x) => Math.max(...points.map((p) => p[x]!))) as Vec3;
    return [{ surface, side, points, length: lengths[k]!, width, low, high }];
  });
}

/** The partials at parameters along a side, `inside` of the domain by so much. */
export function place(surface: Surface, side: Side, t: Float64Array, inside = 0): Float64Array[] {
  const fixed = new Float64Array(t.length).fill(side[1] === "0" ? inside : 1 - inside);
  return side[0] === "u" ? partials(surface, fixed, t) : partials(surface, t, fixed);
}

/** How a surface runs across a side: out of it or into it; curvature and its rate bend towards `normal` = across × tangent. */
export interface Across {
  readonly normal: Vec3;
  readonly curvature: number;
  readonly rate: number;
  /** Whether `normal` is the surface's own. */
  readonly agrees: boolean;
}

/** See Python's `multipatch.continuity.across`: κ = n·S'', κ' = n·(S''' + 3 II) along the normal section (do Carmo 1976, §3-2). */
export function across({ surface, side }: Edge, t: Float64Array, outward: boolean, backwards: boolean): Across[] {
  const acrossU = side[0] === "u", into = side[1] === "0" ? 1 : -1;
  const depth = [0, 1, 2, 3, 4].map((k) => place(surface, side, t, k * STEP));
  const least = SINGULAR * sizeOf(surface) ** 2; // below it there is no tangent plane
  const ahead = t.map((x) => (x < 0.5 ? 1 : -1));
  const beside = [0, 1, 2, 3, 4].map((k) => place(surface, side, t.map((x, p) => x + k * STEP * ahead[p]!)));
  return depth[0]!.map((s, p) => {
    const at = (k: number, from = s): Vec3 => [from[3 * k]!, from[3 * k + 1]!, from[3 * k + 2]!];
    const slope = (k: number, values: Float64Array[][], sign: number): Vec3 => sumOf(FORWARD.map((c, i) => [(c * sign) / STEP, at(k, values[i]![p])]));
    const [su, sv, suu, suv, svv] = [at(1), at(2), at(3), at(4), at(5)];
    // Across the side all second partials are known at depths; along it only the one that is missing then is sought.
    const inner = [3, 4, 5].map((k) => slope(k, depth, into)), along = slope(acrossU ? 5 : 3, beside, ahead[p]!);
    const third = acrossU ? [inner[0]!, inner[1]!, inner[2]!, along] : [along, inner[0]!, inner[1]!, inner[2]!];
    const raw = cross(su, sv), area = Math.hypot(...raw), n = scaled(raw, area > least ? 1 / area : NaN);
    const tangent = unit(scaled(acrossU ? sv : su, backwards ? -1 : 1)), left = cross(n, tangent);
    const d = scaled(left, Math.sign(dot(left, acrossU ? su : sv)) * into * (outward ? -1 : 1));
    const e = dot(su, su), f = dot(su, sv), g = dot(sv, sv);
    const solve = (w: Vec3): [number, number] => {
      const a = dot(w, su), b = dot(w, sv);
      return [(g * a - f * b) / area ** 2, (e * b - f * a) / area ** 2];
    };
    const [x, y] = solve(d), second = sumOf([[x * x, suu], [2 * x * y, suv], [y * y, svv]]);
    const [xx, yy] = solve(scaled(second, -1));
    const rate = sumOf([
      [x ** 3, third[0]!], [3 * x * x * y, third[1]!], [3 * x * y * y, third[2]!], [y ** 3, third[3]!],
      [3 * x * xx, suu], [3 * (x * yy + y * xx), suv], [3 * y * yy, svv],
    ]);
    const normal = cross(d, tangent), turn = Math.sign(dot(normal, n));
    return { normal, curvature: turn * dot(n, second), rate: turn * dot(n, rate), agrees: (turn > 0) !== surface.flip };
  });
}

export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec3, b: Vec3): Vec3 => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const apart = (a: Vec3, b: Vec3): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const scaled = (a: Vec3, by: number): Vec3 => [a[0] * by, a[1] * by, a[2] * by];
const unit = (a: Vec3): Vec3 => scaled(a, 1 / Math.hypot(...a));
const sumOf = (terms: readonly (readonly [number, Vec3])[]): Vec3 =>
  [0, 1, 2].map((x) => terms.reduce((sum, [c, a]) => sum + c * a[x]!, 0)) as Vec3;
