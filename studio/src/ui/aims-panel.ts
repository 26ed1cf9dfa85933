/** The part of the right panel on what the model is measured against: target, deviation, demands with lights, fairing. */

import type { Aims, Light } from "../app/aims";
import type { LiveHost } from "../app/host";
import { activePatch, type State, type Store } from "../app/state";
import { button, numberField, section, toggle } from "./controls";
import { h } from "./dom";
import { percent, short } from "./format";
import { distanceColours } from "../view/target";

const EXAMPLE = "gaussian >= 0\ncurvature_radius >= 30\ndeviation <= 0.5";

export class AimsPanel {
  readonly element: HTMLDetailsElement;
  private readonly files = h("select", { "aria-label": "Target beside the model" });
  private readonly align = toggle("Align first", (align) => this.aim({ align }), undefined, "Move the target onto the model as a rigid body before it is measured");
  private readonly tolerance = numberField({ label: "±", name: "Tolerance of the deviation", positive: true, onChange: (tolerance) => this.aim({ tolerance }) });
  private readonly told = h("p", { class: "hint", role: "status" });
  private readonly key = h("div", { class: "distance-key", "aria-hidden": "true" });
  private readonly demands = h("textarea", { rows: 4, spellcheck: "false", placeholder: EXAMPLE, "aria-label": "Demands, one a line" });
  private readonly lights = h("ul", { class: "lights", "aria-label": "What comes of the demands" });
  private readonly one: HTMLButtonElement;

  constructor(private readonly store: Store, private readonly host: LiveHost) {
    this.files.addEventListener("change", () => this.aim({ target: this.files.value }));
    this.files.addEventListener("pointerdown", () => void this.look());
    this.demands.addEventListener("input", () => this.aim({ demands: this.demands.value }));
    this.key.style.background = `linear-gradient(90deg, ${distanceColours.join(", ")})`;
    this.one = button("Fair this point", "Fair this point: move the chosen control point to where the surface has the least thin-plate energy", () => void this.fair(this.store.state.selected?.replace("′", "") ?? ""));
    const all = button("Fair all", "Fair all: the patch of least thin-plate energy between its sides, which stay", () => void this.fair(""));
    this.element = section("Target and demands", false,
      h("label", { class: "row" }, h("span", { class: "caption" }, "Target"), this.files),
      this.align.element, this.tolerance.element, this.key, this.told,
      h("span", { class: "caption" }, "Demands"), this.demands, this.lights,
      h("div", { class: "row" }, this.one, all));
    void this.look();
  }

  refresh(state: State): void {
    const { aims, beside, lights } = state;
    this.files.value = aims.target;
    this.align.update(aims.align);
    this.tolerance.update(aims.tolerance ?? NaN);
    this.tolerance.element.querySelector("input")!.disabled = false;
    for (const one of [this.align.element, this.tolerance.element]) one.hidden = !aims.target;
    this.told.hidden = this.key.hidden = !beside;
    if (beside) {
      const unit = beside.unit && ` ${beside.unit}`, of = beside.points < beside.count ? `${grouped(beside.points)} of ${grouped(beside.count)}` : grouped(beside.count);
      const within = beside.within === null ? "" : ` ${percent(beside.within)} are within the tolerance.`;
      const edge = beside.edge ? ` ${grouped(beside.edge)} lie beyond the border.` : "";
      this.told.textContent = `${of} points: rms ${short(beside.rms, 3)}${unit}, from ${short(beside.min, 3)} to ${short(beside.max, 3)}${unit}.${within}${edge}`;
      this.key.title = `from ${short(-beside.reach, 3)} to ${short(beside.reach, 3)}${unit}, red on the side of the normal`;
    }
    if (this.demands.value !== aims.demands) this.demands.value = aims.demands;
    this.lights.replaceChildren(...lights.map(light));
    this.one.disabled = !state.selected;
  }

  private aim(change: Partial<Aims>): void {
    this.store.set({ aims: { ...this.store.state.aims, ...change } });
  }

  /** Ask the server which files there are. */
  private async look(): Promise<void> {
    const names = await this.host.targets().catch(() => []), shown = [...this.files.options].slice(1).map((option) => option.value);
    if (this.files.options.length && String(names) === String(shown)) return;
    this.files.replaceChildren(h("option", { value: "" }, names.length ? "none" : "none in the folder"), ...names.map((name) => h("option", { value: name }, name)));
    this.files.value = this.store.state.aims.target;
  }

  private async fair(only: string): Promise<void> {
    const { state } = this.store, { model, patch } = state;
    try {
      const found = await this.host.fairer(model, activePatch(state).name, only);
      if (this.store.state.model !== model) return; // changed meanwhile
      this.store.editPatch(found.model.patches[patch]!);
      const text = found.notes[0] ?? `Thin-plate energy from ${short(found.before)} to ${short(found.after)}${model.unit && ` ${model.unit}²`}`;
      this.store.set({ message: { kind: "note", text } });
    } catch (error) {
      this.store.set({ message: { kind: "error", text: (error as Error).message } });
    }
  }
}

const grouped = (count: number): string => count.toLocaleString("en");

/** One demand with its light: green where it is met. */
function light({ demand, met, worst, unit, u, v, error }: Light): HTMLElement {
  const state = error ? "none" : met ? "met" : "missed", word = { met: "met", missed: "not met", none: "no demand" }[state];
  const place = u === null || u === undefined || v === null || v === undefined ? "" : ` at (${short(u, 3)}, ${short(v, 3)})`;
  const value = worst === null || worst === undefined ? "" : `${short(worst)}${unit ? ` ${unit}` : ""}${place}`;
  return h("li", { class: state }, h("span", { class: "light", role: "img", "aria-label": word }), h("span", {}, demand), h("small", {}, error ? error.replace(/^demands: /, "") : value));
}
