/** A picture without WebGL: the surface's cells painted from back to front on a plain canvas. */

import { QUANTITY } from "../numerics/quantity";
import { BACK, classColours, css, mapColours, UNDEFINED, type Rgb } from "../ui/colours";
import type { Orbit } from "./camera";
import type { Overlays } from "./overlays";
import type { Range } from "./range";
import type { Cell } from "./cell";

const SIDE = 64;

/** Paint every cell; slower and coarser than WebGL, but the same colours. */
export function paintStill(canvas: HTMLCanvasElement, cells: readonly Cell[], orbit: Orbit, ratio: number, quantity: string, range: Range | null): void {
  const context = canvas.getContext("2d")!;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, canvas.width, canvas.height);
  const q = QUANTITY[quantity];
  const colours = !q ? [] : q.colour === "classes" ? classColours(quantity) : mapColours(q);
  const colourOf = (value: number): Rgb => {
    if (!q) return BACK;
    if (value - value !== 0) return UNDEFINED;
    if (q.colour === "classes" || !range) return colours[value] ?? UNDEFINED;
    return colours[Math.round(255 * Math.min(1, Math.max(0, (value - range.low) / (range.high - range.low))))]!;
  };
  const { right, up, towards } = orbit.axes();
  for (const cell of cells) {
    const half = orbit.span / Math.min(1, cell.width / cell.height), scale = cell.height / (2 * half);
    const faces: { depth: number; corners: number[]; colour: Rgb; lit: number }[] = [];
    for (const { mesh } of cell.pieces) {
      const n = mesh.side, x = mesh.position, step = Math.max(1, Math.ceil((n - 1) / SIDE));
      const flat = (p: number) => {
        const d = [x[3 * p]! - orbit.target.x, x[3 * p + 1]! - orbit.target.y, x[3 * p + 2]! - orbit.target.z] as const;
        const along = (a: { x: number; y: number; z: number }) => d[0] * a.x + d[1] * a.y + d[2] * a.z;
        return [cell.x + cell.width / 2 + scale * along(right), cell.y + cell.height / 2 - scale * along(up), along(towards)] as const;
      };
      const steps = Array.from({ length: Math.ceil((n - 1) / step) }, (_, i) => i * step);
      for (const i of steps) {
        for (const k of steps) {
          const i2 = Math.min(n - 1, i + step), k2 = Math.min(n - 1, k + step);
          const [a, b, c, d] = [flat(i * n + k), flat(i2 * n + k), flat(i2 * n + k2), flat(i * n + k2)] as const;
          const middle = ((i + i2) >> 1) * n + ((k + k2) >> 1);
          if (!mesh.covered[middle]) continue;
          const normal = mesh.grid.planes, stride = mesh.grid.stride;
          const lit = Math.abs(normal[3 * stride + middle]! * towards.x + normal[4 * stride + middle]! * towards.y + normal[5 * stride + middle]! * towards.z);
          faces.push({ depth: a[2] + b[2] + c[2] + d[2], corners: [a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1]], colour: colourOf(mesh.values[middle] ?? NaN), lit: lit || 0.5 });
        }
      }
    }
    context.save();
    context.beginPath();
    context.rect(cell.x, cell.y, cell.width, cell.height);
    context.clip();
    for (const face of faces.sort((one, other) => one.depth - other.depth)) {
      const shade = 0.68 + 0.32 * face.lit;
      context.fillStyle = context.strokeStyle = css(face.colour.map((c) => Math.round(c * shade)) as unknown as Rgb);
      context.beginPath();
      context.moveTo(face.corners[0]!, face.corners[1]!);
      for (let at = 2; at < 8; at += 2) context.lineTo(face.corners[at]!, face.corners[at + 1]!);
      context.closePath();
      context.fill();
      context.stroke();
    }
    for (const { overlays } of cell.pieces) paintOver(context, overlays, (x, y, z) => {
      const d = [x - orbit.target.x, y - orbit.target.y, z - orbit.target.z] as const;
      const along = (a: { x: number; y: number; z: number }) => d[0] * a.x + d[1] * a.y + d[2] * a.z;
      return [cell.x + cell.width / 2 + scale * along(right), cell.y + cell.height / 2 - scale * along(up)];
    });
    context.restore();
  }
}

/** Lines and points over a surface; nothing hides them. */
function paintOver(context: CanvasRenderingContext2D, overlays: Overlays, flat: (x: number, y: number, z: number) => readonly [number, number]): void {
  const { lines, points } = overlays.drawn;
  for (const { ends, colour, width, opacity } of lines) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.globalAlpha = opacity;
    context.beginPath();
    for (let at = 0; at < ends.length; at += 6) {
      context.moveTo(...flat(ends[at]!, ends[at + 1]!, ends[at + 2]!));
      context.lineTo(...flat(ends[at + 3]!, ends[at + 4]!, ends[at + 5]!));
    }
    context.stroke();
  }
  context.globalAlpha = 1;
  context.lineWidth = 1.5;
  context.strokeStyle = "#ffffff";
  for (const { places, tints } of points) {
    for (let i = 0; 3 * i < places.length; i++) {
      context.fillStyle = css([0, 1, 2].map((c) => Math.round(255 * tints[4 * i + c]!)) as unknown as Rgb);
      context.beginPath();
      context.arc(...flat(places[3 * i]!, places[3 * i + 1]!, places[3 * i + 2]!), tints[4 * i + 3]! > 1.5 ? 6 : 4, 0, 7);
      context.fill();
      context.stroke();
    }
  }
}
