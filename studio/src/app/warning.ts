/** What a reader of the picture must beware of, in words. */

import { regression } from "../numerics/envelope";
import { choicesOf, moving } from "../numerics/chosen";
import { holds, rangeOf } from "../numerics/formulas";
import { shapeOf, shapeParameters } from "../numerics/model";
import { isCurve } from "../numerics/curve";
import { extent, type Surface } from "../numerics/surface";
import { activePatch, type State } from "./state";

/** A sentence on the active patch; empty when there is nothing to say. */
export function warningOf(state: State, surface: Surface | null): string {
  const patch = activePatch(state);
  if (surface && extent(surface).size === 0) return "A single point: it has no size, no tangent plane and no curvature";
  const values = shapeOf(patch), wrong = shapeParameters(patch).find((one, i) => !holds(one, values[i]!));
  const off = patch["unchecked_basis"] === true ? moving(choicesOf(patch))[0] : undefined;
  if (off) return `The functions of the basis ${off.name} do not sum to 1 (${off.offSum.told}): the ${isCurve(patch) ? "curve" : "surface"} moves with the origin`;
  if (wrong) return `Shape parameters outside ${rangeOf(wrong).replaceAll("-", "−")}: the convex-hull property is lost`;
  if ((patch["trim"] as unknown[] | undefined)?.length) return "A trimmed face: meshes and CAD files take the whole of its surface";
  if (patch.kind !== "developable" || state.moving || !surface) return "";
  const inside = regression(surface);
  if (!inside.length) return "";
  const spans = inside.map(({ u }) => `${u[0]!.toFixed(3)} to ${u.at(-1)!.toFixed(3)}`).join(", ");
  return `The edge of regression (magenta) lies inside the strip for u = ${spans}: the surface is singular there`;
}
