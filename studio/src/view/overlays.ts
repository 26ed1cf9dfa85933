/** Everything drawn on top of a surface: net, directions, normals, combs, contours, section, control points. */

import { Group } from "three";
import { THRESHOLDS } from "../numerics/classify";
import { directionCos, directionSin, principalDirection } from "../numerics/curvature";
import { PLANE } from "../numerics/kernel";
import type { Settings } from "../app/settings";
import { ORDERS, type Order, type Seam } from "../numerics/seams";
import type { CurvePoint } from "../numerics/curve";
import type { Handle } from "../edit/handles";
import { zeroContour } from "./contour";
import { toScene, UNIT_FRAME, type Frame } from "./frame";
import { Lines, Points } from "./lines";
import type { SurfaceMesh } from "./mesh";
import { sectionGrips, sectionOutline, sectionPlane } from "./section";

type Line = "curve" | "net" | "first" | "second" | "normals" | "teethU" | "teethV" | "combU" | "combV" | "zeroK" | "zeroH" | "section" | "plane" | "arm" | "edge" | `seam ${Order}`;

interface Style {
  readonly width: number;
  readonly light: string;
  readonly dark: string;
  readonly opacity: number;
  /** Seen through the surface. */
  readonly onTop?: boolean;
  /** Share of the opacity where a surface hides it. */
  readonly hidden?: number;
}

const STYLE: Readonly<Record<Line, Style>> = {
  curve: { width: 2.75, light: "#101418", dark: "#ffffff", opacity: 1 },
  net: { width: 1.25, light: "#44566c", dark: "#c3d0e0", opacity: 0.75, hidden: 0.35 },
  first: { width: 1.75, light: "#101418", dark: "#ffffff", opacity: 0.95 },
  second: { width: 1.25, light: "#7a4b00", dark: "#ffd28a", opacity: 0.95 },
  normals: { width: 1.5, light: "#00785a", dark: "#58dcae", opacity: 0.95 },
  teethU: { width: 1, light: "#0060a8", dark: "#7cc4ff", opacity: 0.55 },
  teethV: { width: 1, light: "#b04500", dark: "#ffae70", opacity: 0.55 },
  combU: { width: 1.75, light: "#0060a8", dark: "#7cc4ff", opacity: 1 },
  combV: { width: 1.75, light: "#b04500", dark: "#ffae70", opacity: 1 },
  zeroK: { width: 2.75, light: "#101418", dark: "#ffffff", opacity: 1 },
  zeroH: { width: 2.75, light: "#a3008f", dark: "#ff9cf2", opacity: 1 },
  edge: { width: 2.5, light: "#c4007a", dark: "#ff7ac8", opacity: 1 },
  plane: { width: 1.25, light: "#c2102e", dark: "#ff6b81", opacity: 0.55 },
  arm: { width: 1.75, light: "#c2102e", dark: "#ff6b81", opacity: 0.8, onTop: true },
  "seam open": { width: 4, light: "#c2102e", dark: "#ff6b81", opacity: 1, hidden: 0.2 },
  "seam G0": { width: 3, light: "#b85c00", dark: "#ffb057", opacity: 1, hidden: 0.2 },
  "seam G1": { width: 3, light: "#8a7a00", dark: "#f2e05c", opacity: 1, hidden: 0.2 },
  "seam G2": { width: 3, light: "#00785a", dark: "#58dcae", opacity: 1, hidden: 0.2 },
  "seam G3": { width: 3, light: "#0060a8", dark: "#7cc4ff", opacity: 1, hidden: 0.2 },
  section: { width: 3, light: "#c2102e", dark: "#ff6b81", opacity: 1 },
};

const LINES = Object.keys(STYLE) as Line[];
const FROM_SURFACE = LINES.filter((name) => name !== "net" && name !== "edge" && name !== "curve" && !name.startsWith("seam"));

/** The colours of overlay lines in a theme, for the key beside their switches. */
export const lineColour = (line: Line, dark: boolean): string => STYLE[line][dark ? "dark" : "light"];

const GRIP = [0.76, 0.06, 0.18, 1];
const RELATIVE = THRESHOLDS.relative; // of the curvedness: below it K and H count as zero, as in the classifications

