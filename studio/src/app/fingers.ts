/** Two fingers on the picture: pinch to zoom about the point between them, move both to pan. */

import type { Stage } from "../view/stage";

interface Point {
  readonly x: number;
  readonly y: number;
}

export class Fingers {
  private readonly down = new Map<number, Point>();
  /** True from the second finger's touch until the last one is lifted. */
  private busy = false;

  constructor(private readonly stage: Stage, private readonly redraw: () => void) {}

  /** A finger touches at a point of the picture; true when two fingers have taken over. */
  touch(id: number, at: Point): boolean {
    this.down.set(id, at);
    this.busy ||= this.down.size > 1;
    return this.busy;
  }

  /** A finger moves; true when the move belongs to a gesture of two. */
  move(id: number, at: Point): boolean {
    if (!this.busy || !this.down.has(id)) return false;
    const before = this.span();
    this.down.set(id, at);
    const after = this.span();
    if (before && after) {
      this.stage.zoomAt(before.apart / after.apart, before.middle.x, before.middle.y);
      this.stage.pan(after.middle.x - before.middle.x, after.middle.y - before.middle.y);
      this.redraw();
    }
    return true;
  }

  /** A finger is lifted; true when it was part of a gesture of two. */
  lift(id: number): boolean {
    const mine = this.down.delete(id) && this.busy;
    if (!this.down.size) this.busy = false;
    return mine;
  }

  private span(): { apart: number; middle: Point } | null {
    const [a, b] = [...this.down.values()];
    if (!a || !b) return null;
    return { apart: Math.max(8, Math.hypot(a.x - b.x, a.y - b.y)), middle: { x: 0.5 * (a.x + b.x), y: 0.5 * (a.y + b.y) } };
  }
}
