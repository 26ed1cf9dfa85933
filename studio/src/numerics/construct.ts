/** The constructions from control points: each is a net computed in a line or two. `shape` is (α1, ζ1, α2, ζ2). */

import { Bernstein, family, standing, type BasisName } from "./basis";
import { Joined } from "./functions";
import { localOrigin, movedPlane, seenFrom } from "./origin";
import { Net, type Points, type Surface } from "./surface";

export type Vector = readonly number[];
export type Shape = readonly number[];

export interface Options {
  readonly basis: BasisName;
  readonly flip: boolean;
}

/** Pack rows of points into one array. */
export function packed(rows: readonly (readonly Vector[])[]): Points {
  const n = rows.length, m = rows[0]!.length, dimension = rows[0]![0]!.length;
  const values = new Float64Array(n * m * dimension);
  rows.forEach((row, i) => row.forEach((point, j) => values.set(point, (i * m + j) * dimension)));
  return { values, n, m, dimension };
}

/** S = ΣΣ P_ij f_i(u; α1, ζ1) f_j(v; α2, ζ2) (thesis eq. 3.1). */
export function tensor(points: readonly (readonly Vector[])[], shape: Shape, options: Options): Surface {
  const origin = localOrigin(points.flat());
  return onLocal(points.map((row) => row.map((point) => seenFrom(point, origin))), origin, shape, options, packed(points));
}

/** The surface on points as seen from an origin; `net` holds them as they are, to be drawn. */
function onLocal(local: number[][][], origin: number[], shape: Shape, options: Options, net?: Points): Surface {
  const points = packed(local);
  const [a1, z1, a2, z2] = shape as [number, number, number, number];
  const columns = local[0]!.map((_, j) => local.map((row) => row[j]!));
  const u = family(options.basis, points.n, a1, z1, standing(a1, z1, local));
  const v = family(options.basis, points.m, a2, z2, standing(a2, z2, columns));
  net ??= packed(local.map((row) => row.map((point) => point.map((value, x) => value + origin[x]!))));
  return { rows: new Net(points, u), blend: v, flip: options.flip, net, origin };
}

/** The tensor-product surface on three rows and their images in the plane `mirror` (thesis §4.3.1). */
export function symmetric(half: readonly (readonly Vector[])[], mirror: Vector, shape: Shape, options: Options): Surface {
  const origin = localOrigin(half.flat()), plane = movedPlane(mirror, origin);
  const local = half.map((row) => row.map((point) => seenFrom(point, origin)));
  const image = local.map((row) => row.map((point) => reflected(point, plane))).reverse();
  return onLocal([...local, ...image], origin, shape, options);
}

/** The translational sweep S = C(u) + T(v) (thesis §3.2.2). */
export function swept(section: readonly Vector[], trajectory: readonly Vector[], shape: Shape, options: Options): Surface {
  const [first, second] = [localOrigin(section), localOrigin(trajectory)];
  const along = section.map((c) => seenFrom(c, first)), across = trajectory.map((t) => seenFrom(t, second));
  const sum = (a: readonly Vector[], b: readonly Vector[]) => a.map((c) => b.map((t) => c.map((x, i) => x + t[i]!)));
  const origin = first.map((value, x) => value + second[x]!);
  return onLocal(sum(along, across), origin, shape, options, packed(sum(section, trajectory)));
}

/** S = (λ r x, λ r y, z) from a profile (r, z)(u) and a trajectory (x, y)(v) (thesis §3.2.3). */
export function swung(
  profile: readonly Vector[], trajectory: readonly Vector[], shape: Shape, scale: number, options: Options,
): Surface {
  const points = profile.map(([r, z]) => trajectory.map(([x, y]) => [scale * r! * x!, scale * r! * y!, z!]));
  return tensor(points, shape, options);
}

/** S = (1 - v) A(u) + v B(u), A with (α1, ζ1) and B with (α2, ζ2) (thesis §3.2.4). */
export function ruled(first: readonly Vector[], second: readonly Vector[], shape: Shape, options: Options): Surface {
  const zero = [0, 0, 0];
  const origin = localOrigin([...first, ...second]);
  const points = packed([...first.map((p) => [seenFrom(p, origin), zero]), ...second.map((p) => [zero, seenFrom(p, origin)])]);
  const [a1, z1, a2, z2] = shape as [number, number, number, number];
  const one = standing(a1, z1, first.map((p) => [p])), two = standing(a2, z2, second.map((p) => [p]));
  const still = [one[0] && two[0], one[1] && two[1]] as const; // both boundaries must
  const functions = new Joined([
    family(options.basis, first.length, a1, z1, still),
    family(options.basis, second.length, a2, z2, still),
  ]);
  const net = first.length === second.length ? packed(first.map((p, i) => [p, second[i]!])) : null;
  return { rows: new Net(points, functions), blend: new Bernstein(1), flip: options.flip, net, origin };
}

/** The mirror image of a point in the plane (a, b, c, d). */
export function reflected(point: Vector, plane: Vector): number[] {
  const [a, b, c, d] = plane as [number, number, number, number];
  const height = (point[0]! * a + point[1]! * b + point[2]! * c + d) / (a * a + b * b + c * c);
  return [point[0]! - 2 * height * a, point[1]! - 2 * height * b, point[2]! - 2 * height * c];
}
