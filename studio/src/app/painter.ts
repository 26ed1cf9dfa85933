/** Keeps the picture up to date: evaluates what changed, at as many points as a frame's time allows. */

import { handles, handlesOf, polygonOf, polylines } from "../edit/handles";
import { curveOf, isCurve } from "../numerics/curve";
import { regression } from "../numerics/envelope";
import { build, type Patch } from "../numerics/model";
import { seamsOf, type Seam } from "../numerics/seams";
import { QUANTITY } from "../numerics/quantity";
import { analyse } from "../numerics/sample";
import type { Surface } from "../numerics/surface";
import type { Frame } from "../view/frame";
import type { SurfaceMesh } from "../view/mesh";
import type { Regions } from "../view/proof";
import { toothOf, toothOfCurves } from "../view/overlays";
import { drawTarget } from "../view/target";
import { sharpest, type Sharpest } from "../view/radius";
import type { Cell, Piece } from "../view/cell";
import type { Stage } from "../view/stage";
import { mainCell, type Shown } from "./cells";
import type { Settings } from "./settings";
import type { State } from "./state";

const FRAME_BUDGET = 9; // ms that evaluating everything may take while something moves
const PROMPT = 20, LATE = 40; // ms from asking for a frame to its beginning: the card keeps up, or is behind
const LEAST = 36; // points a side
const CURVE = 361; // points of a curve
const STEPS = [1, 0.7, 0.5, 0.35, 0.25]; // of the points a side at rest

export class Painter {
  /** How long the last evaluation took, ms, and at how many points a side. */
  cost = 0;
  side = 0;
  /** The seams of the model, as they are now. */
  seams: readonly Seam[] = [];
  private coarse = 75;
  /** Points a side that the card keeps up with while something moves. */
  private drawable = Infinity;
  /** Scene length of the teeth of curves' combs per curvature. */
  private tooth = 0;

  constructor(private readonly stage: Stage, private readonly proofOf: (patch: Patch) => Regions | null, private readonly fail: (message: string) => void) {}

  get meshes(): SurfaceMesh[] {
    return this.stage.cells.flatMap((cell) => cell.pieces.filter((piece) => piece.surface).map((piece) => piece.mesh));
  }

  /** Evaluate the surfaces whose patch, resolution or frame changed; the time that it took, ms. */
  evaluate(shown: readonly Shown[], { settings, moving }: State, frame: Frame): number {
    this.side = this.points(settings, moving, shown.length);
    const start = performance.now();
    let points = 0;
    shown.forEach(({ model }, i) => {
      const cell = this.stage.cells[i]!;
      cell.resizePieces(model.patches.length);
      model.patches.forEach((patch, k) => (points += this.piece(cell.pieces[k]!, patch, settings, frame)));
    });
    const time = performance.now() - start;
    if (points) this.pace(time, points, settings.resolution);
    return time;
  }

  /** Learn how long the browser kept a frame waiting while something moves: when the card is behind, frames come late. */
  waited(time: number): void {
    if (time > LATE) this.drawable = Math.max(LEAST, 0.75 * this.side);
    else if (time < PROMPT) this.drawable *= 1.06;
  }

  /** Bring the lines and points over the surfaces up to date. */
  decorate(shown: readonly Shown[], state: State, frame: Frame): void {
    const tooth = state.settings.combs === "off" ? 0 : toothOf(this.meshes, state.settings, frame);
    const curves = this.stage.cells.flatMap((cell) => cell.pieces.map((piece) => piece.curve)).filter((curve) => curve.length);
    this.tooth = state.settings.comb && curves.length ? toothOfCurves(curves, state.settings.combScale, frame) : 0;
    shown.forEach(({ editable }, i) => this.overlay(this.stage.cells[i]!, state, frame, editable, tooth));
    this.sew(state, frame);
    this.target(state, frame);
  }

  /** Draw the target beside the model itself, with its first patch. */
  private target(state: State, frame: Frame): void {
    const main = mainCell(state, this.stage.cells.length), { beside } = state;
    this.stage.cells.forEach(({ pieces }, k) => pieces.forEach((piece, i) => {
      const own = k === main && i === 0 ? beside : null;
      if (piece.beside === own && (!own || piece.besideFrame === frame)) return;
      piece.beside = own;
      piece.besideFrame = frame;
      drawTarget(piece.overlays.target, own, frame);
    }));
  }

  /** Measure the seams whose patches changed, and draw them. */
  private sew(state: State, frame: Frame): void {
    const main = mainCell(state, this.stage.cells.length), { unit } = state.model;
    this.stage.cells.forEach(({ pieces }, k) => {
      const found = state.settings.seams && pieces.length > 1 ? seamsOf(pieces.map((piece) => piece.surface), unit) : [];
      if (k === main) this.seams = found;
      pieces.forEach((piece, i) => {
        const own = found.filter((seam) => seam.first.patch === i);
        if (!own.length && !piece.seams.length) return;
        if (piece.seams.length === own.length && piece.frame === piece.seamsFrame && own.every((seam, j) => seam.points === piece.seams[j]!.points && seam.order === piece.seams[j]!.order)) return;
        piece.seams = own;
        piece.seamsFrame = frame;
        piece.overlays.seams(own, frame);
      });
    });
  }

