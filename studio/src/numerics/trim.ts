/** Which parameters lie on a trimmed face: inside its closed loops, by the even-odd rule. */

import type { Surface } from "./surface";

/** A closed loop of parameters (u, v). */
export type Loop = readonly (readonly number[])[];

/** Whether (u, v) lies on the face; everywhere where nothing is cut off. */
export function covers({ trim = [] }: Surface, u: number, v: number): boolean {
  return !trim.length || crossings(trim, u).filter((at) => at > v).length % 2 === 1 || onLoop(trim, u, v);
}

/** For the points of the grid u × v, v running fastest, 1 on the face and 0 off it. */
export function coverage({ trim = [] }: Surface, u: ArrayLike<number>, v: ArrayLike<number>): Uint8Array {
  const m = v.length, found = new Uint8Array(u.length * m).fill(trim.length ? 0 : 1);
  if (!trim.length) return found;
  for (let i = 0; i < u.length; i++) {
    const at = crossings(trim, u[i]!).sort((a, b) => a - b);
    for (let k = 0, passed = 0; k < m; k++) {
      while (passed < at.length && at[passed]! <= v[k]!) passed++;
      found[i * m + k] = passed % 2;
    }
  }
  return found;
}

/** The least and the greatest u and v of the loops: [u0, v0, u1, v1]. */
export function windowOf({ trim = [] }: Surface): readonly [number, number, number, number] {
  if (!trim.length) return [0, 0, 1, 1];
  const low = [1, 1], high = [0, 0];
  for (const point of trim.flat()) {
    for (const x of [0, 1]) {
      low[x] = Math.min(low[x]!, point[x]!);
      high[x] = Math.max(high[x]!, point[x]!);
    }
  }
  return [low[0]!, low[1]!, high[0]!, high[1]!];
}

/** Where the line of constant u crosses the loops, in v. */
function crossings(loops: readonly Loop[], u: number): number[] {
  const found: number[] = [];
  for (const loop of loops) {
    let [u0, v0] = loop.at(-1) as [number, number];
    for (const point of loop) {
      const [u1, v1] = point as [number, number];
      if (u0 > u !== u1 > u) found.push(v0 + ((u - u0) / (u1 - u0)) * (v1 - v0));
      [u0, v0] = [u1, v1];
    }
  }
  return found;
}

const ON_LOOP = 1e-9; // as in Python: parameters this near to a loop are on it

function onLoop(loops: readonly Loop[], u: number, v: number): boolean {
  return loops.some((loop) => loop.some(([u1, v1], i) => {
    const [u0, v0] = loop.at(i - 1)!, du = u1! - u0!, dv = v1! - v0!, length = Math.hypot(du, dv);
    const along = (u - u0!) * du + (v - v0!) * dv, off = (u - u0!) * dv - (v - v0!) * du;
    return length > 0 && Math.abs(off) <= ON_LOOP * length && along >= 0 && along <= length * length;
  }));
}
