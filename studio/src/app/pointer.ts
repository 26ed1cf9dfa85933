/** The pointer over the picture: turn, pan, zoom, drag control points, look at and pin points. */

import { handlesOf, moved, type Handle } from "../edit/handles";
import { follow, onGrid, wayOf, type Way } from "../edit/way";
import { toModel, toScene, type Frame } from "../view/frame";
import { gizmo, partAt, pixelAt } from "../view/gizmo";
import { clickSide } from "../ui/body-panel";
import { alongLine, onBall } from "../view/rays";
import { dragged, sectionGrips, sectionNormal } from "../view/section";
import type { Ray, Stage } from "../view/stage";
import { mainCell } from "./cells";
import { Fingers } from "./fingers";
import type { Settings } from "./settings";
import { activePatch, type Store } from "./state";

const NEAR = 11, NEAR_FINGER = 24; // pixels

interface Drag {
  readonly kind: "turn" | "pan" | "move" | "section";
  readonly cell: number;
  /** What was grabbed, as it was then, and the ray through where: all that follows is worked out from these, however many events come. */
  readonly handle: Handle | null;
  readonly grip: "move" | "tilt" | null;
  /** The axes of the part of the gizmo that was grabbed. */
  readonly axes: readonly number[] | null;
  readonly settings: Settings;
  readonly from: Ray | null;
  x: number;
  y: number;
  far: number;
}

export interface Surroundings {
  readonly store: Store;
  readonly stage: Stage;
  frame(): Frame;
  /** Whether points can be dragged in a cell. */
  editable(cell: number): boolean;
  fit(): void;
  redraw(): void;
  /** Whether the wheel zooms, rather than scrolling the page around. */
  ownsWheel(): boolean;
}

