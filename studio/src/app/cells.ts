/** What stands side by side in the picture. */

import { extent } from "../numerics/surface";
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
  const count = shapeOf(model.patches[patch]!).length, sets = shapeSets(count);
  if (compare === "sets" && sets.length) {
    return sets.map((set) => ({ label: `(${set.join(", ").replaceAll("-", "−")})`, model: withShape(model, set), editable: true }));
  }
  return [now];
}

/** The model with a set of shape parameters; the same patch for the same patch, so that nothing is worked out twice. */
function withShape(model: Model, set: readonly number[]): Model {
  const change = (patch: Patch): Patch => {
    if (shapeOf(patch).length !== set.length || String(shapeOf(patch)) === String(set)) return patch;
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

/** The box around the surfaces of all cells; null where none can be built. */
export function boxOf(cells: readonly Shown[]): Box | null {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const patch of cells.flatMap(({ model }) => model.patches)) {
    try {
      const box = extent(build(patch));
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
