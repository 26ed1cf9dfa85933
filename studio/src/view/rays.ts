/** How far a point moves when the pointer's ray does: along a line or in a plane. */

import type { Ray } from "./stage";

type Vec = readonly number[];

/** Move with the pointer in a plane. */
export function inPlane(start: Vec, normal: Vec, from: Ray, to: Ray): number[] {
  const a = meet(start, normal, from), b = meet(start, normal, to);
  return start.map((x, i) => x + b[i]! - a[i]!);
}

/** Move along a line by as much as its nearest point to the pointer's ray moves. */
export function alongLine(start: Vec, direction: Vec, from: Ray, to: Ray): number[] {
  const length = Math.hypot(...direction), d = direction.map((x) => x / length);
  const nearest = (ray: Ray) => {
    const w = start.map((x, i) => x - ray.origin[i]!);
    const b = dot(d, ray.direction), denominator = 1 - b * b;
    return denominator > 1e-4 ? (b * dot(w, ray.direction) - dot(w, d)) / denominator : 0;
  };
  const step = nearest(to) - nearest(from);
  return start.map((x, i) => x + step * d[i]!);
}

/** The point of a ball about the origin under the pointer, on the side of `near`; on its rim where the pointer is beside it. */
export function onBall(radius: number, { origin, direction }: Ray, near: Vec): number[] {
  const b = dot(origin, direction), reach = b * b - dot(origin, origin) + radius * radius;
  const at = (t: number) => origin.map((x, i) => x + t * direction[i]!);
  if (reach <= 0) {
    const beside = at(-b), length = Math.hypot(...beside) || 1;
    return beside.map((x) => (radius * x) / length);
  }
  const [front, behind] = [at(-b - Math.sqrt(reach)), at(-b + Math.sqrt(reach))] as const;
  const away = (p: Vec) => Math.hypot(...p.map((x, i) => x - near[i]!));
  return away(front) <= away(behind) ? front : behind;
}

function meet(point: Vec, normal: Vec, ray: Ray): number[] {
  const away = dot(normal, point) - dot(normal, ray.origin), speed = dot(normal, ray.direction);
  const t = Math.abs(speed) > 1e-9 ? away / speed : 0;
  return ray.origin.map((x, i) => x + t * ray.direction[i]!);
}

const dot = (p: Vec, q: Vec): number => p[0]! * q[0]! + p[1]! * q[1]! + p[2]! * q[2]!;
