/** Arms along the axes and squares in their planes, at a point taken hold of: what is grabbed says where it may go. */

import type { Stage } from "./stage";

type Vec = readonly number[];
type Spot = readonly [number, number];

const ARM = 58, INNER = 18, SQUARE = [0.38, 0.62] as const; // pixels, and shares of the arm
const HIT = 2; // pixels from the middle of an arm
const SHORTEST = 16, SMALLEST = 50; // pixels along and square: less is seen end-on or edge-on, and cannot be aimed at

export interface Part {
  /** The axes that it moves along: one, or two. */
  readonly axes: readonly number[];
  /** A line or a quadrilateral in the canvas, CSS pixels. */
  readonly outline: readonly Spot[];
}

/** Scene length of a pixel at a point of the scene. */
export function pixelAt(stage: Stage, cell: number, at: Vec): number {
  const { x, y } = stage.project(cell, at), here = stage.ray(cell, x, y), beside = stage.ray(cell, x + 1, y);
  const away = Math.hypot(...at.map((value, i) => value - here.origin[i]!));
  return Math.hypot(...at.map((_, i) => here.origin[i]! + away * here.direction[i]! - beside.origin[i]! - away * beside.direction[i]!));
}

/** The parts at a point of the scene that may move along the free axes. */
export function gizmo(stage: Stage, cell: number, at: Vec, free: readonly boolean[]): Part[] {
  const length = ARM * pixelAt(stage, cell, at);
  const spot = (shares: Vec): Spot => {
    const { x, y } = stage.project(cell, at.map((value, i) => value + length * shares[i]!));
    return [x, y];
  };
  const along = (axis: number, share: number) => [0, 1, 2].map((i) => (i === axis ? share : 0));
  const axes = [0, 1, 2].filter((axis) => free[axis]);
  const arms = axes.map((axis) => ({ axes: [axis], outline: [spot(along(axis, INNER / ARM)), spot(along(axis, 1))] }));
  const squares = [[1, 2], [2, 0], [0, 1]].filter((pair) => pair.every((axis) => free[axis])).map(([a, b]) => ({
    axes: [a!, b!], outline: ([[0, 0], [1, 0], [1, 1], [0, 1]] as const).map(([p, q]) => spot([0, 1, 2].map((i) => (i === a ? SQUARE[p] : i === b ? SQUARE[q] : 0)))),
  }));
  return [
    ...squares.filter(({ outline }) => Math.abs(area(outline)) > SMALLEST),
    ...arms.filter(({ outline: [p, q] }) => Math.hypot(q![0] - p![0], q![1] - p![1]) > SHORTEST),
  ];
}

/** The part under a point of the canvas: an arm that is hit, a square, or an arm that is nearly hit. */
export function partAt(parts: readonly Part[], x: number, y: number, near: number): Part | null {
  const armWithin = (reach: number) => parts.findLast(({ outline: [p, q, ...rest] }) => !rest.length && beside(p!, q!, x, y) < reach);
  return armWithin(HIT) ?? parts.findLast(({ outline }) => outline.length > 2 && inside(outline, x, y)) ?? armWithin(near) ?? null;
}

const area = (outline: readonly Spot[]): number =>
  0.5 * outline.reduce((sum, [x, y], i) => sum + x * outline[(i + 1) % outline.length]![1] - y * outline[(i + 1) % outline.length]![0], 0);

function beside([ax, ay]: Spot, [bx, by]: Spot, x: number, y: number): number {
  const dx = bx - ax, dy = by - ay, t = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)));
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
}

/** Whether a convex quadrilateral holds a point. */
function inside(outline: readonly Spot[], x: number, y: number): boolean {
  const sides = outline.map(([ax, ay], i) => {
    const [bx, by] = outline[(i + 1) % outline.length]!;
    return Math.sign((bx - ax) * (y - ay) - (by - ay) * (x - ax));
  });
  return sides.every((side) => side >= 0) || sides.every((side) => side <= 0);
}
