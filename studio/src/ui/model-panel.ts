/** The left panel: patches, construction, and the control points as numbers. */

import { activePatch, starterOf, type State, type Store } from "../app/state";
import { converted } from "../edit/convert";
import { handlesOf, moved, replaced, type Handle } from "../edit/handles";
import { curveOf, isCurve } from "../numerics/curve";
import { KINDS, UNITS, valueOf, type Kind, type Patch } from "../numerics/model";
import { BodyPanel } from "./body-panel";
import { BasisChoice } from "./basis-choice";
import { choice, numberField, section, segmented, toggle, type Control } from "./controls";
import { ask } from "./dialogs";
import { h } from "./dom";
import { capital } from "./format";
import { ModelText } from "./model-text";

export class ModelPanel {
  readonly element = h("aside", { class: "panel left", "aria-label": "Model" });
  private readonly patches = h("div", { class: "patches", role: "listbox", "aria-label": "Patches" });
  readonly body: BodyPanel;
  private readonly kind: Control<string>;
  private readonly unit: Control<string>;
  private readonly flip: Control<boolean>;
  private readonly basis: BasisChoice;
  private readonly text: ModelText;
  private readonly close: Control<boolean>;
  private readonly about = h("p", { class: "hint" });
  private readonly points = h("div", { class: "points" });
  private readonly locks: Control<boolean>[];
  private readonly snap: Control<boolean>;
  private readonly step: Control<number>;
  private names = "";
  private list: Handle[] = [];
  private shownPatch: Patch | null = null;
  private tab = "";
  private coordinates: Control<number>[] = [];
  private form: { readonly patch: Patch; readonly chosen: string | undefined; readonly tab: string } | null = null;

  constructor(private readonly store: Store) {
    const groups = [
      { label: "Constructions", options: kinds((kind) => kind.construction && kind.surface) },
      { label: "Curves", options: kinds((kind) => !kind.surface) },
      { label: "Closed forms", options: kinds((kind) => !kind.construction && !kind.fields["points"]) },
      { label: "From CAD", options: kinds((kind) => !kind.construction && !!kind.fields["points"]) },
    ];
    this.kind = choice("Construction", groups, (kind) => void this.become(kind));
    this.unit = choice("Unit of length", [{ label: "", options: [{ value: "", label: "no unit" }, ...UNITS.map((u) => ({ value: u, label: u }))] }], (unit) => store.edit({ ...store.state.model, unit }));
    this.flip = toggle("Turn the normal", (flip) => store.editPatch({ ...activePatch(store.state), flip }), undefined, "The signs of H, κ1, κ2 and S follow the normal");
    this.close = toggle("End in the first point", (close) => this.closed(close), undefined, "A closed curve: the first control point counts once more, as the last");
    this.basis = new BasisChoice(store);
    this.text = new ModelText(store);
    this.body = new BodyPanel(store);
    this.locks = ["x", "y", "z"].map((axis, i) => toggle(axis, (on) => {
      const locks = [...store.state.settings.locks] as [boolean, boolean, boolean];
      locks[i] = on;
      store.setting({ locks });
    }, undefined, `Keep ${axis} while dragging`));
    this.snap = toggle("Snap to", (snap) => store.setting({ snap }), undefined, "Round coordinates while dragging");
    this.step = numberField({ label: "", name: "Snap step", positive: true, onChange: (snapStep) => store.setting({ snapStep }) });
    this.element.append(
      this.patches, this.body.element,
      h("div", { class: "stack" },
        h("label", { class: "row" }, h("span", { class: "caption" }, "Construction"), this.kind.element),
        this.about,
        h("label", { class: "row" }, h("span", { class: "caption" }, "Unit"), this.unit.element),
        this.basis.element, this.flip.element, this.close.element),
      section("Control points", true, this.points,
        h("div", { class: "drag-tools" },
          h("div", { class: "locks", role: "group", "aria-label": "Axes kept while dragging" }, h("span", { class: "caption" }, "Keep"), ...this.locks.map((l) => l.element)),
          h("div", { class: "snap" }, this.snap.element, this.step.element))),
      this.text.element,
    );
    store.subscribe((now, before) => {
      if (now.model !== before.model || now.patch !== before.patch || now.selected !== before.selected || now.settings !== before.settings) this.refresh(now);
    });
  }

