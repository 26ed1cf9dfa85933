/** The pointer over the picture: turn, pan, zoom, drag control points, look at and pin points. */

import { handles, moved, type Handle } from "../edit/handles";
import { build, type Patch } from "../numerics/model";
import { toModel, toScene, type Frame } from "../view/frame";
import type { Ray, Stage } from "../view/stage";
import { activePatch, type Store } from "./state";

const NEAR = 11; // pixels

interface Drag {
  readonly kind: "turn" | "pan" | "move";
  readonly cell: number;
  readonly handle: Handle | null;
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
  let cached: { patch: Patch; list: Handle[] } | null = null;
  let pending = false;

  const at = (event: PointerEvent | WheelEvent) => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const all = (): Handle[] => {
    const patch = activePatch(store.state);
    if (cached?.patch !== patch) cached = { patch, list: safely(() => handles(patch, build(patch))) };
    return cached!.list;
  };
  const under = (x: number, y: number): Handle | null => {
    const cell = stage.cellAt(x, y);
    if (cell < 0 || !store.state.settings.net || !around.editable(cell)) return null;
    let best: Handle | null = null, near = NEAR;
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
    const { x, y } = at(event);
    const pan = event.button !== 0 || event.shiftKey;
    const handle = pan ? null : under(x, y);
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true, focusVisible: false } as FocusOptions);
    drag = { kind: pan ? "pan" : handle ? "move" : "turn", cell: stage.cellAt(x, y), handle, x, y, far: 0 };
    if (handle) store.set({ selected: handle.id, hover: null });
    event.preventDefault();
  });

  canvas.addEventListener("pointermove", (event) => {
    const { x, y } = at(event);
    if (!drag) {
      canvas.classList.toggle("grab", under(x, y) !== null);
      if (pending) return;
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
    else if (drag.kind === "pan") stage.orbit.pan(dx / stage.cells[0]!.height, dy / stage.cells[0]!.height);
    else if (drag.far > 2) move(drag, x, y);
    drag.x = x;
    drag.y = y;
    if (drag.kind !== "move") around.redraw();
  });

  const release = (event: PointerEvent) => {
    if (!drag) return;
    const done = drag;
    drag = null;
    store.settle();
    if (event.type === "pointercancel" || done.far > 4 || done.kind !== "turn" || event.button !== 0) return;
    const place = stage.pick(done.x, done.y, store.state.settings, around.frame());
    if (place) {
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
    stage.orbit.zoom(Math.exp(Math.max(-60, Math.min(60, event.deltaY * (event.deltaMode ? 16 : 1))) * 0.0022));
    around.redraw();
  }, { passive: false });

  function look(x: number, y: number): void {
    const place = stage.pick(x, y, store.state.settings, around.frame());
    if (place) store.set({ hover: { patch: place.piece, u: rounded(place.u), v: rounded(place.v), x, y, cell: place.cell } });
    else if (store.state.hover) store.set({ hover: null });
  }

  function move(now: Drag, x: number, y: number): void {
    const handle = all().find((one) => one.id === now.handle!.id);
    if (!handle) return;
    const { settings } = store.state;
    const start = toScene(around.frame(), handle.position);
    const from = stage.ray(now.cell, now.x, now.y), to = stage.ray(now.cell, x, y);
    const free = handle.free.map((can, i) => can && !settings.locks[i]) as unknown as [boolean, boolean, boolean];
    const target = handle.along ? alongLine(start, handle.along, from, to) : within(start, free, from, to, stage);
    let point = toModel(around.frame(), target).map((value, i) => (handle.along || free[i] ? value : handle.position[i]!));
    if (settings.snap && !handle.along) point = point.map((value, i) => (free[i] ? Math.round(value / settings.snapStep) * settings.snapStep : value));
    store.editPatch(moved(activePatch(store.state), handle, point), `drag ${handle.id}`);
  }
}

/** Parameters to four digits, so that what is shown is what is evaluated. */
const rounded = (t: number): number => Math.round(t * 1e4) / 1e4;

export const still = (): boolean => matchMedia("(prefers-reduced-motion: reduce)").matches;

/** Move with the pointer in the plane of the free axes; facing the eye when all are free. */
function within(start: readonly number[], free: readonly [boolean, boolean, boolean], from: Ray, to: Ray, stage: Stage): number[] {
  const count = free.filter(Boolean).length;
  if (count === 0) return [...start];
  if (count === 1) return alongLine(start, free.map(Number), from, to);
  const { towards } = stage.orbit.axes();
  let normal = [towards.x, towards.y, towards.z];
  if (count === 2) {
    const across = free.map((can) => (can ? 0 : 1));
    // Seen edge-on, the plane of the free axes cannot be met: stay in the plane facing the eye.
    const axis = across.indexOf(1);
    if (Math.abs(normal[axis]!) > 0.05) normal = across;
  }
  const a = meet(start, normal, from), b = meet(start, normal, to);
  return start.map((x, i) => (free[i] ? x + b[i]! - a[i]! : x));
}

function meet(point: readonly number[], normal: readonly number[], ray: Ray): number[] {
  const dot = (p: readonly number[], q: readonly number[]) => p[0]! * q[0]! + p[1]! * q[1]! + p[2]! * q[2]!;
  const away = dot(normal, point) - dot(normal, ray.origin), speed = dot(normal, ray.direction);
  const t = Math.abs(speed) > 1e-9 ? away / speed : 0;
  return ray.origin.map((x, i) => x + t * ray.direction[i]!);
}

/** Move along a line by as much as its nearest point to the pointer's ray moves. */
function alongLine(start: readonly number[], direction: readonly number[], from: Ray, to: Ray): number[] {
  const length = Math.hypot(...direction), d = direction.map((x) => x / length);
  const nearest = (ray: Ray) => {
    const w = start.map((x, i) => x - ray.origin[i]!);
    const dot = (p: readonly number[], q: readonly number[]) => p[0]! * q[0]! + p[1]! * q[1]! + p[2]! * q[2]!;
    const b = dot(d, ray.direction), denominator = 1 - b * b;
    return denominator > 1e-4 ? (b * dot(w, ray.direction) - dot(w, d)) / denominator : 0;
  };
  const step = nearest(to) - nearest(from);
  return start.map((x, i) => x + step * d[i]!);
}

function safely<T>(act: () => T[]): T[] {
  try {
    return act();
  } catch {
    return []; // a patch between two valid states has no handles
  }
}
