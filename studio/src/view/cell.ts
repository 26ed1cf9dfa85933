/** What is drawn in one viewport: pieces, each a surface with the lines and points over it. */

import { Scene } from "three";
import type { Beside } from "../app/aims";
import type { CurvePoint } from "../numerics/curve";
import type { Patch } from "../numerics/model";
import type { Seam } from "../numerics/seams";
import type { Surface } from "../numerics/surface";
import type { Frame } from "./frame";
import { SurfaceMesh } from "./mesh";
import { Overlays } from "./overlays";

/** One surface in a cell. */
export class Piece {
  readonly mesh = new SurfaceMesh();
  readonly overlays = new Overlays();
  /** What was last drawn, so that only what changed is worked out again. */
  patch: Patch | null = null;
  surface: Surface | null = null;
  /** The points of a curve, where the piece is one. */
  curve: readonly CurvePoint[] = [];
  side = 0;
  frame: Frame | null = null;
  quantity = "";
  /** What the lines over the surface, and the net, were last drawn for. */
  lines = "";
  net = "";
  /** The seams drawn with it: those whose first side is its own. */
  seams: readonly Seam[] = [];
  seamsFrame: Frame | null = null;
  /** The target drawn with it, and where. */
  beside: Beside | null = null;
  besideFrame: Frame | null = null;
}

/** One viewport: its pieces and its place in the canvas, in CSS pixels from the top left. */
export class Cell {
  readonly scene = new Scene();
  readonly pieces: Piece[] = [];
  x = 0;
  y = 0;
  width = 1;
  height = 1;

  resizePieces(count: number): void {
    while (this.pieces.length > count) {
      const piece = this.pieces.pop()!;
      this.scene.remove(piece.mesh.mesh, piece.overlays.group);
      piece.mesh.dispose();
      piece.overlays.dispose();
    }
    while (this.pieces.length < count) {
      const piece = new Piece();
      this.pieces.push(piece);
      this.scene.add(piece.mesh.mesh, piece.overlays.group);
    }
  }
}
