/** The picture: cells side by side, each with the surfaces of one model, drawn by one renderer through one camera. */

import { Color, type Vector2, Vector3, WebGLRenderer } from "three";
import type { Settings } from "../app/settings";
import { covers, windowOf } from "../numerics/trim";
import { BACK, FRONT, UNDEFINED, type Rgb } from "../ui/colours";
import { Orbit, VIEWS, type ViewName } from "./camera";
import { Cell } from "./cell";
import { toScene, type Frame } from "./frame";
import { vector } from "./mesh";
import { meets, pick, type Hit } from "./pick";
import type { Range } from "./range";
import { sectionPlane } from "./section";
import { isSoftware } from "./software";
import { paintStill } from "./still";

const FAR = 6; // radii from the middle, beyond which control points are let out of the picture

export interface Ray {
  readonly origin: readonly [number, number, number];
  readonly direction: readonly [number, number, number];
}

export interface Place extends Hit {
  readonly cell: number;
  readonly piece: number;
}

export class Stage {
  readonly orbit = new Orbit();
  readonly cells: Cell[] = [];
  /** Null where WebGL 2 is missing: then pictures are painted on a plain canvas. */
  private readonly renderer: WebGLRenderer | null;
  private range: Range | null = null;
  private quantity = "none";
  private width = 1;
  private height = 1;
  private ratio = 1;
  private margin = 0;
  /** CSS pixels at the bottom that lie under the probe. */
  covered = 0;
  /** Drawn by the processor: then smoothing comes from more pixels at rest, and speed from fewer while something moves. */
  readonly software: boolean;
  private detail = 1;

  constructor(readonly canvas: HTMLCanvasElement) {
    this.software = isSoftware();
    const context = canvas.getContext("webgl2", { antialias: !this.software, alpha: true, powerPreference: "high-performance" });
    this.renderer = context && new WebGLRenderer({ canvas, context });
    this.renderer?.setClearColor(0x000000, 0);
    if (this.renderer) this.renderer.autoClear = false;
  }

  get works(): boolean {
    return this.renderer !== null;
  }

  resize(width: number, height: number, ratio: number): void {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    this.ratio = ratio;
    if (this.renderer) {
      this.renderer.setPixelRatio(this.pixels);
      this.renderer.setSize(this.width, this.height, false);
    } else {
      this.canvas.width = this.width * ratio;
      this.canvas.height = this.height * ratio;
    }
    this.arrange();
  }

  /** Spare pixels while something moves, where the processor draws. */
  economy(moving: boolean): void {
    const detail = !this.software ? 1 : moving ? 0.6 : 1.5;
    if (detail === this.detail) return;
    this.detail = detail;
    this.resize(this.width, this.height, this.ratio);
  }

  /** Drawn pixels per CSS pixel. */
  private get pixels(): number {
    return this.ratio * this.detail;
  }

  /** Make as many cells as asked for; several leave a strip on the right and at the bottom to legend and buttons. */
  layout(count: number, margin = 0): void {
    this.margin = margin;
    while (this.cells.length > count) this.cells.pop()!.resizePieces(0);
    while (this.cells.length < count) this.cells.push(new Cell());
    this.arrange();
  }

  private arrange(): void {
    const many = this.cells.length, columns = many > 4 ? 3 : many > 1 ? 2 : 1, rows = Math.ceil(many / columns);
    const width = many > 1 ? Math.max(0.6 * this.width, this.width - this.margin) : this.width, height = many > 1 ? this.height - 50 : this.height;
    this.cells.forEach((cell, i) => {
      cell.width = width / columns;
      cell.height = height / rows;
      cell.x = (i % columns) * cell.width;
      cell.y = Math.floor(i / columns) * cell.height;
      for (const piece of cell.pieces) piece.overlays.resize(cell.width * this.pixels, cell.height * this.pixels, this.pixels);
    });
  }