export function listen(canvas: HTMLCanvasElement, around: Surroundings): void {
  const { store, stage } = around;
  let drag: Drag | null = null;
  let pending = false;
  const fingers = new Fingers(stage, () => around.redraw());

  const at = (event: PointerEvent | WheelEvent) => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const all = () => handlesOf(activePatch(store.state));
  /** The part of the gizmo of the selected point under the pointer, with that point. */
  const gizmoUnder = (x: number, y: number, near: number): { handle: Handle; axes: readonly number[] } | null => {
    const cell = stage.cellAt(x, y), handle = store.state.settings.net && all().find((one) => one.id === store.state.selected);
    if (!handle || handle.along || cell !== mainCell(store.state, stage.cells.length)) return null;
    const part = partAt(gizmo(stage, cell, toScene(around.frame(), handle.position), freeOf(handle)), x, y, near);
    return part && { handle, axes: part.axes };
  };
  const freeOf = (handle: Handle) => handle.free.map((can, i) => can && !store.state.settings.locks[i]);
  const gripUnder = (x: number, y: number, near: number): "move" | "tilt" | null => {
    const cell = stage.cellAt(x, y), { settings } = store.state;
    if (cell < 0 || !settings.section) return null;
    const grips = sectionGrips(settings, around.frame());
    const away = (grip: "move" | "tilt") => {
      const p = stage.project(cell, grips[grip]);
      return Math.hypot(p.x - x, p.y - y);
    };
    // The grip that tilts comes first: the other can be reached from beside it.
    return away("tilt") < near ? "tilt" : away("move") < near ? "move" : null;
  };
  const under = (x: number, y: number, within: number): Handle | null => {
    const cell = stage.cellAt(x, y);
    if (cell < 0 || !store.state.settings.net || !around.editable(cell)) return null;
    let best: Handle | null = null, near = within;
    for (const handle of all()) {
      const p = stage.project(cell, toScene(around.frame(), handle.position));
      const distance = Math.hypot(p.x - x, p.y - y) - (handle.id === store.state.selected ? 2 : 0);
      if (distance < near) {
        near = distance;
        best = handle;
      }
    }
    return best;
  };

  canvas.addEventListener("pointerdown", (event) => {
    const { x, y } = at(event), finger = event.pointerType === "touch";
    const pan = event.button !== 0 || event.shiftKey, near = finger ? NEAR_FINGER : NEAR;
    capture(canvas, event.pointerId);
    canvas.focus({ preventScroll: true, focusVisible: false } as FocusOptions);
    event.preventDefault();
    if (finger && fingers.touch(event.pointerId, { x, y })) {
      drag = null;
      return store.settle();
    }
    const grip = pan ? null : gripUnder(x, y, near), point = pan || grip ? null : under(x, y, near);
    const arm = pan || grip || point ? null : gizmoUnder(x, y, 0.6 * near), handle = point ?? arm?.handle ?? null;
    const cell = stage.cellAt(x, y), kind = pan ? "pan" : grip ? "section" : handle ? "move" : "turn";
    drag = { kind, cell, handle, grip, axes: arm?.axes ?? null, settings: store.state.settings, from: cell < 0 ? null : stage.ray(cell, x, y), x, y, far: 0 };
    if (handle) store.set({ selected: handle.id, hover: null });
  });

  canvas.addEventListener("pointermove", (event) => {
    const { x, y } = at(event);
    if (fingers.move(event.pointerId, { x, y })) return;
    if (!drag) {
      canvas.classList.toggle("grab", under(x, y, NEAR) !== null || gripUnder(x, y, NEAR) !== null || gizmoUnder(x, y, 0.6 * NEAR) !== null);
      if (pending || event.pointerType === "touch") return;
      pending = true;
      requestAnimationFrame(() => {
        pending = false;
        if (!drag) look(x, y);
      });
      return;
    }
    const dx = x - drag.x, dy = y - drag.y;
    drag.far += Math.abs(dx) + Math.abs(dy);
    if (drag.kind === "turn") stage.orbit.turn(dx, dy);
    else if (drag.kind === "pan") stage.pan(dx, dy);
    else if (drag.kind === "section") cut(drag, x, y);
    else if (drag.far > 2) move(drag, x, y, event.altKey);
    drag.x = x;
    drag.y = y;
    if (drag.kind === "turn" || drag.kind === "pan") around.redraw();
  });

  const release = (event: PointerEvent) => {
    if (fingers.lift(event.pointerId) || !drag) return;
    const done = drag;
    drag = null;
    store.settle();
    if (event.type === "pointercancel" || done.far > 4 || done.kind !== "turn" || event.button !== 0) return;
    const place = placeAt(done.x, done.y);
    if (place && store.state.joining) clickSide(store, `${store.state.model.patches[place.piece]!.name}:${nearestSide(place.u, place.v)}`);
    else if (place) {
      const selected = place.piece === store.state.patch ? store.state.selected : null;
      store.set({ hover: null, patch: place.piece, selected, pins: [...store.state.pins, { patch: place.piece, u: rounded(place.u), v: rounded(place.v) }] });
    }
    else store.set({ selected: null });
  };
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
  canvas.addEventListener("pointerleave", () => {
    if (!drag && store.state.hover) store.set({ hover: null });
  });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("dblclick", () => {
    around.fit();
  });
  canvas.addEventListener("wheel", (event) => {
    // In a page among other things the wheel scrolls the page, until the picture was clicked.
    if (!around.ownsWheel() && !event.ctrlKey) return;
    event.preventDefault();
    const { x, y } = at(event);
    stage.zoomAt(Math.exp(Math.max(-60, Math.min(60, event.deltaY * (event.deltaMode ? 16 : 1))) * 0.0022), x, y);
    around.redraw();
  }, { passive: false });

  /** The place on a surface, or on a curve, under the pointer. */
  function placeAt(x: number, y: number): { cell: number; piece: number; u: number; v: number } | null {
    return stage.pickCurve(x, y, around.frame(), NEAR) ?? stage.pick(x, y, store.state.settings, around.frame());
  }

  function look(x: number, y: number): void {
    const place = placeAt(x, y);
    if (place) store.set({ hover: { patch: place.piece, u: rounded(place.u), v: rounded(place.v), x, y, cell: place.cell } });
    else if (store.state.hover) store.set({ hover: null });
  }

  function cut({ grip, settings, from, cell }: Drag, x: number, y: number): void {
    const frame = around.frame(), start = sectionGrips(settings, frame)[grip!], to = stage.ray(cell, x, y);
    const target = grip === "move" ? alongLine(start, sectionNormal(settings), from!, to) : onBall(Math.hypot(...start), to, start);
    store.setting(dragged(grip!, target, settings, frame));
  }

  function move({ handle, from, cell, axes }: Drag, x: number, y: number, facing: boolean): void {
    if (!handle || !from || !all().some((one) => one.id === handle.id)) return;
    const { settings } = store.state, frame = around.frame();
    const start = toScene(frame, handle.position), to = stage.ray(cell, x, y), { towards } = stage.orbit.axes();
    const free = axes ? [0, 1, 2].map((i) => axes.includes(i)) : freeOf(handle), eye = [towards.x, towards.y, towards.z];
    const way: Way = handle.along ? { line: handle.along } : wayOf(free, facing ? eye : handle.plane, eye);
    const target = toModel(frame, follow(way, start, from, to));
    // What lies between two pixels cannot be aimed at: digits beyond that would be made up.
    const step = settings.snap ? settings.snapStep : 10 ** Math.floor(Math.log10(pixelAt(stage, cell, start) / frame.scale));
    const point = handle.along ? offset(handle.along, target, step) : onGrid(way, handle.position, target, step, settings.snap);
    store.editPatch(moved(activePatch(store.state), handle, point), `drag ${handle.id}`);
  }
}

/** The point moved along a plane's normal so that the plane's offset d = -n·p is a multiple of a step. */
function offset(normal: readonly number[], point: readonly number[], step: number): number[] {
  const dot = (p: readonly number[]) => p.reduce((sum, x, i) => sum + x * normal[i]!, 0);
  const shift = (-dot(point) - Math.round(-dot(point) / step) * step) / dot(normal);
  return point.map((x, i) => x + shift * normal[i]!);
}

/** The side of the unit square nearest to a place in it. */
function nearestSide(u: number, v: number): string {
  const away = { u0: u, u1: 1 - u, v0: v, v1: 1 - v };
  return Object.entries(away).sort((a, b) => a[1] - b[1])[0]![0];
}

/** Parameters to four digits, so that what is shown is what is evaluated. */
const rounded = (t: number): number => Math.round(t * 1e4) / 1e4;

export const still = (): boolean => matchMedia("(prefers-reduced-motion: reduce)").matches;

/** Keep a pointer; one that is gone already, as after a touch that the browser took, is no matter. */
function capture(canvas: HTMLElement, id: number): void {
  try {
    canvas.setPointerCapture(id);
  } catch {
    // It moves on its own.
  }
}
