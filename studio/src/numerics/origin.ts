/**
 * A local origin: where a surface lies far out, its rows hold how far they are from a point near it, so that no sum,
 * product or quotient sees the distance. It is a multiple of a power of two of about four sizes, so that subtracting it
 * rounds nothing far out, and zero for whatever lies about the coordinate origin.
 */

type Vector = readonly number[];

/** An origin for points; those that are not finite are left out. */
export function localOrigin(points: readonly Vector[], dimension = 3): number[] {
  const low = new Array<number>(dimension).fill(Infinity), high = new Array<number>(dimension).fill(-Infinity);
  for (const point of points) {
    if (!point.every(Number.isFinite)) continue;
    for (let x = 0; x < dimension; x++) {
      low[x] = Math.min(low[x]!, point[x]!);
      high[x] = Math.max(high[x]!, point[x]!);
    }
  }
  const size = Math.max(...low.map((value, x) => high[x]! - value));
  if (!Number.isFinite(size)) return low.map(() => 0);
  const middle = low.map((value, x) => 0.5 * value + 0.5 * high[x]!);
  const step = 2 ** (Math.floor(Math.log2(size)) + 3);
  return size > 0 && step > 0 && Number.isFinite(step) ? middle.map((value) => Math.round(value / step) * step + 0) : middle;
}

/** A point as seen from an origin. */
export const seenFrom = (point: Vector, origin: Vector): number[] => point.map((value, x) => value - origin[x]!);

/** The plane a x + b y + c z + d = 0 as seen from an origin, d worked out in twice the digits. */
export function movedPlane(plane: Vector, origin: Vector): number[] {
  if (origin.every((value) => value === 0)) return [...plane];
  let sum = plane[3]!, rest = 0;
  for (let x = 0; x < 3; x++) {
    const product = plane[x]! * origin[x]!;
    const [a, b] = halves(plane[x]!), [c, d] = halves(origin[x]!);
    const low = b * d - (product - a * c - b * c - a * d); // what the product has lost (Dekker 1971)
    const next = sum + product, part = next - sum;
    rest += sum - (next - part) + (product - part) + low; // what the sum has lost (Knuth)
    sum = next;
  }
  return [plane[0]!, plane[1]!, plane[2]!, sum + rest];
}

/** A number as the sum of two of half its digits (Veltkamp). */
function halves(value: number): [number, number] {
  const wide = 134217729 * value, high = wide - (wide - value);
  return [high, value - high];
}