  /** Carry settings and range over to the materials. */
  style(settings: Settings, range: Range | null, dark: boolean, frame: Frame, active: number): void {
    const light = lightOf(settings);
    this.range = range;
    this.quantity = settings.quantity;
    const plane = sectionPlane(settings, frame);
    for (const cell of this.cells) {
      cell.pieces.forEach((piece, i) => {
        const u = piece.mesh.material.uniforms;
        set(u["front"]!.value, FRONT);
        set(u["back"]!.value, BACK);
        set(u["undefinedColour"]!.value, UNDEFINED);
        if (range) (u["range"]!.value as Vector2).set(range.low, range.high);
        u["contour"]!.value = range && settings.contours ? (range.high - range.low) / 10 : 0;
        u["stripes"]!.value = ["none", "zebra", "isophotes", "reflection", "highlight"].indexOf(settings.stripes);
        u["density"]!.value = settings.density;
        (u["light"]!.value as Vector3).copy(light);
        u["curves"]!.value = settings.wireframe ? 30 : settings.curves ? 10 : 0;
        u["cut"]!.value.set(...plane);
        u["clipped"]!.value = settings.section && settings.clip;
        u["wire"]!.value = settings.wireframe;
        u["shade"]!.value = settings.stripes === "none" ? 1 : 0.6;
        u["faded"]!.value = cell.pieces.length > 1 && i !== active ? 0.0 : 0;
        piece.overlays.theme(dark);
        piece.overlays.resize(cell.width * this.pixels, cell.height * this.pixels, this.pixels);
      });
    }
    this.orbit.chosen = this.works ? settings.projection : "orthographic"; // as still pictures are painted
  }

