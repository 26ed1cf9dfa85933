/** The enveloping developable: the strip that a one-parameter family of planes touches (thesis §3.3). */

import data from "../data.json";
import { Bernstein, Trigonometric } from "./basis";
import type { Functions } from "./functions";
import type { Vector } from "./construct";
import { localOrigin, movedPlane } from "./origin";
import type { Rows, Surface } from "./surface";
import { jets, type Jet } from "./taylor";

const { noise: NOISE, rounding: ROUNDING } = data.limits;

/** Functions of the dual construction, with the series of what Π' is made of: of the steps between planes where they sum to 1. */
export interface Dual extends Functions {
  slopes(t: number, start: boolean, end: boolean, out: readonly Jet[]): void;
}

/** The strip enveloped by Π(t) = Σ f_i(t; α, ζ) L_i between two bounding planes; Error where there is none. */
export function developable(planes: readonly Vector[], bounds: readonly Vector[], functions: Dual, steps: boolean, flip: boolean): Surface {
  const origin = stripOrigin(new Envelope(planes, bounds, functions, steps));
  const local = (plane: Vector) => movedPlane(plane, origin);
  const rows = new Envelope(planes.map(local), bounds.map(local), functions, steps);
  if (!rows.meets()) {
    throw new Error(
      "planes: the control planes envelop no strip that the bounding planes cut (they are equal, parallel, or all " +
        "contain one line that a bounding plane contains too); change the planes or the bounds",
    );
  }
  return { rows, blend: new Bernstein(1), flip, net: null, origin };
}

/** An origin near most of a strip: some of its points may lie as good as at infinity. */
function stripOrigin(rows: Envelope): number[] {
  const n = 17, u = Float64Array.from({ length: n }, (_, i) => i / (n - 1)), out = new Float64Array(18 * n);
  rows.derivatives(u, n, out);
  const points = Array.from({ length: 2 * n }, (_, p) => Array.from(out.subarray(3 * p, 3 * p + 3)));
  const finite = points.filter((point) => point.every(Number.isFinite));
  const sorted = [0, 1, 2].map((x) => finite.map((point) => point[x]!).sort((a, b) => a - b));
  const at = (share: number) => sorted.map((values) => values[Math.floor(share * (values.length - 1))]!);
  return finite.length ? localOrigin([at(0.25), at(0.75)]) : [0, 0, 0];
}

/**
 * The two boundary curves of the strip: where the rulings Π ∩ Π' meet the bounding planes. With n and e the normals of Π
 * and Π', and b that of a bounding plane, n·A + d = 0 and n·A' = b·A' = 0, so A' = λ b × n with λ from the derivative of
 * Π'. Worked out in this order, the strip keeps its accuracy near the edge of regression.
 */
export class Envelope implements Rows {
  readonly size = 2;
  readonly dimension = 3;
  private readonly edges: number[][];
  private readonly start: boolean;
  private readonly end: boolean;
  private scratch = new Float64Array(0);
  private readonly hodograph: Jet[];

  /** `steps`: the functions sum to 1, and Π' is made of the steps between planes. */
  constructor(private readonly planes: readonly Vector[], private readonly bounds: readonly Vector[], private readonly functions: Dual, steps = true) {
    this.edges = steps ? planes.slice(1).map((plane, i) => plane.map((x, k) => x - planes[i]![k]!)) : planes.map((plane) => [...plane]);
    const still = (shape: "alpha" | "zeta", edge: readonly number[]) => functions instanceof Trigonometric && (functions[shape] === -4 || edge.every((x) => x === 0));
    this.start = still("alpha", this.edges[0]!);
    this.end = still("zeta", this.edges.at(-1)!);
    this.hodograph = jets(this.edges.length);
  }

  derivatives(u: Float64Array, n: number, out: Float64Array): void {
    const length = 3 * this.functions.size * n;
    if (this.scratch.length < length) this.scratch = new Float64Array(length);
    this.functions.derivatives(u, n, this.scratch);
    for (let p = 0; p < n; p++) {
      const { plane, slope } = this.dual(u[p]!, n, p);
      this.bounds.forEach((cut, j) => {
        boundary(plane, slope, cut).forEach((point, k) => {
          for (let x = 0; x < 3; x++) out[((k * n + p) * 2 + j) * 3 + x] = (k === 2 ? 2 : 1) * point[x]!;
        });
      });
    }
  }

  /** Whether some ruling exists and meets both bounding planes in a point. */
  meets(): boolean {
    const n = 33, u = Float64Array.from({ length: n }, (_, i) => i / (n - 1));
    this.scratch = new Float64Array(3 * this.functions.size * n);
    this.functions.derivatives(u, n, this.scratch);
    const volumes = this.bounds.map(() => 0), longest = [0, 0];
    for (let p = 0; p < n; p++) {
      const { plane, slope } = this.dual(u[p]!, n, p);
      const [first, second] = [plane[0]!.slice(0, 3), slope[0]!.slice(0, 3)];
      if (Number.isNaN(second[0]!)) continue;
      longest[0] = Math.max(longest[0]!, Math.hypot(...first));
      longest[1] = Math.max(longest[1]!, Math.hypot(...second));
      this.bounds.forEach((cut, j) => (volumes[j] = Math.max(volumes[j]!, Math.abs(dot(cross(first, second), cut)))));
    }
    return volumes.every((volume, j) => volume > NOISE * longest[0]! * longest[1]! * Math.hypot(...this.bounds[j]!.slice(0, 3)));
  }

