/** One construction as another, where that is the same surface. */

import { reflected } from "../numerics/construct";
import { isCurve } from "../numerics/curve";
import { valueOf, type Patch } from "../numerics/model";

type Vec = readonly number[];

/** The patch as this kind with the same surface, point by point; null where the kind cannot hold it. */
export function converted(patch: Patch, kind: string): Patch | null {
  if (kind === patch.kind) return patch;
  if (isCurve(patch) || !["trigonometric", "bernstein", undefined].includes(valueOf(patch, "basis") as string | undefined)) return null;
  const points = netOf(patch);
  if (!points) return null;
  const classical = patch.kind === "nurbs" || valueOf(patch, "basis") === "bernstein";
  const { name } = patch, flip = given(patch, "flip");
  if (kind === "tensor") {
    return { kind, name, points, ...given(patch, "shape"), ...given(patch, "unchecked_shape"), ...(classical ? { basis: "bernstein" } : {}), ...flip };
  }
  if (kind !== "nurbs" || !classical) return null;
  const degrees = [points.length - 1, points[0]!.length - 1];
  return { kind, name, degrees, knots: degrees.map(clamped), points, ...flip };
}

/** The net of the tensor-product surface that the patch is; null where it is none. */
function netOf(patch: Patch): Vec[][] | null {
  const list = <T>(key: string) => valueOf(patch, key) as T[];
  switch (patch.kind) {
    case "tensor": return list<Vec[]>("points");
    case "symmetric": {
      const rows = list<Vec[]>("points"), mirror = valueOf(patch, "mirror") as Vec;
      return [...rows, ...rows.map((row) => row.map((point) => reflected(point, mirror))).reverse()];
    }
    case "swept": return list<Vec>("section").map((c) => list<Vec>("trajectory").map((t) => c.map((x, i) => x + t[i]!)));
    case "swung": {
      const scale = valueOf(patch, "scale") as number;
      return list<Vec>("profile").map(([r, z]) => list<Vec>("trajectory").map(([x, y]) => [scale * r! * x!, scale * r! * y!, z!]));
    }
    case "ruled": {
      // The trigonometric basis does not hold the straight lines; Bernstein's of degree one is theirs.
      const first = list<Vec>("first"), second = list<Vec>("second");
      return valueOf(patch, "basis") === "bernstein" && first.length === second.length ? first.map((p, i) => [p, second[i]!]) : null;
    }
    case "nurbs": return bezier(patch) ? list<Vec[]>("points") : null;
    default: return null;
  }
}

/** Whether NURBS keys are those of one untrimmed Bézier patch over the unit square with equal weights. */
function bezier(patch: Patch): boolean {
  const weights = (valueOf(patch, "weights") as Vec[] | undefined)?.flat() ?? [], degrees = valueOf(patch, "degrees") as Vec;
  const knots = valueOf(patch, "knots") as Vec[], trim = valueOf(patch, "trim") as unknown[] | undefined;
  return weights.every((w) => w === weights[0]) && !trim?.length && degrees.every((degree) => degree <= 63)
    && degrees.every((degree, i) => String(knots[i]) === String(clamped(degree)));
}

const clamped = (degree: number): number[] => [...Array<number>(degree + 1).fill(0), ...Array<number>(degree + 1).fill(1)];
const given = (patch: Patch, key: string): Record<string, unknown> => (patch[key] === undefined ? {} : { [key]: patch[key] });
