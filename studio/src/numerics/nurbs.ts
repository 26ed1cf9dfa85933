/** NURBS surfaces, as CAD files hold them. */

import { BSpline } from "./bspline";
import { packed, type Vector } from "./construct";
import { localOrigin, seenFrom } from "./origin";
import { Net, type Surface } from "./surface";
import type { Loop } from "./trim";

/** S = ΣΣ w_ij P_ij N_i(u) N_j(v) / ΣΣ w_ij N_i(u) N_j(v) (Piegl and Tiller 1997, eq. 4.11). */
export function nurbs(
  points: readonly (readonly Vector[])[], weights: readonly Vector[] | null, degrees: Vector, knots: readonly Vector[], flip: boolean,
  trim: readonly Loop[] = [],
): Surface {
  const net = packed(points);
  const u = new BSpline(knots[0]!, degrees[0]!), v = new BSpline(knots[1]!, degrees[1]!);
  if (u.size !== net.n || v.size !== net.m) {
    throw new Error(`knots: expected ${net.n + degrees[0]! + 1} and ${net.m + degrees[1]! + 1}, found ${knots[0]!.length} and ${knots[1]!.length}`);
  }
  const origin = localOrigin(points.flat());
  const local = points.map((row) => row.map((point) => seenFrom(point, origin)));
  const first = weights?.[0]?.[0];
  if (!weights || weights.every((row) => row.every((w) => w === first))) return { rows: new Net(packed(local), u), blend: v, flip, net, origin, trim };
  const homogeneous = local.map((row, i) => row.map((p, j) => [...p.map((x) => x * weights[i]![j]!), weights[i]![j]!]));
  return { rows: new Net(packed(homogeneous), u), blend: v, flip, net, origin, trim };
}