export class Overlays {
  readonly group = new Group();
  readonly points = new Points();
  /** The points of a target beside the model. */
  readonly target = new Points(false, 4.5);
  /** What the section plane is moved and tilted by. */
  private readonly grips = new Points(true);
  /** Points of the drawn curve, and the tips of its comb, in the scene. */
  curvePoints: (readonly number[])[] = [];
  /** Points of the drawn control net in the scene. */
  netPoints: (readonly number[])[] = [];
  private readonly lines = Object.fromEntries(
    (LINES).map((name) => [name, new Lines(STYLE[name].light, STYLE[name].width, STYLE[name].opacity, STYLE[name].onTop, STYLE[name].hidden)]),
  ) as Record<Line, Lines>;

  constructor() {
    for (const name of LINES) this.group.add(this.lines[name].mesh);
    this.group.add(this.target.mesh, this.points.mesh, this.grips.mesh);
    this.target.fill([], []);
    this.grips.fill([], []);
    this.lines.curve.end(); // most pieces have none
    this.seams([], UNIT_FRAME);
  }

  /** All lines and points, for a picture without WebGL. */
  get drawn() {
    return { lines: LINES.map((name) => this.lines[name].drawn), points: [this.target.drawn, this.points.drawn, this.grips.drawn] };
  }

  resize(width: number, height: number, ratio: number): void {
    for (const name of LINES) this.lines[name].resize(width, height, ratio, STYLE[name].width);
    this.target.resize(ratio);
    this.points.resize(ratio);
    this.grips.resize(ratio);
  }

  theme(dark: boolean): void {
    for (const name of LINES) this.lines[name].colour = lineColour(name, dark);
  }

  /** Redraw what follows from the surface's numbers. */
  update(mesh: SurfaceMesh, settings: Settings, frame: Frame, tooth: number): void {
    const n = mesh.side;
    for (const name of FROM_SURFACE) this.lines[name].begin();
    if (n > 1) {
      if (settings.directions) this.directions(mesh);
      if (settings.normals) this.normals(mesh);
      if (settings.combs === "u" || settings.combs === "both") this.combs(mesh, true, tooth);
      if (settings.combs === "v" || settings.combs === "both") this.combs(mesh, false, tooth);
      const { planes: s, stride } = mesh.grid;
      const sign = (plane: number, power: number) => (p: number) => {
        if (!mesh.covered[p]) return NaN;
        const value = s[plane * stride + p]!, bend = s[PLANE.curvedness * stride + p]!;
        return Math.abs(value) <= RELATIVE * bend ** power ? 0 : value;
      };
      if (settings.zeroK) zeroContour(sign(PLANE.gaussian, 2), n, mesh.position, this.lines.zeroK);
      if (settings.zeroH) zeroContour(sign(PLANE.mean, 1), n, mesh.position, this.lines.zeroH);
      if (settings.section) {
        const [a, b, c, d] = sectionPlane(settings, frame), x = mesh.position;
        zeroContour((p) => (mesh.covered[p] ? a * x[3 * p]! + b * x[3 * p + 1]! + c * x[3 * p + 2]! - d : NaN), n, x, this.lines.section);
        this.showPlane(settings, frame);
      } else this.grips.fill([], []);
    }
    for (const name of FROM_SURFACE) this.lines[name].end();
  }

  /** Redraw a curve with its comb: teeth of `tooth` times the curvature, in the scene, away from the centre of curvature. */
  curve(points: readonly CurvePoint[], frame: Frame, tooth: number): void {
    const { curve, teethU, combU } = this.lines, all = [...FROM_SURFACE, "curve"] as const;
    for (const name of all) this.lines[name].begin();
    this.grips.fill([], []);
    const scene = points.map(({ point }) => toScene(frame, point));
    const tips = tooth ? points.map(({ bend }, i) => scene[i]!.map((x, k) => x - tooth * bend[k]!)) : [];
    for (let i = 0; i + 1 < scene.length; i++) {
      curve.join(scene[i]!, scene[i + 1]!);
      if (tooth) combU.join(tips[i]!, tips[i + 1]!);
    }
    for (let i = 0; i < tips.length; i += TOOTH) teethU.join(scene[i]!, tips[i]!);
    for (const name of all) this.lines[name].end();
    this.curvePoints = [...scene, ...tips.filter((tip) => tip.every(Number.isFinite))];
  }