  refresh(state: State): void {
    const patch = activePatch(state), kind = KINDS[patch.kind]!;
    this.kind.update(patch.kind);
    this.unit.update(state.model.unit);
    this.flip.update(valueOf(patch, "flip") === true);
    this.flip.element.hidden = !kind.surface; // turning a curve about is of no use in a picture
    this.close.element.hidden = !kind.fields["close"];
    this.close.update(valueOf(patch, "close") === true);
    this.basis.refresh(patch);
    this.text.refresh(state);
    this.about.textContent = capital(kind.title);
    state.settings.locks.forEach((on, i) => this.locks[i]!.update(on));
    this.snap.update(state.settings.snap);
    this.step.update(state.settings.snapStep);
    this.patches.hidden = state.model.patches.length < 2;
    const names = JSON.stringify([state.patch, state.model.patches.map((p) => [p.name, p.kind])]);
    if (names !== this.names) this.patches.replaceChildren(...state.model.patches.map((p, i) =>
      h("button", { type: "button", class: "patch", role: "option", "aria-selected": i === state.patch, on: { click: () => this.store.set({ patch: i, selected: null }) } },
        h("span", {}, p.name), h("small", {}, p.kind.replaceAll("_", " ")))));
    this.names = names;
    this.showPoints(state, patch);
  }

  private showPoints(state: State, patch: Patch): void {
    if (patch !== this.shownPatch) {
      this.list = handlesOf(patch).filter((handle) => !handle.mirrored);
      this.shownPatch = patch;
    }
    const group = this.points.parentElement!.parentElement!;
    group.hidden = !this.list.length;
    if (!this.list.length) return;
    const chosen = this.list.find((handle) => handle.id === state.selected?.replace("′", ""));
    const keys = [...new Set(this.list.map((handle) => handle.key))];
    if (chosen) this.tab = chosen.key;
    if (!keys.includes(this.tab)) this.tab = keys[0]!;
    // Built anew only for another patch, point or tab, so that what is being typed stays.
    const form = { patch, chosen: chosen?.id, tab: this.tab };
    if (form.patch === this.form?.patch && form.chosen === this.form.chosen && form.tab === this.form.tab) return;
    this.form = form;
    const tabs = segmented("Which points", keys.map((key) => ({ value: key, label: capital(key) })), (key) => {
      this.tab = key;
      this.store.set({ selected: null });
      this.showPoints(this.store.state, patch);
    });
    tabs.update(this.tab);
    const shown = this.list.filter((handle) => handle.key === this.tab);
    const columns = Math.max(...shown.map((handle) => handle.index.at(-1)!)) + 1;
    const grid = h("div", { class: "net", role: "group", "aria-label": `${capital(this.tab)}: choose one` },
      ...shown.map((handle, at) => h("button", {
        type: "button", class: "knob", title: handle.label, "aria-label": handle.label, "aria-pressed": handle === chosen,
        tabindex: handle === chosen || (!chosen && at === 0) ? 0 : -1,
        on: { click: () => this.store.set({ selected: handle === chosen ? null : handle.id }) },
      }, handle.index.length > 1 ? "" : handle.index[0]!)));
    grid.style.setProperty("--columns", String(columns));
    grid.addEventListener("keydown", (event) => this.walk(event, shown, columns));
    const focused = (this.points.getRootNode() as Document | ShadowRoot).activeElement;
    const inGrid = focused?.classList.contains("knob") ?? false;
    const fieldAt = this.coordinates.findIndex((c) => c.element.contains(focused));
    this.coordinates = chosen ? this.fields(chosen) : [];
    this.points.replaceChildren(
      keys.length > 1 ? tabs.element : "", grid,
      chosen ? h("div", { class: "coordinates" }, h("span", { class: "caption" }, chosen.label), ...this.coordinates.map((c) => c.element))
        : h("p", { class: "hint" }, `${shown.length} points: choose one here, or drag one in the picture`));
    if (inGrid) grid.querySelector<HTMLElement>('[tabindex="0"]')?.focus();
    if (fieldAt >= 0) this.coordinates[fieldAt]?.element.querySelector("input")?.focus();
  }

