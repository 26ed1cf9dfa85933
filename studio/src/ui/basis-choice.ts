/** Which basis each direction of a patch, or a curve, is built on: from the library, or the model's own. */

import { activePatch, type Store } from "../app/state";
import { choicesOf, isClassical, shapeParameters, valuesFor, type Choice } from "../numerics/chosen";
import { LIBRARY, ownBases, type Entry } from "../numerics/library";
import { KINDS, valueOf, type Patch } from "../numerics/model";
import { choice } from "./controls";
import { h } from "./dom";

export class BasisChoice {
  readonly element = h("div", { class: "stack bases" });
  private shown = "";

  constructor(private readonly store: Store) {}

  refresh(patch: Patch): void {
    const choices = choicesIn(patch), own = ownIn(patch);
    const form = JSON.stringify([choices.map(({ entry, points }) => [entry.name, points]), Object.values(own).map(({ name, sizes }) => [name, sizes]), patch.kind]);
    if (form === this.shown) return;
    const held = (this.element.getRootNode() as Document | ShadowRoot).activeElement, at = [...this.element.querySelectorAll("select")].indexOf(held as HTMLSelectElement);
    this.shown = form;
    this.element.replaceChildren(...choices.map((one, i) => this.row(patch, choices, one, i, Object.values(own))));
    if (at >= 0) this.element.querySelectorAll("select")[at]?.focus();
  }

  private row(patch: Patch, choices: readonly Choice[], { entry, points }: Choice, i: number, own: readonly Entry[]): HTMLElement {
    const name = choices.length < 2 ? "Basis" : patch.kind === "ruled" ? `Basis of the ${["first", "second"][i]!} curve` : `Basis in ${"uv"[i]!}`;
    const fits = (one: Entry) => one.has(points);
    // The quintic basis stands once, under the name that a model has unless it says another.
    const library = Object.values(LIBRARY).filter((one) => fits(one) && (one.name !== "quintic" || entry.name === "quintic") && (one.name !== "trigonometric" || entry.name !== "quintic"));
    const options = (list: readonly Entry[]) => list.map(({ name: value, title }) => ({ value, label: title }));
    const control = choice(name, [{ label: "Of this model", options: options(own.filter(fits)) }, { label: `For ${points} points`, options: options(library) }].filter((group) => group.options.length), (to) => this.choose(i, to));
    control.update(entry.name);
    const short = choices.length < 2 ? "Basis" : patch.kind === "ruled" ? ["Basis of first", "Basis of second"][i]! : name;
    return h("label", { class: "row basis" }, h("span", { class: "caption" }, short), control.element);
  }

  private choose(i: number, to: string): void {
    const patch = activePatch(this.store.state), names = choicesIn(patch).map(({ entry }, k) => (k === i ? to : entry.name));
    this.store.editPatch(withBasis(patch, names));
  }
}

/** The patch on other bases; its shape parameters stay where they are still the same ones. */
export function withBasis(patch: Patch, names: readonly string[], bases = patch["bases"]): Patch {
  const { shape, bases: _, basis: __, ...rest } = patch;
  const same = names.every((name) => name === names[0]), basis = same ? names[0]! : names;
  const bare: Patch = { ...rest, kind: patch.kind, name: patch.name, basis, ...(bases === undefined ? {} : { bases }) };
  const kept: Patch = { ...bare, shape }, labels = (one: Patch) => String(shapeParameters(one).map((p) => p.label));
  const alike = labels(kept) === labels(patch) || isClassical(kept) || isClassical(patch);
  try {
    if (shape === undefined || !alike) return bare;
    valuesFor(kept, choicesOf(kept));
    return kept;
  } catch {
    return bare;
  }
}

/** The bases of a patch; none where they are not right. */
export function choicesIn(patch: Patch): readonly Choice[] {
  try {
    return KINDS[patch.kind]!.fields["basis"] ? choicesOf(patch) : [];
  } catch {
    return [];
  }
}

function ownIn(patch: Patch): Readonly<Record<string, Entry>> {
  try {
    return ownBases(valueOf(patch, "bases"));
  } catch {
    return {};
  }
}