  /** The outline of the section plane, its normal, and the grips that move and tilt it. */
  private showPlane(settings: Settings, frame: Frame): void {
    const corners = sectionOutline(settings, frame), { move, tilt } = sectionGrips(settings, frame);
    corners.forEach((corner, i) => this.lines.plane.join(corner, corners[(i + 1) % corners.length]!));
    this.lines.arm.join(move, tilt);
    this.grips.fill([move, tilt], [GRIP, [...GRIP.slice(0, 3), 0.5]]);
  }

  /** Redraw the control net and the points that can be dragged. */
  net(polylines: readonly (readonly (readonly number[])[])[], handles: readonly Handle[], selected: string | null, frame: Frame): void {
    const { net } = this.lines;
    net.begin();
    this.netPoints = [];
    for (const line of polylines) {
      const scene = line.map((p) => toScene(frame, p));
      this.netPoints.push(...scene);
      for (let i = 0; i + 1 < scene.length; i++) net.join(scene[i]!, scene[i + 1]!);
    }
    net.end();
    const tint = (h: Handle) => (h.id === selected ? [0.93, 0.42, 0.05, 2] : h.mirrored ? [0.25, 0.38, 0.55, 0.5] : [...h.tint, 1]);
    this.points.fill(handles.map((h) => toScene(frame, h.position)), handles.map(tint));
  }

  /** Redraw the edge of regression where it lies inside the strip. */
  edge(pieces: readonly (readonly (readonly number[])[])[], frame: Frame): void {
    const { edge } = this.lines;
    edge.begin();
    for (const piece of pieces) {
      const scene = piece.map((p) => toScene(frame, p));
      for (let i = 0; i + 1 < scene.length; i++) edge.join(scene[i]!, scene[i + 1]!);
    }
    edge.end();
  }

  /** Draw seams, each in the colour of its order. */
  seams(seams: readonly Seam[], frame: Frame): void {
    for (const order of ORDERS) {
      const lines = this.lines[`seam ${order}`];
      lines.begin();
      for (const { points } of seams.filter((seam) => seam.order === order)) {
        const scene = points.map((p) => toScene(frame, p));
        for (let i = 0; i + 1 < scene.length; i++) lines.join(scene[i]!, scene[i + 1]!);
      }
      lines.end();
    }
  }

  dispose(): void {
    for (const name of LINES) this.lines[name].dispose();
    this.target.dispose();
    this.points.dispose();
    this.grips.dispose();
  }

  /** Principal directions, κ1 strong and κ2 light, as crosses at about 16 × 16 points. */
  private directions(mesh: SurfaceMesh): void {
    const { planes: s, stride, size } = mesh.grid;
    each(mesh, (p, spacing) => {
      const r = s[PLANE.halfDifference * stride + p]!;
      if (!(r > RELATIVE * s[PLANE.curvedness * stride + p]! && s[PLANE.curvedness * stride + p]! * size > 1e-9)) return;
      principalDirection(s[p]!, s[stride + p]!, s[2 * stride + p]!, r);
      const x = mesh.position.subarray(3 * p, 3 * p + 3), half = 0.36 * spacing;
      const first = [0, 0, 0], second = [0, 0, 0];
      for (let i = 0; i < 3; i++) {
        const e1 = s[(PLANE.e1 + i) * stride + p]!, e2 = s[(PLANE.e2 + i) * stride + p]!;
        first[i] = half * (directionCos * e1 + directionSin * e2);
        second[i] = half * (directionCos * e2 - directionSin * e1);
      }
      const cross = (line: Lines, d: number[]) =>
        line.segment(x[0]! - d[0]!, x[1]! - d[1]!, x[2]! - d[2]!, x[0]! + d[0]!, x[1]! + d[1]!, x[2]! + d[2]!);
      cross(this.lines.first, first);
      cross(this.lines.second, second);
    });
  }

  private normals(mesh: SurfaceMesh): void {
    const { planes: s, stride } = mesh.grid;
    each(mesh, (p, spacing) => {
      const x = mesh.position.subarray(3 * p, 3 * p + 3), length = 0.9 * spacing;
      const n = (i: number) => length * s[(PLANE.normal + i) * stride + p]!;
      this.lines.normals.segment(x[0]!, x[1]!, x[2]!, x[0]! + n(0), x[1]! + n(1), x[2]! + n(2));
    });
  }

