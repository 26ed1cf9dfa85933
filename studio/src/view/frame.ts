/** The frame of the picture: model coordinates are moved and scaled so that the scene fits a ball of radius 1. */

export interface Frame {
  readonly centre: readonly [number, number, number];
  /** Scene length per model length. */
  readonly scale: number;
}

export const UNIT_FRAME: Frame = { centre: [0, 0, 0], scale: 1 };

/** The frame of a box; a box without size is left as it is. */
export function frameOf(low: readonly number[], high: readonly number[]): Frame {
  const radius = 0.5 * Math.hypot(high[0]! - low[0]!, high[1]! - low[1]!, high[2]! - low[2]!);
  const middle = (x: number) => 0.5 * (low[x]! + high[x]!);
  return { centre: [middle(0), middle(1), middle(2)], scale: radius > 0 && Number.isFinite(radius) ? 1 / radius : 1 };
}

export const toScene = (frame: Frame, p: readonly number[]): [number, number, number] => [
  (p[0]! - frame.centre[0]) * frame.scale, (p[1]! - frame.centre[1]) * frame.scale, (p[2]! - frame.centre[2]) * frame.scale,
];

export const toModel = (frame: Frame, p: readonly number[]): [number, number, number] => [
  p[0]! / frame.scale + frame.centre[0], p[1]! / frame.scale + frame.centre[1], p[2]! / frame.scale + frame.centre[2],
];
