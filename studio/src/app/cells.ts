/** What stands side by side in the picture. */

import { analyse } from "../numerics/sample";
import { curveOf, isCurve, type Curve } from "../numerics/curve";
import { extent, type Surface } from "../numerics/surface";
import { coverage, windowOf } from "../numerics/trim";
import { build, shapeOf, type Model, type Patch } from "../numerics/model";
import { shapeSets, type State } from "./state";

export interface Shown {
  readonly label: string;
  readonly model: Model;
  /** Whether dragging a point here changes the model. */
  readonly editable: boolean;
}

const shaped = new WeakMap<Patch, Map<string, Patch>>();

/** The models of the cells, in their order. */
export function cellsOf(state: State): Shown[] {
  const { model, saved, compare, kept, patch } = state;
  const now = { label: "", model, editable: true };
  if (compare === "before") return [{ label: "before", model: saved, editable: false }, { ...now, label: "now" }];
  if (compare === "kept" && kept.length) return [{ ...now, label: "now" }, ...kept.map((one) => ({ ...one, editable: false }))];
  const sets = shapeSets(model.patches[patch]!);
  if (compare === "sets" && sets.length) {
    return sets.map((set) => ({ label: `(${set.join(", ").replaceAll("-", "−")})`, model: withShape(model, set), editable: true }));
  }
  return [now];
}

/** The cell, of so many, that shows the model itself. */
export const mainCell = ({ compare }: State, count: number): number => (compare === "before" ? Math.min(1, count - 1) : 0);

/** The model with a set of shape parameters; the same patch for the same patch, so that nothing is worked out twice. */
function withShape(model: Model, set: readonly number[]): Model {
  const change = (patch: Patch): Patch => {
    if (shapeSets(patch)[0]?.length !== set.length || String(shapeOf(patch)) === String(set)) return patch;
    const known = shaped.get(patch) ?? new Map<string, Patch>();
    shaped.set(patch, known);
    const made = known.get(String(set)) ?? { ...patch, shape: set };
    known.set(String(set), made);
    return made;
  };
  return { ...model, patches: model.patches.map(change) };
}

export interface Box {
  readonly low: number[];
  readonly high: number[];
}

const SIDE = 41;
const STEPS = Array.from({ length: SIDE }, (_, i) => i / (SIDE - 1));

/** The box of a surface, or of the bulk of it where a little of it runs far off, as in the report's figures. */
function bulk(surface: Surface): Box {
  const whole = extent(surface), at = [0, 1, 2] as const;
  if (!(whole.size > 0)) return { low: whole.low, high: whole.low };
  const [u0, v0, u1, v1] = windowOf(surface), us = STEPS.map((t) => u0 + t * (u1 - u0)), vs = STEPS.map((t) => v0 + t * (v1 - v0));
  const { point } = analyse(surface, us, vs, false, ["point"]), inside = coverage(surface, us, vs), none = !inside.includes(1);
  const sorted = at.map((x) => point!.filter((value, i) => i % 3 === x && Number.isFinite(value) && (none || inside[(i - x) / 3])).sort());
  const share = (x: 0 | 1 | 2, part: number) => sorted[x]![Math.round(part * (sorted[x]!.length - 1))]!;
  const low = at.map((x) => share(x, 0)), high = at.map((x) => share(x, 1)), first = at.map((x) => share(x, 0.1)), last = at.map((x) => share(x, 0.9));
  const length = (from: number[], to: number[]) => Math.hypot(...at.map((x) => to[x]! - from[x]!));
  if (length(low, high) <= 8 * length(first, last)) return { low, high };
  const rim = at.map((x) => 0.5 * (last[x]! - first[x]!));
  return { low: at.map((x) => Math.max(low[x]!, first[x]! - rim[x]!)), high: at.map((x) => Math.min(high[x]!, last[x]! + rim[x]!)) };
}

/** The box of a curve. */
function around(curve: Curve): Box {
  const points = curve.sample(SIDE).map(({ point }) => point), at = [0, 1, 2];
  return { low: at.map((x) => Math.min(...points.map((p) => p[x]!))), high: at.map((x) => Math.max(...points.map((p) => p[x]!))) };
}

/** The box around the surfaces of all cells; null where none can be built. */
export function boxOf(cells: readonly Shown[]): Box | null {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const patch of cells.flatMap(({ model }) => model.patches)) {
    try {
      const box = isCurve(patch) ? around(curveOf(patch)) : bulk(build(patch));
      for (let x = 0; x < 3; x++) {
        low[x] = Math.min(low[x]!, box.low[x]!);
        high[x] = Math.max(high[x]!, box.high[x]!);
      }
    } catch {
      // It is told when it is drawn.
    }
  }
  return low[0]! <= high[0]! ? { low, high } : null;
}
