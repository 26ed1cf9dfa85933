/** The points of a target beside the model, in the colours of their distance: blue below, red on the side of the normal. */

import type { Beside } from "../app/aims";
import { toScene, type Frame } from "./frame";
import type { Points } from "./lines";

const STOPS = [[5, 48, 97], [67, 147, 195], [214, 214, 214], [214, 96, 77], [103, 0, 31]] as const;

/** The colours from the lowest to the highest distance, for the key. */
export const distanceColours: readonly string[] = STOPS.map((stop) => `rgb(${stop.join(" ")})`);

/** Draw a target's points, none where there is no target. */
export function drawTarget(points: Points, beside: Beside | null, frame: Frame): void {
  const places: number[][] = [], tints: number[][] = [];
  const count = beside?.distances.length ?? 0, reach = beside?.reach || 1;
  for (let k = 0; k < count; k++) {
    const at = beside!.places.subarray(3 * k, 3 * k + 3), share = Math.min(1, Math.max(-1, beside!.distances[k]! / reach));
    places.push(toScene(frame, [at[0]!, at[1]!, at[2]!]));
    tints.push(tint(share));
  }
  points.fill(places, tints);
}

function tint(share: number): number[] {
  const x = (share + 1) * 0.5 * (STOPS.length - 1), k = Math.min(Math.floor(x), STOPS.length - 2);
  return [...[0, 1, 2].map((c) => (STOPS[k]![c]! + (x - k) * (STOPS[k + 1]![c]! - STOPS[k]![c]!)) / 255), 1];
}