  /** The sharpest point of each cell. */
  sharpest(): { cell: number; at: Sharpest }[] {
    return this.stage.cells.flatMap(({ pieces }, cell) => {
      const found = pieces.map((piece) => (piece.surface ? sharpest(piece.surface, piece.mesh) : null)).filter((one) => one !== null);
      const least = found.sort((a, b) => a.radius - b.radius)[0];
      return least ? [{ cell, at: least }] : [];
    });
  }

  private piece(piece: Piece, patch: Patch, settings: Settings, frame: Frame): number {
    const { side } = this;
    const same = piece.patch === patch && piece.side === side && piece.frame === frame;
    if (same && piece.quantity !== settings.quantity) piece.mesh.paint(settings.quantity);
    piece.quantity = settings.quantity;
    if (same) return 0;
    try {
      if (isCurve(patch)) return this.curve(piece, patch, frame);
      if (piece.patch !== patch) piece.surface = build(patch);
      if (piece.curve.length) piece.overlays.curve((piece.curve = []), frame, 0);
    } catch (error) {
      this.fail((error as Error).message);
      return 0;
    }
    piece.patch = patch;
    piece.side = side;
    piece.frame = frame;
    piece.lines = piece.net = "";
    piece.mesh.update(piece.surface!, side, settings.quantity, frame);
    return side * side;
  }

  /** A curve has no mesh: its points are all that there is. */
  private curve(piece: Piece, patch: Patch, frame: Frame): number {
    piece.curve = curveOf(patch).sample(CURVE);
    Object.assign(piece, { surface: null, patch, side: this.side, frame, lines: "", net: "" });
    piece.mesh.clear();
    piece.overlays.edge([], frame);
    return 0;
  }

  private overlay(cell: Cell, state: State, frame: Frame, editable: boolean, tooth: number): void {
    cell.pieces.forEach((piece, i) => {
      if ((!piece.surface && !piece.curve.length) || !piece.patch) return;
      piece.mesh.prove(piece.surface ? this.proofOf(piece.patch) : null);
      const net = state.settings.net, active = net && editable && i === state.patch;
      const lines = piece.surface ? linesOf(state.settings, tooth) : `curve ${this.tooth}`;
      if (piece.lines !== lines && !piece.surface) piece.overlays.curve(piece.curve, frame, this.tooth);
      else if (piece.lines !== lines) piece.overlays.update(piece.mesh, state.settings, frame, tooth);
      piece.lines = lines;
      const shown = `${net} ${active} ${active ? state.selected : ""} ${state.moving}`;
      if (piece.net === shown) return;
      piece.net = shown;
      if (!piece.surface) return piece.overlays.net(net ? polygonOf(piece.patch) : [], active ? handlesOf(piece.patch) : [], state.selected, frame);
      piece.overlays.net(net ? polylines(piece.patch, piece.surface) : [], active ? handles(piece.patch, piece.surface) : [], state.selected, frame);
      // Found by a search of its own, so not while something moves.
      piece.overlays.edge(state.moving ? [] : edgeOf(piece.patch, piece.surface), frame);
    });
  }

  /** Points a side: as many as can be afforded while something moves, more at rest where classes have edges. */
  private points(settings: Settings, moving: boolean, cells: number): number {
    if (moving) {
      // A few steps, so that the same buffers serve again.
      const most = Math.min(this.coarse, this.drawable), steps = STEPS.map((share) => Math.max(LEAST, Math.round(share * settings.resolution)));
      return Math.min(settings.resolution, steps.find((side) => side <= most) ?? LEAST);
    }
    return QUANTITY[settings.quantity]?.colour === "classes" && cells === 1 ? 2 * settings.resolution : settings.resolution;
  }

  /** Choose how many points a side leave a frame's time while something moves. */
  private pace(time: number, points: number, full: number): void {
    this.cost = time;
    const perPoint = time / points, pieces = this.stage.cells.reduce((sum, cell) => sum + cell.pieces.length, 0);
    const fits = Math.sqrt(FRAME_BUDGET / perPoint / Math.max(1, pieces));
    this.coarse = fits >= full ? full : Math.max(LEAST, Math.min(full, Math.round(fits)));
  }
}

/** The settings that the lines over a surface follow from. */
const linesOf = (s: Settings, tooth: number): string => JSON.stringify(
  [tooth, s.directions, s.normals, s.combs, s.zeroK, s.zeroH, s.section, s.section && [s.sectionAzimuth, s.sectionTilt, s.sectionAt]]);

const edges = new WeakMap<Surface, number[][][]>();

/** The pieces of the edge of regression that lie inside a developable strip, points of length¹. */
function edgeOf(patch: Patch, surface: Surface): number[][][] {
  if (patch.kind !== "developable") return [];
  const known = edges.get(surface);
  if (known) return known;
  const found = regression(surface).map(({ u, v }) => {
    const { point } = analyse(surface, u, v, true, ["point"]);
    return u.map((_, p) => Array.from(point!.subarray(3 * p, 3 * p + 3)));
  });
  edges.set(surface, found);
  return found;
}
