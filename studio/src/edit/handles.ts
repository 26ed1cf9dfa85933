/** What can be dragged of a patch: control points, or planes along their normals; and the patch after a move. */

import { reflected } from "../numerics/construct";
import type { Patch } from "../numerics/model";
import { isCurve } from "../numerics/curve";
import { build, KINDS, valueOf } from "../numerics/model";
import { analyse } from "../numerics/sample";
import type { Surface } from "../numerics/surface";
import { planeOf } from "./way";

type Vec = readonly number[];

/** A point that can be taken hold of. `along` allows one direction only; else `free` says which axes may change. */
export interface Handle {
  readonly id: string;
  readonly key: string;
  readonly index: readonly number[];
  readonly label: string;
  readonly position: Vec;
  readonly free: readonly [boolean, boolean, boolean];
  readonly along?: Vec;
  /** Unit normal of the plane that its curve lies in. */
  readonly plane?: Vec;
  readonly mirrored?: boolean;
  readonly tint: readonly [number, number, number];
}

const BLUE = [0.11, 0.36, 0.66] as const, TEAL = [0.0, 0.47, 0.42] as const;
const ALL = [true, true, true] as const;
const LARGEST_NET = 400;

const known = new WeakMap<Patch, Handle[]>();

/** Every handle of a patch; none of a patch that cannot be built, as between two valid states. */
export function handlesOf(patch: Patch): readonly Handle[] {
  let found = known.get(patch);
  if (!found) {
    try {
      found = isCurve(patch) ? curveHandles(patch) : handles(patch, build(patch));
    } catch {
      found = [];
    }
    known.set(patch, found);
  }
  return found;
}

/** The control points of a curve; those of a plane one stay in its plane. */
function curveHandles(patch: Patch): Handle[] {
  const points = valueOf(patch, "points") as Vec[], flat = points[0]!.length === 2;
  return polygon("points", points.map((p) => [p[0]!, p[1]!, p[2] ?? 0]), flat ? [true, true, false] : ALL, BLUE).map((one, i) => ({ ...one, label: `point ${i}` }));
}

/** Every handle of a patch; its surface says where the handles of planes sit. */
export function handles(patch: Patch, surface: Surface): Handle[] {
  const list = <T>(key: string) => (valueOf(patch, key) ?? []) as T[];
  switch (patch.kind) {
    case "tensor":
    case "nurbs": return net(list<Vec[]>("points"));
    case "symmetric": {
      const rows = list<Vec[]>("points"), mirror = valueOf(patch, "mirror") as Vec;
      const image = net(rows).map((h) => ({
        ...h, id: `${h.id}′`, label: `${h.label}′`, position: reflected(h.position, mirror), mirrored: true,
      }));
      return [...net(rows), ...image];
    }
    case "swept": return [...polygon("section", list<Vec>("section"), ALL, BLUE), ...polygon("trajectory", list<Vec>("trajectory"), ALL, TEAL)];
    case "ruled": return [...polygon("first", list<Vec>("first"), ALL, BLUE), ...polygon("second", list<Vec>("second"), ALL, TEAL)];
    case "swung": return [
      ...polygon("profile", list<Vec>("profile").map(([r, z]) => [r!, 0, z!]), [true, false, true], BLUE),
      ...polygon("trajectory", list<Vec>("trajectory").map(([x, y]) => [x!, y!, 0]), [true, true, false], TEAL),
    ];
    case "developable": return [
      ...planes("planes", list<Vec>("planes"), surface, (i) => [i / 5, 0.5], BLUE),
      ...planes("bounds", list<Vec>("bounds"), surface, (i) => [0.5, i], TEAL),
    ];
    default: return nets(patch).flatMap(([key, depth], i) => (depth === 2 ? net(list<Vec[]>(key), key) : polygon(key, list<Vec>(key), ALL, i ? TEAL : BLUE)));
  }
}

/** The keys of a kind that hold points in space, with how deep: 1 for the points of a curve, 2 for a net's. */
const nets = (patch: Patch): [string, number][] =>
  Object.entries(KINDS[patch.kind]?.fields ?? {}).flatMap(([key, field]) => (field.type === "points" && field.dimension === 3 ? [[key, field.counts!.length]] : []));

