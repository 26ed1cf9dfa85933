/** The state of the studio and the one place that changes it. */

import data from "../data.json";
import { followed } from "../edit/follow";
import { refusal } from "../numerics/built";
import { drawnHere } from "../numerics/builders";
import { isStandard } from "../numerics/chosen";
import { fromDict, shapeOf, STARTERS, type Model, type Patch } from "../numerics/model";
import { NO_AIMS, type Aims, type Beside, type Light } from "./aims";
import { remember, type Settings } from "./settings";

/** What else is shown beside the model. */
export type Compare = "off" | "before" | "sets" | "kept";

export interface Pin {
  readonly patch: number;
  readonly u: number;
  readonly v: number;
}

/** Where the model came from; `tag` tells the version on disk that was read. */
export interface Source {
  readonly name: string;
  readonly tag: string;
}

/** A model with the file it belongs to: the two never part, whatever opens, restores or undoes. */
export interface Work {
  readonly model: Model;
  /** The model as last opened or saved. */
  readonly saved: Model;
  readonly source: Source | null;
  /** Which opening it belongs to: an undo may lead back to the one before. */
  readonly opened: number;
}

export interface State extends Work {
  readonly patch: number;
  readonly selected: string | null;
  readonly settings: Settings;
  readonly compare: Compare;
  readonly kept: readonly { readonly label: string; readonly model: Model }[];
  readonly pins: readonly Pin[];
  readonly hover: (Pin & { readonly x: number; readonly y: number; readonly cell: number }) | null;
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  /** True while something is dragged: coarse is good enough. */
  readonly moving: boolean;
  /** Two sides are being chosen to be joined, or released: the order, and the first of them. */
  readonly joining: { readonly order: string; readonly first: string | null } | null;
  /** What the model is measured against, and what was last found. */
  readonly aims: Aims;
  readonly beside: Beside | null;
  readonly lights: readonly Light[];
  readonly message: Message | null;
}

/** What is told at the top of the picture; `lines` stay until they are closed. */
export interface Message {
  readonly text: string;
  readonly kind: "error" | "note";
  readonly lines?: readonly string[];
  readonly actions?: readonly { readonly label: string; act(): void }[];
}

export type Listener = (now: State, before: State) => void;

export class Store {
  private past: Work[] = [];
  private future: Work[] = [];
  private openings = 1;
  private gesture: string | null = null;
  private readonly listeners: Listener[] = [];

  constructor(public state: State) {}

  subscribe(listener: Listener): void {
    this.listeners.push(listener);
  }

  set(change: Partial<State>): void {
    const before = this.state;
    this.state = { ...before, ...change };
    if (this.state.settings !== before.settings) remember(this.state.settings);
    for (const listener of this.listeners) listener(this.state, before);
  }

  setting(change: Partial<Settings>): void {
    this.set({ settings: { ...this.state.settings, ...change } });
  }

  /** Replace the model. Edits of one gesture (a drag, a slider held) are one step of undo. */
  edit(model: Model, gesture: string | null = null): void {
    if (model === this.state.model) return;
    const fixed = model.patches.find((patch) => !drawnHere(patch) && refusal(patch));
    if (fixed) return this.set({ message: { kind: "error", text: refusal(fixed) } });
    if (gesture === null || gesture !== this.gesture) {
      this.remember();
    }
    this.gesture = gesture;
    this.future = [];
    this.replace({ ...workOf(this.state), model }, gesture !== null);
  }

  /** Take up work on another file, or another version of this one, as a step that can be undone. */
  resume(work: Omit<Work, "opened">): void {
    this.remember();
    this.gesture = null;
    this.future = [];
    this.replace({ ...work, opened: ++this.openings }, false);
  }

  /** A model of one opening was written: every step of that opening belongs to this version of the file now. */
  written(opened: number, saved: Model, source: Source | null): void {
    const told = <T extends Work>(work: T): T => (work.opened === opened ? { ...work, saved, source: source ?? work.source } : work);
    this.past = this.past.map(told);
    this.future = this.future.map(told);
    this.set(told(this.state));
  }

  /** Replace the active patch, and what moves with it. */
  editPatch(patch: Patch, gesture: string | null = null): void {
    const { model, patch: at, settings } = this.state;
    this.edit(settings.together ? followed(model, at, patch) : { ...model, patches: model.patches.with(at, patch) }, gesture);
  }

  /** A gesture is over: what follows is a step of its own. */
  settle(): void {
    this.gesture = null;
    if (this.state.moving) this.set({ moving: false });
  }

  undo(): void {
    const work = this.past.pop();
    if (!work) return;
    this.future.push(workOf(this.state));
    this.gesture = null;
    this.replace(work, false);
  }

  redo(): void {
    const work = this.future.pop();
    if (!work) return;
    this.past.push(workOf(this.state));
    this.gesture = null;
    this.replace(work, false);
  }

  /** Start on another model; nothing of the old one can be undone. */
  open(model: Model, source: Source | null, saved: Model = model): void {
    this.past = [];
    this.future = [];
    this.gesture = null;
    this.set({
      model, saved, source, patch: 0, selected: null, pins: [], hover: null, kept: [], compare: "off", canUndo: false, canRedo: false,
      moving: false, joining: null, message: null, aims: NO_AIMS, beside: null, lights: [], opened: ++this.openings,
    });
  }

  private remember(): void {
    this.past.push(workOf(this.state));
    if (this.past.length > 500) this.past.shift();
  }

  private replace(work: Work, moving: boolean): void {
    const patch = Math.min(this.state.patch, work.model.patches.length - 1);
    this.set({ ...work, patch, moving, canUndo: this.past.length > 0, canRedo: this.future.length > 0 });
  }
}

const workOf = ({ model, saved, source, opened }: State): Work => ({ model, saved, source, opened });

export const PRESETS: readonly Model[] = (data.presets as unknown[]).map(fromDict);

/** The four sets of shape parameters of the thesis for a patch on its basis; none for other patches. */
export const shapeSets = (patch: Patch): readonly (readonly number[])[] =>
  (isStandard(patch) ? (data.shapeSets as Record<string, number[][]>)[String(shapeOf(patch).length)] : undefined) ?? [];

/** A starter model of a kind. */
export const starterOf = (kind: string): Model => fromDict(STARTERS[kind]);

export const activePatch = (state: State): Patch => state.model.patches[state.patch]!;
