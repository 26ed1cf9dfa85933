/** What a reader of the picture must beware of, in words. */

import { regression } from "../numerics/envelope";
import { shapeOf, SHAPE_RANGE } from "../numerics/model";
import { extent, type Surface } from "../numerics/surface";
import { activePatch, type State } from "./state";

/** A sentence on the active patch; empty when there is nothing to say. */
export function warningOf(state: State, surface: Surface | null): string {
  const patch = activePatch(state);
  if (surface && extent(surface).size === 0) return "A single point: it has no size, no tangent plane and no curvature";
  if (shapeOf(patch).some((x) => x < SHAPE_RANGE[0] || x > SHAPE_RANGE[1])) return "Shape parameters outside [−4, 1]: the convex-hull property is lost";
  if ((patch["trim"] as unknown[] | undefined)?.length) return "A trimmed face: meshes and CAD files take the whole of its surface";
  if (patch.kind !== "developable" || state.moving || !surface) return "";
  const inside = regression(surface);
  if (!inside.length) return "";
  const spans = inside.map(({ u }) => `${u[0]!.toFixed(3)} to ${u.at(-1)!.toFixed(3)}`).join(", ");
  return `The edge of regression (magenta) lies inside the strip for u = ${spans}: the surface is singular there`;
}
