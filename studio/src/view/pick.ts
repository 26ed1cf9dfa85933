/** Which point of a surface lies under the pointer. */

export interface Hit {
  readonly u: number;
  readonly v: number;
  readonly distance: number;
}

/** Whether a line meets a box, given as low and high of x, y, z; a little widened, since its points are rounded. */
export function meets(box: readonly number[], origin: readonly number[], ray: readonly number[]): boolean {
  let near = -Infinity, far = Infinity;
  for (let x = 0; x < 3; x++) {
    const a = (box[x]! - 1e-5 - origin[x]!) / ray[x]!, b = (box[x + 3]! + 1e-5 - origin[x]!) / ray[x]!;
    // Along the slab there is no crossing: NaN, where the line runs in its side, leaves the interval as it is.
    near = Math.max(near, Math.min(a, b) || near);
    far = Math.min(far, Math.max(a, b) || far);
  }
  return near <= far;
}

/** The nearest hit of a ray (scene coordinates) with the grid's triangles, as shares s and t of the grid along u and v; `keep` tells what is not cut away. */
export function pick(
  position: Float32Array, n: number, origin: readonly number[], ray: readonly number[], keep: (x: number, y: number, z: number, s: number, t: number) => boolean,
): Hit | null {
  let best = Infinity, u = 0, v = 0;
  const [ox, oy, oz] = origin as [number, number, number], [dx, dy, dz] = ray as [number, number, number];
  for (let i = 0; i < n - 1; i++) {
    for (let k = 0; k < n - 1; k++) {
      const a = 3 * (i * n + k);
      for (let half = 0; half < 2; half++) {
        const b = half === 0 ? a + 3 * n : a + 3 * n + 3, c = half === 0 ? a + 3 * n + 3 : a + 3;
        const ax = position[a]!, ay = position[a + 1]!, az = position[a + 2]!;
        const ex = position[b]! - ax, ey = position[b + 1]! - ay, ez = position[b + 2]! - az;
        const fx = position[c]! - ax, fy = position[c + 1]! - ay, fz = position[c + 2]! - az;
        const px = dy * fz - dz * fy, py = dz * fx - dx * fz, pz = dx * fy - dy * fx;
        const det = ex * px + ey * py + ez * pz;
        if (det === 0) continue;
        const tx = ox - ax, ty = oy - ay, tz = oz - az;
        const s = (tx * px + ty * py + tz * pz) / det;
        if (s < -1e-9 || s > 1 + 1e-9) continue;
        const qx = ty * ez - tz * ey, qy = tz * ex - tx * ez, qz = tx * ey - ty * ex;
        const t = (dx * qx + dy * qy + dz * qz) / det;
        if (t < -1e-9 || s + t > 1 + 1e-9) continue;
        const distance = (fx * qx + fy * qy + fz * qz) / det;
        if (distance >= best) continue;
        // Corner b is (1, 0) or (1, 1) of the cell, corner c is (1, 1) or (0, 1).
        const along = (i + (half === 0 ? s + t : s)) / (n - 1), across = (k + (half === 0 ? t : s + t)) / (n - 1);
        if (keep(ox + distance * dx, oy + distance * dy, oz + distance * dz, along, across)) [best, u, v] = [distance, along, across];
      }
    }
  }
  if (best === Infinity) return null;
  const inside = (x: number) => Math.min(1, Math.max(0, x));
  return { u: inside(u), v: inside(v), distance: best };
}
