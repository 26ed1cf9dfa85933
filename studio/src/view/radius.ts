/** Where a surface bends most: its smallest radius of curvature. */

import { PLANE } from "../numerics/kernel";
import { analyse } from "../numerics/sample";
import type { Surface } from "../numerics/surface";
import { covers } from "../numerics/trim";
import type { SurfaceMesh } from "./mesh";

export interface Sharpest {
  readonly u: number;
  readonly v: number;
  readonly point: readonly number[];
  /** Smallest radius, length¹. */
  readonly radius: number;
}

/** Start at the sharpest grid point and search around it with ever smaller steps; null where nothing bends. */
export function sharpest(surface: Surface, mesh: SurfaceMesh): Sharpest | null {
  const { planes: s, stride, count, nu, nv } = mesh.grid;
  let best = 0, at = -1;
  for (let p = 0; p < count; p++) {
    const bend = Math.abs(s[PLANE.mean * stride + p]!) + s[PLANE.halfDifference * stride + p]!;
    if (bend > best && bend < Infinity && mesh.covered[p]) {
      best = bend;
      at = p;
    }
  }
  if (at < 0 || !(best * mesh.grid.size > 1e-9)) return null;
  let u = mesh.grid.u[Math.floor(at / nv)]!, v = mesh.grid.v[at % nv]!, point: readonly number[] = [];
  const inside = (x: number) => Math.min(1, Math.max(0, x));
  for (let step = 0.5 / (nu - 1); step > 1e-6; step *= 0.5) {
    const around = [-1, 0, 1].map((k) => k * step);
    const us = around.map((d) => inside(u + d)), vs = around.map((d) => inside(v + d));
    const sample = analyse(surface, us, vs, false, ["k1", "k2", "point"]);
    for (let p = 0; p < 9; p++) {
      if (!covers(surface, us[Math.floor(p / 3)]!, vs[p % 3]!)) continue;
      const bend = Math.max(Math.abs(sample["k1"]![p]!), Math.abs(sample["k2"]![p]!));
      if (bend >= best || (p === 4 && !point.length)) {
        best = Math.max(best, bend);
        u = us[Math.floor(p / 3)]!;
        v = vs[p % 3]!;
        point = Array.from(sample["point"]!.subarray(3 * p, 3 * p + 3));
      }
    }
  }
  return { u, v, point, radius: 1 / best };
}
