/** The way that a dragged point may go, and the round place on it that the pointer means. */

import { alongLine, inPlane } from "../view/rays";
import type { Ray } from "../view/stage";

type Vec = readonly number[];

/** Along a line, in a plane given by its normal, or nowhere. */
export type Way = { readonly line: Vec } | { readonly normal: Vec } | null;

const EDGE_ON = 0.1; // sine of the angle below which a plane is seen edge-on: then only what is seen of it moves
const AXES = [[1, 0, 0], [0, 1, 0], [0, 0, 1]] as const;

/**
 * The way of a point with these free axes. Where all are free it stays in the plane of its curve, if that is given, and
 * else in the plane of two axes that faces the eye most.
 */
export function wayOf(free: readonly boolean[], plane: Vec | undefined, towards: Vec): Way {
  const axes = [0, 1, 2].filter((axis) => free[axis]);
  if (axes.length === 0) return null;
  if (axes.length === 1) return { line: AXES[axes[0]!]! };
  const facing = towards.map(Math.abs), most = facing.indexOf(Math.max(...facing));
  const normal = axes.length === 2 ? AXES[free.indexOf(false)]! : (plane ?? AXES[most]!);
  if (Math.abs(dot(normal, towards)) > EDGE_ON) return { normal };
  const seen = cross(normal, towards), length = Math.hypot(...seen);
  return { line: seen.map((x) => (Math.abs(x) < 1e-9 * length ? 0 : x / length)) };
}

/** Where a point of the scene goes when the pointer's ray moves. */
export function follow(way: Way, start: Vec, from: Ray, to: Ray): Vec {
  return way === null ? start : "line" in way ? alongLine(start, way.line, from, to) : inPlane(start, way.normal, from, to);
}

/** The place on the way whose moving coordinates are multiples of a step; those that the way leaves alone stay exactly. */
export function onGrid(way: Way, start: Vec, to: Vec, step: number, all = false): number[] {
  const round = (x: number) => Math.round(x / step) * step;
  if (way === null) return [...start];
  if ("line" in way) {
    const parts = way.line.map(Math.abs), most = parts.indexOf(Math.max(...parts)), d = way.line;
    const t = (round(to[most]!) - start[most]!) / d[most]!;
    return start.map((x, i) => (i === most ? round(to[i]!) : d[i] ? x + t * d[i]! : x));
  }
  const n = way.normal, parts = n.map(Math.abs), most = parts.indexOf(Math.max(...parts));
  // The coordinate most across the plane follows from the others, so that the point stays in it.
  const rest = [0, 1, 2].filter((i) => i !== most), point = [...start];
  for (const i of rest) point[i] = round(to[i]!);
  const rise = rest.reduce((sum, i) => sum + n[i]! * (point[i]! - start[i]!), 0);
  if (rise !== 0) point[most] = all ? round(start[most]! - rise / n[most]!) : start[most]! - rise / n[most]!;
  return point;
}

/** The unit normal of the plane that holds all points; undefined where they are in a line or in no plane. */
export function planeOf(points: readonly Vec[]): Vec | undefined {
  const [first, ...others] = points, away = others.map((p) => p.map((x, i) => x - first![i]!));
  const size = Math.max(0, ...away.map((d) => Math.hypot(...d)));
  const longest = away.find((d) => Math.hypot(...d) === size);
  if (!longest || !(size > 0)) return undefined;
  const normals = away.map((d) => cross(longest, d)), tall = Math.max(...normals.map((d) => Math.hypot(...d)));
  const normal = normals.find((d) => Math.hypot(...d) === tall)!.map((x) => x / tall);
  if (!(tall > 1e-9 * size * size) || away.some((d) => Math.abs(dot(d, normal)) > 1e-9 * size)) return undefined;
  return normal.map((x) => (Math.abs(x) < 1e-12 ? 0 : x));
}

const dot = (p: Vec, q: Vec): number => p[0]! * q[0]! + p[1]! * q[1]! + p[2]! * q[2]!;
const cross = (p: Vec, q: Vec): number[] => [p[1]! * q[2]! - p[2]! * q[1]!, p[2]! * q[0]! - p[0]! * q[2]!, p[0]! * q[1]! - p[1]! * q[0]!];
