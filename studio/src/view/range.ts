/** The ends of the colour map, common to everything shown, as the report's figures choose them. */

import { PLANE } from "../numerics/kernel";
import type { Quantity } from "../numerics/quantity";
import type { Settings } from "../app/settings";
import type { SurfaceMesh } from "./mesh";

export interface Range {
  readonly low: number;
  readonly high: number;
  /** Shares of the finite values beyond the ends. */
  readonly below: number;
  readonly above: number;
  readonly least: number;
  readonly most: number;
  readonly mean: number;
  /** Grid points without a finite value, and those of them where it is infinite. */
  readonly missing: number;
  readonly infinite: number;
  readonly count: number;
  /** Below this a value is rounding. */
  readonly noise: number;
  /** How many values fall in each of 48 steps from low to high. */
  readonly histogram: readonly number[];
}

const NOISE = 1e-9; // of the scale: a range as narrow as this shows nothing
const ROUNDING = 1e-12; // of the scale, as in Python's tables
const BINS = 48;
let pool = new Float32Array(0), bends = new Float32Array(0);

/** Common range of a real quantity over several surfaces; `scale` is the size its rounding is relative to. */
export function rangeOf(meshes: readonly SurfaceMesh[], q: Quantity, settings: Settings): Range {
  const total = meshes.reduce((sum, mesh) => sum + mesh.values.length, 0);
  if (pool.length < total) pool = new Float32Array(total);
  let n = 0, least = Infinity, most = -Infinity, sum = 0, scale = 1, infinite = 0;
  for (const mesh of meshes) {
    scale = Math.max(scale === 1 ? 0 : scale, naturalScale(mesh, q));
    const { values } = mesh;
    for (let p = 0; p < values.length; p++) {
      const value = values[p]!; // an iterator would box every one
      if (value - value !== 0) {
        if (value === value) infinite++;
        continue;
      }
      pool[n++] = value;
      sum += value;
      if (value < least) least = value;
      if (value > most) most = value;
    }
  }
  const finite = pool.subarray(0, n);
  let [low, high] = ends(finite, least, most, q, settings, scale);
  if (!(high > low)) [low, high] = [low - 0.5 * (Math.abs(low) || 1), low + 0.5 * (Math.abs(low) || 1)];
  let below = 0, above = 0;
  const histogram = new Array<number>(BINS).fill(0), per = BINS / (high - low);
  for (const mesh of meshes) {
    const { values } = mesh;
    for (let p = 0; p < values.length; p++) {
      const value = values[p]!;
      if (value < low) below++;
      else if (value > high) above++;
      else if (value - value === 0) histogram[Math.min(BINS - 1, Math.floor((value - low) * per))]!++;
    }
  }
  const share = n ? 1 / n : 0;
  return {
    low, high, below: below * share, above: above * share, least, most, mean: n ? sum / n : NaN, missing: total - n, infinite, count: total, histogram, noise: ROUNDING * scale,
  };
}

function ends(values: Float32Array, least: number, most: number, q: Quantity, settings: Settings, scale: number): [number, number] {
  if (settings.range === "fixed") return [settings.low, settings.high];
  if (q.key === "shape_index") return [-1, 1];
  if (!values.length) return q.colour === "diverging" ? [-1, 1] : [0, 1];
  const robust = settings.range === "robust", cut = settings.percentile / 100;
  if (q.colour === "diverging") {
    const extreme = Math.max(-least, most);
    let bound = extreme;
    if (robust) {
      for (let i = 0; i < values.length; i++) values[i] = Math.abs(values[i]!);
      bound = reach(select(values, 1 - cut), extreme);
    }
    if (bound <= NOISE * scale || bound === 0) bound = scale > 0 ? scale : 1;
    return [-bound, bound];
  }
  let low = robust ? select(values, cut) : least, high = robust ? select(values, 1 - cut) : most;
  const middle = 0.5 * (low + high);
  if (robust) {
    low = middle - reach(middle - low, middle - least);
    high = middle + reach(high - middle, most - middle);
  }
  if (low >= 0 && low <= 0.4 * high) low = 0; // zero means something, so let it be seen
  if (high > low && high - low >= Math.max(0.02 * Math.abs(middle), NOISE * scale)) return [low, high];
  const half = Math.abs(middle) > NOISE * scale ? 0.5 * Math.abs(middle) : scale || 1;
  return [middle - half, middle + half];
}

/** The extreme where it is hardly beyond the robust end, else the robust end. */
const reach = (robust: number, extreme: number): number => (extreme <= 1.5 * robust ? extreme : robust);

/** The size against which rounding of a quantity is judged, as in Python's figures: the largest curvedness but for 2 %, or the size. */
function naturalScale(mesh: SurfaceMesh, q: Quantity): number {
  const { size, planes, stride, count } = mesh.grid;
  if (q.power === 0 || !(size > 0)) return 1;
  if (q.power > 0) return size ** q.power;
  if (bends.length < count) bends = new Float32Array(count);
  let n = 0;
  for (let p = 0; p < count; p += 7) {
    const bend = planes[PLANE.curvedness * stride + p]!;
    if (bend < Infinity) bends[n++] = bend;
  }
  return Math.max(n ? select(bends.subarray(0, n), 0.98) : 0, 1 / size) ** -q.power;
}

/** The value below which a share of the numbers lies, by Hoare's selection; reorders them. */
function select(values: Float32Array, share: number): number {
  const k = Math.round(share * (values.length - 1));
  let left = 0, right = values.length - 1;
  while (left < right) {
    const pivot = values[(left + right) >> 1]!;
    let i = left, j = right;
    while (i <= j) {
      while (values[i]! < pivot) i++;
      while (values[j]! > pivot) j--;
      if (i <= j) {
        const swap = values[i]!;
        values[i++] = values[j]!;
        values[j--] = swap;
      }
    }
    if (k <= j) right = j;
    else if (k >= i) left = i;
    else break;
  }
  return values[k]!;
}
