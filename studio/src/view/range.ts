/** The ends of the colour map, common to everything shown, as the report's figures choose them. */

import data from "../data.json";
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
  /** How many grid points have a finite value. */
  readonly finite: number;
  /** Points without a finite value, a pole counted once, and those of them where it is infinite. */
  readonly missing: number;
  readonly infinite: number;
  /** Below this a value is rounding. */
  readonly noise: number;
  /** How many values fall in each of 48 steps from low to high. */
  readonly histogram: readonly number[];
}

/** Shares of the scale: a range as narrow as the first shows nothing, the second is rounding. */
const { sameColour: NOISE, noise: ROUNDING } = data.limits;
const BINS = 48;
let bends = new Float32Array(0);

/** What a surface adds to the range, kept until its values change. */
interface Part {
  readonly version: number;
  /** The finite values in order. */
  readonly sorted: Float32Array;
  readonly sum: number;
  readonly missing: number;
  readonly infinite: number;
  readonly scale: number;
}

const parts = new WeakMap<SurfaceMesh, Part>();

function partOf(mesh: SurfaceMesh, q: Quantity): Part {
  const known = parts.get(mesh);
  if (known?.version === mesh.version) return known;
  const { values, repeated, covered } = mesh, sorted = new Float32Array(values.length);
  let n = 0, sum = 0, infinite = 0, missing = 0;
  for (let p = 0; p < values.length; p++) {
    if (!covered[p]) continue;
    const value = values[p]!; // an iterator would box every one
    if (value - value === 0) {
      sorted[n++] = value;
      sum += value;
    } else if (!repeated[p]) {
      missing++;
      if (value === value) infinite++;
    }
  }
  const part = { version: mesh.version, sorted: sorted.subarray(0, n).sort(), sum, missing, infinite, scale: naturalScale(mesh, q) };
  parts.set(mesh, part);
  return part;
}

/** Common range of a real quantity over several surfaces: only those that changed are gone through. */
export function rangeOf(meshes: readonly SurfaceMesh[], q: Quantity, settings: Settings): Range {
  const all = meshes.map((mesh) => partOf(mesh, q)), lists = all.map((part) => part.sorted).filter((list) => list.length);
  const total = (of: (part: Part) => number) => all.reduce((sum, part) => sum + of(part), 0);
  const n = total((part) => part.sorted.length), scale = Math.max(...all.map((part) => part.scale));
  const least = Math.min(...lists.map((list) => list[0]!)), most = Math.max(...lists.map((list) => list.at(-1)!));
  let [low, high] = ends(lists, n, least, most, q, settings, scale);
  if (!(high > low)) [low, high] = [low - 0.5 * (Math.abs(low) || 1), low + 0.5 * (Math.abs(low) || 1)];
  const under = Array.from({ length: BINS + 1 }, (_, i) => below(lists, low + ((high - low) * i) / BINS, i === BINS));
  const histogram = under.slice(1).map((count, i) => count - under[i]!), share = n ? 1 / n : 0;
  return {
    low, high, below: under[0]! * share, above: (n - under[BINS]!) * share, least, most, mean: n ? total((part) => part.sum) / n : NaN, finite: n,
    missing: total((part) => part.missing), infinite: total((part) => part.infinite), histogram, noise: ROUNDING * scale,
  };
}

function ends(lists: readonly Float32Array[], n: number, least: number, most: number, q: Quantity, settings: Settings, scale: number): [number, number] {
  if (settings.range === "fixed") return [settings.low, settings.high];
  if (q.key === "shape_index") return [-1, 1];
  if (!n) return q.colour === "diverging" ? [-1, 1] : [0, 1];
  const robust = settings.range === "robust", cut = settings.percentile / 100, rank = (share: number) => Math.round(share * (n - 1));
  if (q.colour === "diverging") {
    const extreme = Math.max(-least, most);
    let bound = extreme;
    if (robust) bound = reach(smallest(0, extreme, rank(1 - cut), (x) => below(lists, x, true) - below(lists, -x)), extreme);
    if (bound <= NOISE * scale || bound === 0) bound = scale > 0 ? scale : 1;
    return [-bound, bound];
  }
  const at = (share: number) => smallest(least, most, rank(share), (x) => below(lists, x, true));
  let low = robust ? at(cut) : least, high = robust ? at(1 - cut) : most;
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

/** How many values of sorted lists are less than a number, or not greater. */
function below(lists: readonly Float32Array[], x: number, orEqual = false): number {
  let count = 0;
  for (const list of lists) {
    let left = 0, right = list.length;
    while (left < right) {
      const middle = (left + right) >> 1, value = list[middle]!;
      if (value < x || (orEqual && value === x)) left = middle + 1;
      else right = middle;
    }
    count += left;
  }
  return count;
}

/** The least 32-bit number from `low` to `high` that more than `rank` values are not greater than. */
function smallest(low: number, high: number, rank: number, upTo: (x: number) => number): number {
  if (upTo(low) > rank) return low;
  while (true) {
    const middle = Math.fround(0.5 * low + 0.5 * high);
    if (middle <= low || middle >= high) return high;
    if (upTo(middle) > rank) high = middle;
    else low = middle;
  }
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
    if (mesh.covered[p] && bend < Infinity) bends[n++] = bend;
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
