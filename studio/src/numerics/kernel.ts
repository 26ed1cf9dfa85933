/**
 * The driver behind every result: rows contracted once per u, the blend in registers, a few numbers per point kept in
 * scratch planes, then one loop per requested quantity. All arrays live in a `Grid` and are used again and again.
 */

import data from "../data.json";
import { besl, pointType, shapeClass, type Thresholds } from "./classify";
import { directionCos, directionSin, principalDirection, halfDifference, shapeIndex } from "./curvature";
import { planar, slopeForms, surface as ownMetric } from "./invariants";
import { QUANTITY } from "./quantity";
import { extent, type Surface } from "./surface";
import { windowOf } from "./trim";

/** A point is singular where |S_u × S_v| <= SINGULAR size². */
export const SINGULAR = data.limits.singular;

/** Curvedness times size at or below this is rounding of a plane. */
const NOISE = data.limits.noise;

/** Scratch planes, each of one number a point. */
export const PLANE = {
  a: 0, b: 1, c: 2, normal: 3, e1: 6, e2: 9, point: 12, forms: 15, mean: 21, halfDifference: 22, gaussian: 23, curvedness: 24,
} as const;
const PLANES = 25;

type Numbers = Float64Array | Float32Array | Int8Array;

/** A surface at the nu × nv points of a grid, or at n scattered points; buffers for the most points asked for so far. */
export class Grid {
  nu = 0;
  nv = 0;
  count = 0;
  size = 0;
  sign = 1;
  /** Distance between scratch planes. */
  stride = 0;
  planes = new Float64Array(0);
  low: number[] = [0, 0, 0];
  high: number[] = [0, 0, 0];
  /** The parameters of the grid last asked for by `evaluate`. */
  u: Float64Array = new Float64Array(0);
  v: Float64Array = new Float64Array(0);
  private rows = new Float64Array(0);
  private blend = new Float64Array(0);
  private origin: readonly number[] = [0, 0, 0];
  /** S, S_u, S_v, S_uu, S_uv, S_vv of one point. */
  private readonly partials = new Float64Array(18);

  /** Evaluate at the nu × nv points of an even grid over the domain, or over the window of a face's loops, edges included. */
  evaluate(surface: Surface, nu: number, nv: number): void {
    const [u0, v0, u1, v1] = windowOf(surface);
    this.u = steps(nu, u0, u1);
    this.v = steps(nv, v0, v1);
    this.evaluateAt(surface, this.u, this.v, true);
  }

  /** Evaluate at u × v when `onGrid`, else at the pairs (u[i], v[i]). */
  evaluateAt(surface: Surface, u: Float64Array, v: Float64Array, onGrid: boolean): void {
    const box = extent(surface);
    this.low = box.low;
    this.high = box.high;
    this.size = box.size;
    this.sign = surface.flip ? -1 : 1;
    this.nu = onGrid ? u.length : 1;
    this.nv = v.length;
    this.count = this.nu * this.nv;
    this.origin = surface.origin ?? [0, 0, 0];
    const m = surface.rows.size, d = surface.rows.dimension;
    if (this.rows.length < 3 * u.length * m * d) this.rows = new Float64Array(3 * u.length * m * d);
    if (this.blend.length < 3 * v.length * m) this.blend = new Float64Array(3 * v.length * m);
    if (this.stride < this.count) {
      this.stride = this.count;
      this.planes = new Float64Array(PLANES * this.stride);
    }
    surface.rows.derivatives(u, u.length, this.rows);
    surface.blend.derivatives(v, v.length, this.blend);
    const tiny = this.size > 0 ? SINGULAR * this.size * this.size : Infinity; // a single point has no tangent plane at all
    if (d === 4) this.driveRational(m, u.length, v.length, onGrid, tiny);
    else this.drive(m, u.length, v.length, onGrid, tiny);
  }

  /** Write a quantity, component by component side by side, to `out` (count × components numbers). */
  quantity(key: string, out: Numbers, thresholds: Thresholds): void {
    write(this, key, out, thresholds);
  }

