/** The model as text: its own bases, or the whole file, edited in the page; what is wrong is told in one line. */

import { activePatch, type State, type Store } from "../app/state";
import { fromDict, KINDS, toDict, type Model, type Patch } from "../numerics/model";
import { fromToml, toToml, written } from "../toml";
import { choicesIn, withBasis } from "./basis-choice";
import { button, section, segmented } from "./controls";
import { h } from "./dom";

type Part = "bases" | "file";

const PAUSE = 120; // ms after a letter

export class ModelText {
  readonly element: HTMLDetailsElement;
  private readonly text = h("textarea", { spellcheck: "false", autocapitalize: "off", rows: 14, "aria-label": "The model as text" });
  private readonly wrong = h("p", { class: "hint error", role: "alert", hidden: true });
  private readonly copy: HTMLButtonElement;
  private readonly hint = h("p", { class: "hint" });
  private part: Part = "file";
  private shown: Model | null = null;
  private shownPatch = -1;
  private timer = 0;

  constructor(private readonly store: Store) {
    const parts = segmented<Part>("Which text", [
      { value: "file", label: "Whole file", title: "The model as a TOML file" },
      { value: "bases", label: "Own bases", title: "The [bases.NAME] tables: functions as formulas, parameters with ranges" },
    ], (part) => {
      this.part = part;
      parts.update(part);
      this.write();
    });
    parts.update(this.part);
    this.copy = button("Copy the basis to a basis of your own", "Copy the formulas of the basis into the model, to change them", () => this.own(), "button");
    this.element = section("Model as text", false, parts.element, this.wrong, this.text, this.copy, this.hint);
    this.element.classList.add("model-text");
    this.element.addEventListener("toggle", () => this.refresh(store.state));
    this.text.addEventListener("input", () => {
      clearTimeout(this.timer);
      this.timer = window.setTimeout(() => this.read(), PAUSE);
    });
    this.text.addEventListener("blur", () => {
      if (this.timer) this.read();
      store.settle();
    });
    this.text.addEventListener("keydown", (event) => {
      event.stopPropagation(); // its keys are its own
      if (event.key === "Escape") this.write();
    });
  }

  refresh({ model, patch }: State): void {
    if (!this.element.open || (model === this.shown && patch === this.shownPatch)) return;
    // What is being typed stays, be it wrong.
    if ((this.text.getRootNode() as Document | ShadowRoot).activeElement === this.text) this.shown = model;
    else this.write();
  }

  /** Show the text of the model as it is. */
  private write(): void {
    const { state } = this.store, { model } = state, bases = activePatch(state)["bases"];
    clearTimeout(this.timer);
    this.timer = 0;
    this.shown = model;
    this.shownPatch = state.patch;
    this.text.value = this.part === "file" ? toToml(model) : bases ? written({ bases }).trimStart() : "";
    this.text.setAttribute("aria-label", this.part === "file" ? "The model file" : "The model's own bases");
    this.wrong.hidden = true;
    const based = KINDS[activePatch(state).kind]!.fields["bases"] !== undefined;
    this.copy.hidden = this.part === "file" || !based || Boolean(bases);
    this.text.disabled = this.part === "bases" && !based;
    this.hint.textContent = this.part === "file" ? "" : !based ? "A surface of this kind has no basis." : "In formulas stand t, r = 1 − t, s = sin(πt/2), c = cos(πt/2), a = 1 − s, b = 1 − c, pi, the parameters, + − * / ^, and sin, cos, sinh, cosh, sqrt, exp.";
  }

  private read(): void {
    clearTimeout(this.timer);
    this.timer = 0;
    try {
      const next = this.part === "file" ? fromDict(fromToml(this.text.value)) : this.withBases(fromToml(this.text.value));
      this.wrong.hidden = true;
      this.shown = next;
      this.store.edit(next, "text");
    } catch (error) {
      this.wrong.hidden = false;
      this.wrong.textContent = (error as Error).message;
    }
  }

  /** The model with other bases of its own, for the active patch and all that share its bases. */
  private withBases({ bases = {}, ...others }: Record<string, unknown>): Model {
    const { model, patch: at } = this.store.state, key = Object.keys(others)[0];
    if (key) throw new Error(`unknown key '${key}': expected [bases.NAME] tables alone`);
    const before = JSON.stringify(model.patches[at]!["bases"]);
    const patches = model.patches.map((patch, i) => (i === at || (before && JSON.stringify(patch["bases"]) === before) ? based(patch, bases) : patch));
    return fromDict(toDict({ ...model, patches }));
  }

  /** Copy the basis of the active patch into the model, and build the patch on the copy. */
  private own(): void {
    const patch = activePatch(this.store.state), bases: Record<string, unknown> = {};
    const names = choicesIn(patch).map(({ entry, points }, _, all) => {
      const name = all.some((one) => one.entry === entry && one.points !== points) ? `my_${entry.name}_${points}` : `my_${entry.name}`;
      const { functions, parameters } = entry.basis(points), width = (low: number, high: number) => 1e-3 * (high - low);
      const ranges = parameters.map(({ name: one, low, high, start, open }) => [one, [low + width(low, high) * Number(open[0]), high - width(low, high) * Number(open[1]), start]]);
      bases[name] = { functions, ...(ranges.length ? { parameters: Object.fromEntries(ranges) as unknown } : {}) };
      return name;
    });
    if (!names.length) return;
    this.store.editPatch(withBasis(patch, names, bases));
    this.write();
  }
}

/** A patch with other bases of its own; without the shape parameters that they no longer have. */
function based(patch: Patch, bases: unknown): Patch {
  const basis = patch["basis"] ?? [], names = [basis].flat() as string[];
  const { bases: _, ...rest } = patch, next = Object.keys(bases as object).length ? { ...rest, kind: patch.kind, name: patch.name, bases } : { ...rest, kind: patch.kind, name: patch.name };
  return names.length && patch["shape"] !== undefined ? withBasis(next, names, next["bases" as keyof typeof next]) : next;
}
