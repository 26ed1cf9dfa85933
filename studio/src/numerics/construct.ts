/** The constructions from control points: each is a net computed in a line or two, on one basis for each direction. */

import { Bernstein } from "./basis";
import type { Chosen } from "./chosen";
import { Joined } from "./functions";
import { localOrigin, movedPlane, seenFrom } from "./origin";
import { Net, type Points, type Surface } from "./surface";

export type Vector = readonly number[];
/** The bases in u and v, or of the first and second curve. */
export type Bases = readonly Chosen[];

/** Pack rows of points into one array. */
export function packed(rows: readonly (readonly Vector[])[]): Points {
  const n = rows.length, m = rows[0]!.length, dimension = rows[0]![0]!.length;
  const values = new Float64Array(n * m * dimension);
  rows.forEach((row, i) => row.forEach((point, j) => values.set(point, (i * m + j) * dimension)));
  return { values, n, m, dimension };
}

/** S = ΣΣ P_ij f_i(u; α1, ζ1) f_j(v; α2, ζ2) (thesis eq. 3.1). */
export function tensor(points: readonly (readonly Vector[])[], bases: Bases, flip: boolean): Surface {
  const origin = localOrigin(points.flat());
  return onLocal(points.map((row) => row.map((point) => seenFrom(point, origin))), origin, bases, flip, packed(points));
}

/** The surface on points as seen from an origin; `net` holds them as they are, to be drawn. */
function onLocal(local: number[][][], origin: number[], bases: Bases, flip: boolean, net?: Points): Surface {
  const whole = () => local.map((row) => row.map((point) => point.map((value, x) => value + origin[x]!)));
  net ??= packed(whole());
  // Functions that do not sum to 1 move with the coordinate origin, and only that one is meant.
  if (!bases.every((one) => one.partition)) [local, origin] = [whole(), [0, 0, 0]];
  const columns = local[0]!.map((_, j) => local.map((row) => row[j]!));
  const u = bases[0]!.functions(bases[0]!.still(local)), v = bases[1]!.functions(bases[1]!.still(columns));
  return { rows: new Net(packed(local), u), blend: v, flip, net, origin };
}

/** The tensor-product surface on half of the rows and their images in the plane `mirror` (thesis §4.3.1); `odd`: the last row given is the middle one. */
export function symmetric(half: readonly (readonly Vector[])[], mirror: Vector, odd: boolean, bases: Bases, flip: boolean): Surface {
  const origin = localOrigin(half.flat()), plane = movedPlane(mirror, origin);
  const local = half.map((row) => row.map((point) => seenFrom(point, origin)));
  const image = local.map((row) => row.map((point) => reflected(point, plane))).reverse();
  if (odd) {
    const away = Math.max(...image[0]!.flatMap((point, j) => point.map((x, i) => Math.abs(x - local.at(-1)![j]![i]!))));
    if (away > 1e-9 * Math.max(...local.flat(2).map(Math.abs))) {
      throw new Error(`points[${half.length - 1}]: expected points on the mirror plane, as this basis has a middle row, found them ${Number((0.5 * away).toPrecision(3))} away`);
    }
    image.shift();
  }
  return onLocal([...local, ...image], origin, bases, flip);
}

/** The translational sweep S = C(u) + T(v) (thesis §3.2.2). */
export function swept(section: readonly Vector[], trajectory: readonly Vector[], bases: Bases, flip: boolean): Surface {
  const [first, second] = [localOrigin(section), localOrigin(trajectory)];
  const along = section.map((c) => seenFrom(c, first)), across = trajectory.map((t) => seenFrom(t, second));
  const sum = (a: readonly Vector[], b: readonly Vector[]) => a.map((c) => b.map((t) => c.map((x, i) => x + t[i]!)));
  const origin = first.map((value, x) => value + second[x]!);
  return onLocal(sum(along, across), origin, bases, flip, packed(sum(section, trajectory)));
}

/** S = (λ r x, λ r y, z) from a profile (r, z)(u) and a trajectory (x, y)(v) (thesis §3.2.3). */
export function swung(profile: readonly Vector[], trajectory: readonly Vector[], scale: number, bases: Bases, flip: boolean): Surface {
  return tensor(profile.map(([r, z]) => trajectory.map(([x, y]) => [scale * r! * x!, scale * r! * y!, z!])), bases, flip);
}

/** S = (1 - v) A(u) + v B(u), A with (α1, ζ1) and B with (α2, ζ2) (thesis §3.2.4). */
export function ruled(first: readonly Vector[], second: readonly Vector[], bases: Bases, flip: boolean): Surface {
  const zero = [0, 0, 0], [a, b] = bases as [Chosen, Chosen];
  const origin = a.partition && b.partition ? localOrigin([...first, ...second]) : zero;
  const points = packed([...first.map((p) => [seenFrom(p, origin), zero]), ...second.map((p) => [zero, seenFrom(p, origin)])]);
  const one = a.still(first.map((p) => [p])), two = b.still(second.map((p) => [p]));
  const still = [one[0] && two[0], one[1] && two[1]] as const; // both boundaries must
  const functions = new Joined([a.functions(still), b.functions(still)]);
  const net = first.length === second.length ? packed(first.map((p, i) => [p, second[i]!])) : null;
  return { rows: new Net(points, functions), blend: new Bernstein(1), flip, net, origin };
}

/** The mirror image of a point in the plane (a, b, c, d). */
export function reflected(point: Vector, plane: Vector): number[] {
  const [a, b, c, d] = plane as [number, number, number, number];
  const height = (point[0]! * a + point[1]! * b + point[2]! * c + d) / (a * a + b * b + c * c);
  return [point[0]! - 2 * height * a, point[1]! - 2 * height * b, point[2]! - 2 * height * c];
}
