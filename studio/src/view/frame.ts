/** The frame of the picture: model coordinates are moved and scaled so that the scene fits a ball of radius 1. */

export interface Frame {
  readonly centre: readonly [number, number, number];
  /** Scene length per model length. */
  readonly scale: number;
  /** Half the sides of the box around what is shown, in the scene. */
  readonly half: readonly [number, number, number];
}

export const UNIT_FRAME: Frame = { centre: [0, 0, 0], scale: 1, half: [1, 1, 1] };

/** The frame of a box; a box without size is left as it is. */
export function frameOf(low: readonly number[], high: readonly number[]): Frame {
  const radius = 0.5 * Math.hypot(high[0]! - low[0]!, high[1]! - low[1]!, high[2]! - low[2]!);
  const scale = radius > 0 && Number.isFinite(radius) ? 1 / radius : 1;
  const middle = (x: number) => 0.5 * (low[x]! + high[x]!), half = (x: number) => 0.5 * scale * (high[x]! - low[x]!);
  return { centre: [middle(0), middle(1), middle(2)], scale, half: [half(0), half(1), half(2)] };
}

export const toScene = (frame: Frame, p: readonly number[]): [number, number, number] => [
  (p[0]! - frame.centre[0]) * frame.scale, (p[1]! - frame.centre[1]) * frame.scale, (p[2]! - frame.centre[2]) * frame.scale,
];

export const toModel = (frame: Frame, p: readonly number[]): [number, number, number] => [
  p[0]! / frame.scale + frame.centre[0], p[1]! / frame.scale + frame.centre[1], p[2]! / frame.scale + frame.centre[2],
];