  private drive(m: number, nu: number, nv: number, onGrid: boolean, tiny: number): void {
    const { rows: R, blend: D, partials: h } = this;
    const step = 3 * m * nu, next = m * nv;
    for (let p = 0; p < this.count; p++) {
      const i = onGrid ? (p / nv) | 0 : p, k = onGrid ? p - i * nv : p;
      let px = 0, py = 0, pz = 0, ux = 0, uy = 0, uz = 0, vx = 0, vy = 0, vz = 0;
      let uux = 0, uuy = 0, uuz = 0, uvx = 0, uvy = 0, uvz = 0, vvx = 0, vvy = 0, vvz = 0;
      for (let j = 0, r = 3 * m * i, d = m * k; j < m; j++, r += 3, d++) {
        const d0 = D[d]!, d1 = D[d + next]!, d2 = D[d + 2 * next]!;
        const x = R[r]!, y = R[r + 1]!, z = R[r + 2]!;
        const xu = R[r + step]!, yu = R[r + step + 1]!, zu = R[r + step + 2]!;
        px += x * d0; py += y * d0; pz += z * d0;
        ux += xu * d0; uy += yu * d0; uz += zu * d0;
        vx += x * d1; vy += y * d1; vz += z * d1;
        uux += R[r + 2 * step]! * d0; uuy += R[r + 2 * step + 1]! * d0; uuz += R[r + 2 * step + 2]! * d0;
        uvx += xu * d1; uvy += yu * d1; uvz += zu * d1;
        vvx += x * d2; vvy += y * d2; vvz += z * d2;
      }
      h[0] = px; h[1] = py; h[2] = pz; h[3] = ux; h[4] = uy; h[5] = uz; h[6] = vx; h[7] = vy; h[8] = vz;
      h[9] = uux; h[10] = uuy; h[11] = uuz; h[12] = uvx; h[13] = uvy; h[14] = uvz; h[15] = vvx; h[16] = vvy; h[17] = vvz;
      this.reduce(p, tiny);
    }
  }

  /** The same for homogeneous rows: blend all four coordinates, then divide by Leibniz's rule for w S. */
  private driveRational(m: number, nu: number, nv: number, onGrid: boolean, tiny: number): void {
    const { rows: R, blend: D, partials } = this;
    const step = 4 * m * nu, next = m * nv, h = new Float64Array(24);
    for (let p = 0; p < this.count; p++) {
      const i = onGrid ? (p / nv) | 0 : p, k = onGrid ? p - i * nv : p;
      h.fill(0);
      for (let j = 0, r = 4 * m * i, d = m * k; j < m; j++, r += 4, d++) {
        const d0 = D[d]!, d1 = D[d + next]!, d2 = D[d + 2 * next]!;
        for (let x = 0; x < 4; x++) {
          const q = R[r + x]!, qu = R[r + step + x]!;
          h[x]! += q * d0;
          h[4 + x]! += qu * d0;
          h[8 + x]! += q * d1;
          h[12 + x]! += R[r + 2 * step + x]! * d0;
          h[16 + x]! += qu * d1;
          h[20 + x]! += q * d2;
        }
      }
      const w = h[3]!, wu = h[7]!, wv = h[11]!, wuu = h[15]!, wuv = h[19]!, wvv = h[23]!;
      for (let x = 0; x < 3; x++) {
        const s = h[x]! / w;
        const su = (h[4 + x]! - wu * s) / w, sv = (h[8 + x]! - wv * s) / w;
        partials[x] = s;
        partials[3 + x] = su;
        partials[6 + x] = sv;
        partials[9 + x] = (h[12 + x]! - 2 * wu * su - wuu * s) / w;
        partials[12 + x] = (h[16 + x]! - wu * sv - wv * su - wuv * s) / w;
        partials[15 + x] = (h[20 + x]! - 2 * wv * sv - wvv * s) / w;
      }
      this.reduce(p, tiny);
    }
  }