  /** Combs of the normal curvature along seven iso-curves; teeth point away from the centre of curvature. */
  private combs(mesh: SurfaceMesh, alongU: boolean, tooth: number): void {
    const { planes: s, stride, nu: n } = mesh.grid;
    const teeth = alongU ? this.lines.teethU : this.lines.teethV, tips = alongU ? this.lines.combU : this.lines.combV;
    const curves = COMBS, every = Math.max(1, Math.round((n - 1) / 60));
    const at = (curve: number, i: number) => {
      const fixed = Math.round((curve * (n - 1)) / (curves - 1));
      return alongU ? i * n + fixed : fixed * n + i;
    };
    for (let curve = 0; curve < curves; curve++) {
      let before: number[] | null = null;
      for (let i = 0; i < n; i += every) {
        const p = at(curve, Math.min(i, n - 1));
        const x = mesh.position.subarray(3 * p, 3 * p + 3), length = -tooth * bendAlong(mesh, alongU, p);
        const tip = [0, 1, 2].map((c) => x[c]! + length * s[(PLANE.normal + c) * stride + p]!);
        if (!mesh.covered[p] || tip.some(Number.isNaN)) {
          before = null;
          continue;
        }
        teeth.segment(x[0]!, x[1]!, x[2]!, tip[0]!, tip[1]!, tip[2]!);
        if (before) tips.join(before, tip);
        before = tip;
      }
    }
  }
}

const COMBS = 7;
const TOOTH = 3; // points of a curve from tooth to tooth

/** Normal curvature along the iso-curve through a grid point, length⁻¹. */
function bendAlong(mesh: SurfaceMesh, alongU: boolean, p: number): number {
  const { planes: s, stride } = mesh.grid, form = PLANE.forms + (alongU ? 0 : 2);
  return s[(form + 3) * stride + p]! / s[form * stride + p]!;
}

/** Scene length of a comb's tooth per curvature, common to all that is shown, so that combs can be compared. */
export function toothOf(meshes: readonly SurfaceMesh[], settings: Settings, frame: Frame): number {
  let longest = 0, size = 0;
  for (const mesh of meshes) {
    const n = mesh.grid.nu;
    size = Math.max(size, mesh.grid.size);
    for (let curve = 0; curve < COMBS; curve++) {
      const fixed = Math.round((curve * (n - 1)) / (COMBS - 1));
      for (let i = 0; i < n; i += 3) {
        const bend = (alongU: boolean, p: number) => (mesh.covered[p] && Math.abs(bendAlong(mesh, alongU, p))) || 0;
        if (settings.combs !== "v") longest = Math.max(longest, bend(true, i * n + fixed));
        if (settings.combs !== "u") longest = Math.max(longest, bend(false, fixed * n + i));
      }
    }
  }
  return longest * size > 1e-9 ? (0.22 * settings.combScale * size * frame.scale) / longest : 0;
}

/** Scene length of a comb's tooth per curvature for curves, common to all that are shown. */
export function toothOfCurves(curves: readonly (readonly CurvePoint[])[], scale: number, frame: Frame): number {
  const longest = Math.max(0, ...curves.flat().map(({ curvature }) => Math.abs(curvature) || 0).filter(Number.isFinite));
  const size = 2 * Math.hypot(...frame.half) / frame.scale; // length¹
  return longest * size > 1e-9 ? (0.15 * scale * size * frame.scale) / longest : 0;
}

/** Call `act` at about 16 × 16 points of the grid, with the scene distance between them. */
function each(mesh: SurfaceMesh, act: (p: number, spacing: number) => void): void {
  const n = mesh.side, many = Math.min(n, 17);
  const x = mesh.position, corner = (p: number) => [x[3 * p]!, x[3 * p + 1]!, x[3 * p + 2]!];
  const [a, b, c, d] = [corner(0), corner(n * (n - 1)), corner(n - 1), corner(n * n - 1)] as [number[], number[], number[], number[]];
  const distance = (p: number[], q: number[]) => Math.hypot(p[0]! - q[0]!, p[1]! - q[1]!, p[2]! - q[2]!);
  const spacing = Math.min(0.1, Math.max(0.035, (distance(a, b) + distance(a, c) + distance(c, d) + distance(b, d)) / (4 * (many - 1))));
  for (let i = 0; i < many; i++) {
    for (let k = 0; k < many; k++) {
      const p = Math.round((i * (n - 1)) / (many - 1)) * n + Math.round((k * (n - 1)) / (many - 1));
      if (mesh.covered[p]) act(p, spacing);
    }
  }
}
