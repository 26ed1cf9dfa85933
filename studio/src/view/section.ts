/** The section plane: turned freely about the middle of what is shown, and moved along its normal. */

import type { Settings } from "../app/settings";
import type { Frame } from "./frame";

type Vec = readonly [number, number, number];

const RADIANS = Math.PI / 180;
const ARM = 0.34; // scene distance from the grip that moves the plane to that which tilts it

/** Azimuth and tilt of the planes' normals along the axes, in degrees. */
export const ALONG: Readonly<Record<"x" | "y" | "z", readonly [number, number]>> = { x: [0, 0], y: [90, 0], z: [0, 90] };

/** Unit normal of the plane, from its azimuth about z and its tilt out of the xy plane; exact along the axes. */
export function sectionNormal({ sectionAzimuth, sectionTilt }: Settings): Vec {
  const [c, s] = turn(sectionTilt), [x, y] = turn(sectionAzimuth);
  return [c * x, c * y, s];
}

/** The plane in the scene, (a, b, c, d) of a x + b y + c z = d. */
export function sectionPlane(settings: Settings, frame: Frame): [number, number, number, number] {
  return [...sectionNormal(settings), settings.sectionAt * frame.scale];
}

/** The points to take hold of, in the scene: one moves the plane, the other tilts it. */
export function sectionGrips(settings: Settings, frame: Frame): { move: number[]; tilt: number[] } {
  const [a, b, c, d] = sectionPlane(settings, frame), at = (t: number) => [a * t, b * t, c * t];
  return { move: at(d), tilt: at(d + ARM) };
}

/** The settings after a grip was dragged to a point of the scene. */
export function dragged(grip: "move" | "tilt", to: readonly number[], settings: Settings, frame: Frame): Partial<Settings> {
  const [x, y, z] = to as unknown as Vec;
  if (grip === "move") {
    const [a, b, c] = sectionNormal(settings);
    return { sectionAt: Number(((a * x + b * y + c * z) / frame.scale).toPrecision(6)) };
  }
  // The plane keeps its distance from the middle; behind the middle the grip is on the other side of it.
  const side = settings.sectionAt * frame.scale + ARM < 0 ? -1 : 1, flat = Math.hypot(x, y);
  const azimuth = flat > 0.02 ? Math.round(Math.atan2(side * y, side * x) / RADIANS) : settings.sectionAzimuth;
  return { sectionAzimuth: azimuth, sectionTilt: Math.round(Math.atan2(side * z, flat) / RADIANS) };
}

/** The outline of the plane in the scene: its section with the box around what is shown, a little widened. */
export function sectionOutline(settings: Settings, frame: Frame): number[][] {
  const [a, b, c, d] = sectionPlane(settings, frame), half = frame.half.map((x) => 1.06 * x + 0.04) as unknown as Vec;
  const height = (p: readonly number[]) => a * p[0]! + b * p[1]! + c * p[2]! - d;
  const corners = Array.from({ length: 8 }, (_, i) => half.map((x, axis) => ((i >> axis) & 1 ? x : -x)));
  const points = corners.flatMap((from, i) => [1, 2, 4].filter((bit) => !(i & bit)).flatMap((bit) => {
    const to = corners[i | bit]!, h = height(from), k = height(to);
    if (h < 0 === k < 0) return [];
    return [from.map((x, axis) => x + (h / (h - k)) * (to[axis]! - x))];
  }));
  // The corners of a convex polygon, in the order of their angles about its middle.
  const middle = [0, 1, 2].map((axis) => points.reduce((sum, p) => sum + p[axis]!, 0) / points.length);
  const [x, y] = turn(settings.sectionAzimuth), across = [-y, x, 0], up = [-c * x, -c * y, a * x + b * y];
  const along = (p: readonly number[], q: readonly number[]) => p.reduce((sum, value, i) => sum + (value - middle[i]!) * q[i]!, 0);
  const angle = (p: readonly number[]) => Math.atan2(along(p, up), along(p, across));
  return points.sort((p, q) => angle(p) - angle(q));
}

/** Cosine and sine of degrees, exact at right angles. */
function turn(degrees: number): [number, number] {
  if (degrees % 90) return [Math.cos(degrees * RADIANS), Math.sin(degrees * RADIANS)];
  return ([[1, 0], [0, 1], [-1, 0], [0, -1]] as const)[((degrees / 90) % 4 + 4) % 4]! as unknown as [number, number];
}