  /** Reduce the partial derivatives of one point to its scratch planes. They come in an array: as arguments they would be boxed. */
  private reduce(p: number, tiny: number): void {
    const h = this.partials;
    const px = h[0]!, py = h[1]!, pz = h[2]!, ux = h[3]!, uy = h[4]!, uz = h[5]!, vx = h[6]!, vy = h[7]!, vz = h[8]!;
    const uux = h[9]!, uuy = h[10]!, uuz = h[11]!, uvx = h[12]!, uvy = h[13]!, uvz = h[14]!, vvx = h[15]!, vvy = h[16]!, vvz = h[17]!;
    const s = this.planes, n = this.stride, sign = this.sign;
    const e = ux * ux + uy * uy + uz * uz, f = ux * vx + uy * vy + uz * vz, g = vx * vx + vy * vy + vz * vz;
    const cx = uy * vz - uz * vy, cy = uz * vx - ux * vz, cz = ux * vy - uy * vx;
    const area = Math.sqrt(cx * cx + cy * cy + cz * cz);
    const inverse = area > tiny ? 1 / area : NaN;
    const scale = sign * inverse;
    const nx = cx * scale, ny = cy * scale, nz = cz * scale;
    const el = uux * nx + uuy * ny + uuz * nz, em = uvx * nx + uvy * ny + uvz * nz, en = vvx * nx + vvy * ny + vvz * nz;
    const ratio = f / e;
    const a = el / e, b = (em - ratio * el) * inverse;
    const c = (en - 2 * ratio * em + ratio * ratio * el) * (e * inverse) * inverse;
    const mean = 0.5 * (a + c), r = halfDifference(a, b, c);
    const unit = 1 / Math.sqrt(e), x = ux * unit, y = uy * unit, z = uz * unit;
    s[p] = a;
    s[n + p] = b;
    s[2 * n + p] = c;
    s[3 * n + p] = nx;
    s[4 * n + p] = ny;
    s[5 * n + p] = nz;
    s[6 * n + p] = x;
    s[7 * n + p] = y;
    s[8 * n + p] = z;
    s[9 * n + p] = sign * (ny * z - nz * y);
    s[10 * n + p] = sign * (nz * x - nx * z);
    s[11 * n + p] = sign * (nx * y - ny * x);
    s[12 * n + p] = px + this.origin[0]!;
    s[13 * n + p] = py + this.origin[1]!;
    s[14 * n + p] = pz + this.origin[2]!;
    s[15 * n + p] = e;
    s[16 * n + p] = f;
    s[17 * n + p] = g;
    s[18 * n + p] = el;
    s[19 * n + p] = em;
    s[20 * n + p] = en;
    s[21 * n + p] = mean;
    s[22 * n + p] = r;
    s[23 * n + p] = a * c - b * b;
    s[24 * n + p] = Math.sqrt(mean * mean + r * r);
  }
}

const FORMS = ["E", "F", "G", "L", "M", "N"];
const SIX = ["beta0", "beta1", "beta2", "gamma1", "gamma2", "gamma3"];
const gammas = new Float64Array(3), six = new Float64Array(6);