  private fields(handle: Handle): Control<number>[] {
    const patch = activePatch(this.store.state);
    let stored: unknown = valueOf(patch, handle.key);
    for (const i of handle.index) stored = (stored as unknown[])[i];
    const values = stored as number[];
    const names = isCurve(patch) ? ["x", "y", "z"] : handle.along ? ["a", "b", "c", "d"] : patch.kind === "swung" ? (handle.key === "profile" ? ["r", "z"] : ["x", "y"]) : ["x", "y", "z"];
    return values.map((value, i) => {
      const field = numberField({
        label: h("i", { class: "math" }, names[i]!), name: `${handle.label} ${names[i]!}`,
        onChange: (to) => this.store.editPatch(replaced(activePatch(this.store.state), handle.key, handle.index, values.map((x, k) => (k === i ? to : x)))),
      });
      field.update(value);
      return field;
    });
  }

  private walk(event: KeyboardEvent, shown: readonly Handle[], columns: number): void {
    const step = { ArrowRight: 1, ArrowLeft: -1, ArrowDown: columns, ArrowUp: -columns }[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    const at = shown.findIndex((handle) => handle.id === this.store.state.selected);
    const next = shown[Math.min(shown.length - 1, Math.max(0, at + step))]!;
    this.store.set({ selected: next.id });
  }

  /** Let a curve end in its first point, or not; where its basis has no functions for so many points, that is told. */
  private closed(close: boolean): void {
    const { store } = this, patch = activePatch(store.state), points = valueOf(patch, "points") as number[][];
    const [first, last] = [points[0]!, points.at(-1)!], meets = first.every((x, i) => x === last[i]);
    // The number of points stays that of the basis: the last one goes, or comes back.
    const next = { ...patch, close, points: close ? points.slice(0, -1) : meets ? points : [...points, first] };
    try {
      curveOf(next);
      store.editPatch(next);
    } catch (error) {
      store.set({ message: { kind: "error", text: (error as Error).message } });
      this.close.update(!close);
    }
  }

  /** Make the patch another construction: the same surface where that can hold it, else its starter, when that is wanted. */
  private async become(kind: string): Promise<void> {
    const { store } = this, patch = activePatch(store.state), { patch: at, opened } = store.state;
    let next = converted(patch, kind);
    if (!next) {
      const root = this.element.closest<HTMLElement>(".studio")!;
      const answer = await ask(root, "Another surface?", [h("p", {}, `“${patch.name}” cannot be kept exactly as “${spoken(kind)}”: a new surface to start from would take its place.`)], [["stay", "Keep it"], ["replace", "Start anew"]]);
      if (answer === "replace") next = { ...starterOf(kind).patches[0]!, name: patch.name };
    }
    const same = store.state.patch === at && store.state.opened === opened && activePatch(store.state) === patch;
    if (!next || !same) return this.kind.update(activePatch(store.state).kind);
    store.set({ selected: null });
    store.editPatch(next);
  }
}

/** Move the selected handle by a step in each coordinate. */
export function nudge(store: Store, by: readonly number[]): void {
  const patch = activePatch(store.state);
  const handle = handlesOf(patch).find((one) => one.id === store.state.selected);
  if (handle) store.editPatch(moved(patch, handle, handle.position.map((x, i) => x + by[i]!)), `nudge ${handle.id}`);
}

const kinds = (test: (kind: Kind) => boolean) =>
  Object.entries(KINDS).filter(([, kind]) => test(kind))
    .map(([value]) => ({ value, label: capital(spoken(value)) }));

const spoken = (kind: string): string => (kind === "nurbs" ? "NURBS" : kind.replaceAll("_", " "));
