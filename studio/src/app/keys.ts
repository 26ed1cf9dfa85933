/** The keyboard: every command that the pointer has. */

import { handlesOf } from "../edit/handles";
import { isTyping } from "../ui/controls";
import { nudge } from "../ui/model-panel";
import type { ViewName } from "../view/camera";
import type { Frame } from "../view/frame";
import type { Stage } from "../view/stage";
import type { Files } from "./files";
import { activePatch, type Compare, type Store } from "./state";

const VIEW_KEYS: Readonly<Record<string, ViewName>> = { "1": "iso", "2": "top", "3": "side", "4": "back", "5": "front", "6": "bottom" };
const ARROWS: Readonly<Record<string, readonly [number, number]>> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

const TEXT = "input:not([type=checkbox], [type=range], [type=radio]), select, textarea, [contenteditable]";
const OWN_ARROWS = "input[type=range], input[type=radio], [role=radio], .knob";

export interface Commands {
  readonly store: Store;
  readonly stage: Stage;
  readonly files: Files;
  frame(): Frame;
  fit(): void;
  view(name: ViewName): void;
  redraw(): void;
  help(): void;
}

/** Act on a key; true when it was one of ours. */
export function press(event: KeyboardEvent, c: Commands): boolean {
  const { store, stage } = c, { settings } = store.state;
  const target = event.composedPath()[0];
  if (!(target instanceof HTMLElement)) return false;
  if (event.ctrlKey || event.metaKey) {
    const key = event.key.toLowerCase();
    if (key === "s") void c.files.save();
    else if (key === "o") c.files.choose();
    else if (isTyping(target)) return false;
    else if (key === "z" && event.shiftKey) store.redo();
    else if (key === "z") store.undo();
    else if (key === "y") store.redo();
    else return false;
    return true;
  }
  if (event.altKey || target.matches(TEXT)) return false;
  const view = VIEW_KEYS[event.key], arrow = ARROWS[event.key];
  if (arrow && target.matches(OWN_ARROWS)) return false;
  if (view) c.view(view);
  else if (arrow) arrowKey(arrow, event.shiftKey, c);
  else if (event.key === "+" || event.key === "=") stage.orbit.zoom(0.85);
  else if (event.key === "-") stage.orbit.zoom(1 / 0.85);
  else {
    switch (event.key.length === 1 ? event.key.toLowerCase() : event.key) {
      case "p": {
        const projection = stage.orbit.projection === "perspective" ? "orthographic" : "perspective";
        stage.orbit.straight = false;
        store.setting({ projection });
        break;
      }
      case "f": c.fit(); break;
      case "n": store.setting({ net: !settings.net }); break;
      case "i": store.setting({ curves: !settings.curves }); break;
      case "w": store.setting({ wireframe: !settings.wireframe }); break;
      case "z": store.setting({ stripes: settings.stripes === "zebra" ? "none" : "zebra" }); break;
      case "c": {
        const order: Compare[] = ["off", "before", "sets", "kept"];
        store.set({ compare: order[(order.indexOf(store.state.compare) + 1) % order.length]! });
        break;
      }
      case "[":
      case "]": choosePoint(store, event.key === "]" ? 1 : -1); break;
      case "Escape": store.set({ selected: null, message: null }); break;
      case "?": c.help(); break;
      case "Enter": {
        if (!target.matches("canvas")) return false;
        const cell = stage.cells[0]!;
        const place = stage.pick(cell.x + cell.width / 2, cell.y + cell.height / 2, settings, c.frame());
        if (place) store.set({ pins: [...store.state.pins, { patch: place.piece, u: Math.round(place.u * 1e4) / 1e4, v: Math.round(place.v * 1e4) / 1e4 }] });
        break;
      }
      default: return false;
    }
  }
  c.redraw();
  return true;
}

function arrowKey([right, up]: readonly [number, number], shift: boolean, c: Commands): void {
  const { store, stage } = c;
  if (!store.state.selected) {
    if (shift) stage.orbit.pan(-0.03 * right, 0.03 * up);
    else stage.orbit.turn(-12 * right, -12 * up);
    return;
  }
  // Along the coordinate axes that point most nearly the way of the arrow.
  const axes = stage.orbit.axes(), way = right ? axes.right : axes.up, sign = right || up;
  const parts = [way.x, way.y, way.z], most = parts.map(Math.abs).indexOf(Math.max(...parts.map(Math.abs)));
  const step = store.state.settings.snapStep * (shift ? 10 : 1) * sign * Math.sign(parts[most]!);
  nudge(store, [0, 1, 2].map((i) => (i === most ? step : 0)));
  store.settle();
}

function choosePoint(store: Store, step: number): void {
  const patch = activePatch(store.state);
  const list = handlesOf(patch).filter((handle) => !handle.mirrored);
  if (!list.length) return;
  const at = list.findIndex((handle) => handle.id === store.state.selected);
  store.set({ selected: list[(at + step + list.length) % list.length]!.id });
}