function write(grid: Grid, key: string, out: Numbers, thresholds: Thresholds): void {
  const { planes: s, stride: n, count } = grid;
  const copy = (plane: number, components = 1) => {
    for (let x = 0; x < components; x++) {
      for (let p = 0, q = (plane + x) * n; p < count; p++, q++) out[components * p + x] = s[q]!;
    }
  };
  const perSize = grid.size > 0 ? 1 / grid.size : Infinity;
  const flat = thresholds.flat * perSize, relative = thresholds.relative;
  switch (key) {
    case "point": return copy(PLANE.point, 3);
    case "normal": return copy(PLANE.normal, 3);
    case "gaussian": return copy(PLANE.gaussian);
    case "mean": return copy(PLANE.mean);
    case "curvedness": return copy(PLANE.curvedness);
    case "k1":
    case "k2": {
      const side = key === "k1" ? 1 : -1;
      for (let p = 0; p < count; p++) out[p] = s[PLANE.mean * n + p]! + side * s[PLANE.halfDifference * n + p]!;
      return;
    }
    case "direction1":
    case "direction2": return directions(grid, key === "direction2", relative, NOISE * perSize, out);
    case "shape_index":
      for (let p = 0; p < count; p++) out[p] = indexAt(s, n, p, NOISE * perSize);
      return;
    case "hk_type":
      for (let p = 0; p < count; p++) out[p] = beslAt(s, n, p, relative, flat);
      return;
    case "point_type":
      for (let p = 0; p < count; p++) {
        const code = beslAt(s, n, p, relative, flat);
        out[p] = pointType(code, s[PLANE.halfDifference * n + p]!, s[PLANE.curvedness * n + p]!, relative);
      }
      return;
    case "shape_class":
      for (let p = 0; p < count; p++) {
        out[p] = shapeClass(indexAt(s, n, p, NOISE * perSize), beslAt(s, n, p, relative, flat));
      }
      return;
    case "invariant_type":
      for (let p = 0; p < count; p++) {
        invariantsAt(grid, p, true);
        const half = 0.5 * six[1]!, square = 2 * half * half - six[2]!;
        // Rounding must not make a negative root; NaN stays NaN.
        out[p] = besl(six[2]!, half, Math.sqrt(Math.max(square, 0)), relative, flat);
      }
      return;
  }
  const form = FORMS.indexOf(key);
  if (form >= 0) return copy(PLANE.forms + form);
  const own = key.endsWith("_surface"), which = SIX.indexOf(own ? key.slice(0, -8) : key);
  if (which < 0) throw new Error(`unknown quantity '${key}'; known are ${Object.keys(QUANTITY).join(", ")}`);
  for (let p = 0; p < count; p++) {
    invariantsAt(grid, p, !own);
    out[p] = six[which]!;
  }
}

function beslAt(s: Float64Array, n: number, p: number, relative: number, flat: number): number {
  return besl(s[PLANE.gaussian * n + p]!, s[PLANE.mean * n + p]!, s[PLANE.curvedness * n + p]!, relative, flat);
}

function indexAt(s: Float64Array, n: number, p: number, noise: number): number {
  return shapeIndex(s[PLANE.mean * n + p]!, s[PLANE.halfDifference * n + p]!, s[PLANE.curvedness * n + p]!, noise);
}

function invariantsAt(grid: Grid, p: number, inPlane: boolean): void {
  const { planes: s, stride: n } = grid;
  const z1 = s[(PLANE.e1 + 2) * n + p]!, z2 = s[(PLANE.e2 + 2) * n + p]!, nz = s[(PLANE.normal + 2) * n + p]!;
  slopeForms(s[p]!, s[n + p]!, s[2 * n + p]!, z1, z2, grid.sign, gammas);
  const slope = z1 * z1 + z2 * z2, mean = s[PLANE.mean * n + p]!, gaussian = s[PLANE.gaussian * n + p]!;
  if (inPlane) planar(gammas, slope, mean, gaussian, nz, six);
  else ownMetric(gammas, slope, mean, gaussian, nz, six);
}

function directions(grid: Grid, second: boolean, relative: number, noise: number, out: Numbers): void {
  const { planes: s, stride: n, count } = grid;
  for (let p = 0; p < count; p++) {
    const r = s[PLANE.halfDifference * n + p]!;
    const bend = s[PLANE.curvedness * n + p]!, clear = r > relative * bend && bend > noise;
    principalDirection(s[p]!, s[n + p]!, s[2 * n + p]!, r);
    for (let x = 0; x < 3; x++) {
      const e1 = s[(PLANE.e1 + x) * n + p]!, e2 = s[(PLANE.e2 + x) * n + p]!;
      const value = second ? directionCos * e2 - directionSin * e1 : directionCos * e1 + directionSin * e2;
      out[3 * p + x] = clear ? value : NaN;
    }
  }
}

const steps = (n: number, low: number, high: number): Float64Array =>
  Float64Array.from({ length: n }, (_, i) => (i === n - 1 ? high : low + (high - low) * (i / (n - 1))));