  /** The series of Π and of Π' at point p, the latter without the factors that vanish where Π stands still. */
  private dual(t: number, n: number, p: number): { plane: number[][]; slope: number[][] } {
    this.functions.slopes(t, this.start, this.end, this.hodograph);
    const orders = [0, 1, 2], parts = [0, 1, 2, 3], { size } = this.functions;
    const plane = orders.map((k) => parts.map((x) => {
      let sum = 0;
      for (let i = 0; i < size; i++) sum += this.scratch[size * (k * n + p) + i]! * this.planes[i]![x]!;
      return k === 2 ? sum / 2 : sum;
    }));
    const slope = orders.map((k) => parts.map((x) => this.hodograph.reduce((sum, g, i) => sum + g[k]! * this.edges[i]![x]!, 0)));
    // Where the terms cancel to nothing the planes turn back, and rounding must not choose the ruling.
    const terms = parts.map((x) => this.hodograph.reduce((sum, g, i) => sum + Math.abs(g[0]! * this.edges[i]![x]!), 0));
    if (parts.every((x) => Math.abs(slope[0]![x]!) <= ROUNDING * terms[x]!)) slope[0]!.fill(NaN);
    return { plane, slope };
  }
}

/** The series of the point common to Π, Π' and a bounding plane, from those of the first two. */
function boundary(plane: number[][], slope: number[][], cut: Vector): [number[], number[], number[]] {
  const along = plane.map((n) => cross(cut, n)) as [number[], number[], number[]];
  const [e0, e1, e2] = slope as [number[], number[], number[]], n0 = plane[0]!;
  const volume0 = dot(e0, along[0]), volume1 = dot(e0, along[1]) + dot(e1, along[0]);
  const first = cross(e0, cut), last = cross(n0, e0);
  const point = [0, 1, 2].map((x) => -(n0[3]! * first[x]! + e0[3]! * along[0][x]! + cut[3]! * last[x]!) / volume0);
  // The derivative of e·A + d = 0 gives λ e·(b × n) = -(e'·A + d').
  const rate0 = (-e1[3]! - dot(e1, point)) / volume0;
  const tangent = along[0].map((x) => rate0 * x);
  const rate1 = (-2 * e2[3]! - dot(e1, tangent) - 2 * dot(e2, point) - rate0 * volume1) / volume0;
  return [point, tangent, along[0].map((x, i) => 0.5 * (rate0 * along[1][i]! + rate1 * x))];
}

/** A piece of the edge of regression inside a strip: its parameters, u rising. */
export interface Edge {
  readonly u: number[];
  readonly v: number[];
}

/** The pieces of the edge of regression that lie inside the strip, seen at `samples` rulings evenly spaced. */
export function regression(surface: Surface, samples = 257): Edge[] {
  const u = Float64Array.from({ length: samples }, (_, i) => i / (samples - 1));
  const q = new Float64Array(3 * samples * 6);
  surface.rows.derivatives(u, samples, q);
  const pairs = Array.from(u, (_, p) => jacobians(q, samples, p));
  // Where both vanish the whole ruling is singular, as at an end with shape parameter -4: no edge crosses there.
  const sizes = pairs.map(([a, b]) => Math.max(Math.abs(a), Math.abs(b)));
  const known = sizes.filter((size) => !Number.isNaN(size)).sort((a, b) => a - b);
  const least = NOISE * (known[known.length >> 1] ?? 0);
  const edges: Edge[] = [];
  let open = false;
  pairs.forEach(([a, b], p) => {
    const inside = a * b <= 0 && sizes[p]! > least;
    if (inside && !open) edges.push({ u: [], v: [] });
    if (inside) {
      edges.at(-1)!.u.push(u[p]!);
      edges.at(-1)!.v.push(a / (a - b));
    }
    open = inside;
  });
  return edges;
}

/** S_u × S_v at both boundaries along the common normal, length². */
function jacobians(q: Float64Array, n: number, p: number): [number, number] {
  const at = (k: number, j: number, x: number) => q[((k * n + p) * 2 + j) * 3 + x]!;
  const ruling = [0, 1, 2].map((x) => at(0, 1, x) - at(0, 0, x));
  const [a, b] = [0, 1].map((j) => cross([at(1, j, 0), at(1, j, 1), at(1, j, 2)], ruling)) as [number[], number[]];
  const larger = dot(a, a) > dot(b, b) ? a : b, length = Math.sqrt(dot(larger, larger)) || 1;
  return [dot(a, larger) / length, dot(b, larger) / length];
}

const dot = (a: Vector, b: Vector): number => a[0]! * b[0]! + a[1]! * b[1]! + a[2]! * b[2]!;

const cross = (a: Vector, b: Vector): number[] => [
  a[1]! * b[2]! - a[2]! * b[1]!, a[2]! * b[0]! - a[0]! * b[2]!, a[0]! * b[1]! - a[1]! * b[0]!,
];