/** The patch after a handle was moved to a point (as near as the handle allows). */
export function moved(patch: Patch, handle: Handle, to: Vec): Patch {
  if (handle.along) {
    const plane = (valueOf(patch, handle.key) as Vec[])[handle.index[0]!]!;
    const d = -(plane[0]! * to[0]! + plane[1]! * to[1]! + plane[2]! * to[2]!);
    return replaced(patch, handle.key, handle.index, [plane[0]!, plane[1]!, plane[2]!, tidy(d)]);
  }
  let target = handle.position.map((x, i) => (handle.free[i] ? to[i]! : x));
  if (handle.mirrored) target = reflected(target, valueOf(patch, "mirror") as Vec);
  if (isCurve(patch)) return replaced(patch, handle.key, handle.index, target.slice(0, handle.free[2] ? 3 : 2).map(tidy));
  const point = patch.kind !== "swung" ? target : handle.key === "profile" ? [target[0]!, target[2]!] : [target[0]!, target[1]!];
  return replaced(patch, handle.key, handle.index, point.map(tidy));
}

/** The patch with one point of a net replaced. */
export function replaced(patch: Patch, key: string, index: readonly number[], point: Vec): Patch {
  const set = (value: unknown, path: readonly number[]): unknown => {
    if (!path.length) return point;
    return (value as unknown[]).map((item, i) => (i === path[0] ? set(item, path.slice(1)) : item));
  };
  return { ...patch, [key]: set(valueOf(patch, key), index) };
}

/** The control polygon of a curve, to its end. */
export function polygonOf(patch: Patch): Vec[][] {
  const points = (valueOf(patch, "points") as Vec[]).map((p) => [p[0]!, p[1]!, p[2] ?? 0]);
  return [valueOf(patch, "close") === true ? [...points, points[0]!] : points];
}

/** The polylines of the control net. */
export function polylines(patch: Patch, surface: Surface): Vec[][] {
  const list = (key: string) => valueOf(patch, key) as Vec[];
  switch (patch.kind) {
    case "swept": return [list("section").slice(), list("trajectory").slice()];
    case "swung": return [list("profile").map(([r, z]) => [r!, 0, z!]), list("trajectory").map(([x, y]) => [x!, y!, 0])];
    case "ruled": return [list("first").slice(), list("second").slice()];
  }
  const points = surface.net;
  if (!points || points.n * points.m > LARGEST_NET) return [];
  const at = (i: number, j: number) => Array.from(points.values.subarray(3 * (i * points.m + j), 3 * (i * points.m + j) + 3));
  const range = (count: number) => Array.from({ length: count }, (_, i) => i);
  return [...range(points.n).map((i) => range(points.m).map((j) => at(i, j))), ...range(points.m).map((j) => range(points.n).map((i) => at(i, j)))];
}

/** Drop the digits that dragging invents: twelve significant ones are kept. */
const tidy = (x: number): number => Number(x.toPrecision(12)) + 0;

/** An index in subscript digits. */
const lowered = (index: number): string => String(index).replace(/\d/g, (c) => "₀₁₂₃₄₅₆₇₈₉"[Number(c)]!);

function net(rows: readonly (readonly Vec[])[], key = "points"): Handle[] {
  if (rows.length * (rows[0]?.length ?? 0) > LARGEST_NET) return [];
  return rows.flatMap((row, i) => row.map((position, j) => ({
    id: `${key}[${i}][${j}]`, key, index: [i, j], label: `P${lowered(i)}${i > 9 || j > 9 ? "," : ""}${lowered(j)}`, position, free: ALL, tint: BLUE,
  })));
}

function polygon(key: string, points: readonly Vec[], free: Handle["free"], tint: Handle["tint"]): Handle[] {
  const plane = planeOf(points);
  return points.map((position, i) => ({ id: `${key}[${i}]`, key, index: [i], label: `${key} ${i}`, position, free, tint, ...(plane && { plane }) }));
}

function planes(key: string, rows: readonly Vec[], surface: Surface, where: (i: number) => [number, number], tint: Handle["tint"]): Handle[] {
  return rows.map((plane, i) => {
    const [u, v] = where(i);
    const point = Array.from(analyse(surface, [u], [v], true, ["point"])["point"]!);
    const [a, b, c, d] = plane as [number, number, number, number];
    const height = (point[0]! * a + point[1]! * b + point[2]! * c + d) / (a * a + b * b + c * c);
    const position = [point[0]! - height * a, point[1]! - height * b, point[2]! - height * c];
    return { id: `${key}[${i}]`, key, index: [i], label: `${key === "planes" ? "plane" : "bound"} ${i}`, position, free: ALL, along: [a, b, c], tint };
  });
}