  draw(): void {
    const { renderer } = this;
    if (!renderer) return paintStill(this.canvas, this.cells, this.orbit, this.ratio, this.quantity, this.range);
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, this.width, this.height);
    renderer.clear();
    renderer.setScissorTest(true);
    const towards = this.orbit.axes().towards;
    for (const cell of this.cells) {
      const bottom = this.height - cell.y - cell.height;
      renderer.setViewport(cell.x, bottom, cell.width, cell.height);
      renderer.setScissor(cell.x, bottom, cell.width, cell.height);
      for (const piece of cell.pieces) (piece.mesh.material.uniforms["towards"]!.value as Vector3).copy(towards);
      renderer.render(cell.scene, this.orbit.camera(cell.width / cell.height));
    }
  }

  /** Zoom about a point of the canvas, in CSS pixels. */
  zoomAt(factor: number, x: number, y: number): void {
    const c = this.cells[Math.max(0, this.cellAt(x, y))]!;
    this.orbit.zoom(factor, (x - c.x) / c.height - (0.5 * c.width) / c.height, (y - c.y) / c.height - 0.5, c.width / c.height);
  }

  /** Let the picture follow the pointer by so many CSS pixels. */
  pan(dx: number, dy: number): void {
    const { width, height } = this.cells[0]!;
    this.orbit.pan(dx / height, dy / height, width / height);
  }

  /** The cell at a point of the canvas, in CSS pixels. */
  cellAt(x: number, y: number): number {
    return this.cells.findIndex((c) => x >= c.x && x < c.x + c.width && y >= c.y && y < c.y + c.height);
  }

  /** The ray in the scene through a point of the canvas. */
  ray(cell: number, x: number, y: number): Ray {
    const c = this.cells[cell]!, camera = this.orbit.camera(c.width / c.height);
    const right = ((x - c.x) / c.width) * 2 - 1, up = 1 - ((y - c.y) / c.height) * 2;
    const near = new Vector3(right, up, -1).unproject(camera), far = new Vector3(right, up, 1).unproject(camera);
    const direction = far.sub(near).normalize();
    return { origin: [near.x, near.y, near.z], direction: [direction.x, direction.y, direction.z] };
  }

  /** Where a scene point is in the canvas, in CSS pixels; `depth` grows away from the eye. */
  project(cell: number, p: readonly number[]): { x: number; y: number; depth: number } {
    const c = this.cells[cell]!;
    const q = new Vector3(p[0], p[1], p[2]).project(this.orbit.camera(c.width / c.height));
    return { x: c.x + (q.x + 1) * 0.5 * c.width, y: c.y + (1 - q.y) * 0.5 * c.height, depth: q.z };
  }

  /** The point of a surface at a point of the canvas. */
  pick(x: number, y: number, settings: Settings, frame: Frame): Place | null {
    const cell = this.cellAt(x, y);
    if (cell < 0) return null;
    const { origin, direction } = this.ray(cell, x, y);
    const [a, b, c, d] = sectionPlane(settings, frame), clipped = settings.section && settings.clip;
    let best: Place | null = null;
    this.cells[cell]!.pieces.forEach((piece, i) => {
      const n = piece.mesh.side, { surface } = piece;
      if (!surface || n < 2 || !meets(piece.mesh.box, origin, direction)) return;
      const [u0, v0, u1, v1] = windowOf(surface), at = (s: number, t: number) => [u0 + (u1 - u0) * s, v0 + (v1 - v0) * t] as const;
      const kept = (px: number, py: number, pz: number, s: number, t: number) => (!clipped || a * px + b * py + c * pz <= d) && covers(surface, ...at(s, t));
      const hit = pick(piece.mesh.position, n, origin, direction, kept);
      if (!hit || (best && hit.distance >= best.distance)) return;
      const [u, v] = at(hit.u, hit.v);
      best = { u, v, distance: hit.distance, cell, piece: i };
    });
    return best;
  }

  /** The place on a curve within so many CSS pixels of a point of the canvas; its t stands as u. */
  pickCurve(x: number, y: number, frame: Frame, within: number): { cell: number; piece: number; u: number; v: number } | null {
    const cell = this.cellAt(x, y);
    let best: { cell: number; piece: number; u: number; v: number } | null = null, near = within;
    for (const [piece, { curve }] of cell < 0 ? [] : this.cells[cell]!.pieces.entries()) {
      const seen = curve.map(({ point }) => this.project(cell, toScene(frame, point)));
      for (let i = 0; i + 1 < seen.length; i++) {
        const a = seen[i]!, b = seen[i + 1]!, dx = b.x - a.x, dy = b.y - a.y;
        const share = Math.min(1, Math.max(0, ((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy || 1)));
        const away = Math.hypot(a.x + share * dx - x, a.y + share * dy - y);
        if (away < near) [near, best] = [away, { cell, piece, u: curve[i]!.t + share * (curve[i + 1]!.t - curve[i]!.t), v: 0 }];
      }
    }
    return best;
  }

  /** Whether a surface stands before a point of the scene. */
  hides(cell: number, p: readonly number[], settings: Settings, frame: Frame): boolean {
    const at = this.project(cell, p), hit = this.pick(at.x, at.y, settings, frame);
    if (!hit) return false;
    const { origin } = this.ray(cell, at.x, at.y);
    return hit.distance < Math.hypot(...p.map((x, i) => x - origin[i]!)) - 0.03;
  }

  view(name: ViewName, frame: Frame, still: boolean, margin: number): void {
    this.orbit.straight = name !== "iso";
    this.fit(frame, still, margin, VIEWS[name]);
  }

  /** Look from a direction, everything in the picture, clear of a strip on the right `margin` CSS pixels wide. */
  fit(frame: Frame, still: boolean, margin: number, [azimuth, elevation]: readonly [number, number] = [this.orbit.azimuth, this.orbit.elevation]): void {
    const cell = this.cells[0];
    if (!cell) return;
    const trial = new Orbit();
    trial.azimuth = azimuth;
    trial.elevation = elevation;
    trial.chosen = this.orbit.projection;
    const { right, up } = trial.axes(), aspect = cell.width / cell.height;
    // The free part of the picture, in device coordinates: above the view buttons and left of the legend.
    const many = this.cells.length > 1, rim = cell.width < 300 ? 10 : 24;
    // Where there is no room beside the legend, the surface is let stand under it.
    const below = !many && margin > 0.3 * cell.width;
    const end = 1 - (2 * (many || below ? rim : margin + rim)) / cell.width, low = -1 + (2 * (many ? rim : 62 + Math.min(this.covered, 0.5 * cell.height))) / cell.height;
    const start = -1 + (2 * rim) / cell.width, high = 1 - (2 * (below ? Math.min(0.3 * cell.height, 150) : many ? rim + 22 : rim)) / cell.height;
    const p = new Vector3();
    for (let round = 0; round < 6; round++) {
      const camera = trial.camera(aspect);
      let [left, most, bottom, top] = [Infinity, -Infinity, Infinity, -Infinity];
      const take = (x: number, y: number, z: number) => {
        p.set(x, y, z).project(camera);
        left = Math.min(left, p.x);
        most = Math.max(most, p.x);
        bottom = Math.min(bottom, p.y);
        top = Math.max(top, p.y);
      };
      for (const { pieces } of this.cells) {
        for (const { mesh, overlays } of pieces) {
          const x = mesh.position, step = 3 * Math.max(1, Math.floor(mesh.side / 24));
          for (let at = 0; at + 2 < x.length; at += step) if (mesh.covered[at / 3] && within(frame, x[at]!, x[at + 1]!, x[at + 2]!)) take(x[at]!, x[at + 1]!, x[at + 2]!);
          for (const [px, py, pz] of [...overlays.netPoints, ...overlays.curvePoints]) if (Math.hypot(px!, py!, pz!) < FAR) take(px!, py!, pz!);
        }
      }
      if (!(most >= left)) break;
      const half = trial.span / Math.min(1, aspect);
      trial.target.addScaledVector(right, half * aspect * (0.5 * (left + most) - 0.5 * (start + end))).addScaledVector(up, half * (0.5 * (bottom + top) - 0.5 * (low + high)));
      trial.span = Math.min(20, Math.max(0.02, trial.span * Math.max((most - left) / (end - start), (top - bottom) / (high - low))));
    }
    this.orbit.go(azimuth, elevation, trial.span, trial.target, still);
  }

  /** Draw at a size of its own on a background, and hand back the pixels. */
  async picture(width: number, height: number, background: string | null): Promise<HTMLCanvasElement> {
    const before = { width: this.width, height: this.height, ratio: this.ratio, detail: this.detail };
    this.detail = this.software && Math.max(width, height) <= 4096 ? 2 : 1;
    this.renderer?.setClearColor(background ? new Color().setStyle(background, "srgb-linear") : 0x000000, background ? 1 : 0);
    this.resize(width, height, 1);
    this.draw();
    const copy = document.createElement("canvas");
    copy.width = width;
    copy.height = height;
    copy.getContext("2d")!.drawImage(this.canvas, 0, 0, width, height);
    this.renderer?.setClearColor(0x000000, 0);
    this.detail = before.detail;
    this.resize(before.width, before.height, before.ratio);
    this.draw();
    return copy;
  }

  /** Wait until the card has drawn everything asked for. */
  finish(): void {
    const gl = this.renderer?.getContext();
    gl?.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  dispose(): void {
    this.layout(0);
    this.renderer?.dispose();
  }
}

/** Direction of the light in the scene. */
export function lightOf(settings: Settings): Vector3 {
  const a = (settings.lightAzimuth * Math.PI) / 180, e = (settings.lightElevation * Math.PI) / 180;
  return new Vector3(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e));
}

/** Whether a point lies in the box that the picture is framed on: what runs off to infinity is let run out of it. */
const within = ({ half: [a, b, c] }: Frame, x: number, y: number, z: number): boolean =>
  Math.abs(x) <= a + 0.04 && Math.abs(y) <= b + 0.04 && Math.abs(z) <= c + 0.04;

function set(target: unknown, colour: Rgb): void {
  (target as Vector3).copy(vector(colour));
}
