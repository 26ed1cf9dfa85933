/** Several patches as one body: their list's tools, the seams of the active patch in numbers, and joining by clicking two sides. */

import { activePatch, starterOf, type State, type Store } from "../app/state";
import { joined, leftToPython, type Rule } from "../edit/follow";
import { added, mirrored, removed, withJoins } from "../edit/patches";
import { isCurve } from "../numerics/curve";
import type { Model } from "../numerics/model";
import type { Seam } from "../numerics/seams";
import { lineColour } from "../view/overlays";
import { button, choice, toggle } from "./controls";
import { h } from "./dom";
import { short } from "./format";

const ALL = 5e-3; // of a side at its ends: less than that missing is not told
const JOINS = ["G0", "G1", "G2", "G3"];

export class BodyPanel {
  readonly element = h("section", { class: "body-tools stack", "aria-label": "Patches and seams" });
  private readonly seams = h("ul", { class: "seams", "aria-label": "Seams of this patch" });
  private readonly later = h("p", { class: "hint later" });
  private readonly hint = h("p", { class: "hint", role: "status" });
  private readonly joining = toggle("Join or release", (joining) => this.store.set({ joining: joining ? { order: this.order, first: null } : null }), undefined, "Click a side of one patch, then a side of another: the second follows the first from then on. Sides that are joined are released.");
  private readonly together = toggle("Shared points move together", (together) => this.store.setting({ together }), undefined, "Points that patches have in common, and sides held by a join, follow what is dragged");
  private readonly row = h("div", { class: "row" });
  private order = "G1";

  constructor(private readonly store: Store) {
    const order = choice("Order of joins", [{ label: "", options: JOINS.map((value) => ({ value, label: value })) }], (value) => {
      this.order = value;
      if (store.state.joining) store.set({ joining: { ...store.state.joining, order: value } });
    });
    order.update(this.order);
    this.row.append(this.joining.element, order.element);
    const put = (model: Model, patch: number) => {
      store.edit(model);
      store.set({ patch: Math.min(patch, model.patches.length - 1), selected: null });
    };
    const more = (patch: Parameters<typeof added>[1]) => put(added(store.state.model, patch), store.state.model.patches.length);
    const mirror = (axis: 0 | 1 | 2) => {
      const image = mirrored(activePatch(store.state), axis);
      if (image) more(image);
      else store.set({ message: { kind: "error", text: "This patch has no points to mirror: make it a tensor-product surface first" } });
    };
    this.element.append(
      h("div", { class: "row", role: "group", "aria-label": "Patches of the model" },
        button("Add", "Add a new patch of this construction", () => more(starterOf(activePatch(store.state).kind).patches[0]!)),
        button("Duplicate", "Duplicate this patch", () => more(activePatch(store.state))),
        ...(["x", "y", "z"] as const).map((name, axis) => button(`Mirror ${name}`, `Mirror ${name}: add the image of this patch across ${name} = 0`, () => mirror(axis as 0 | 1 | 2))),
        button("Delete", "Delete this patch, and its joins", () => put(removed(store.state.model, store.state.patch), store.state.patch))),
      this.row, this.together.element, this.hint, this.later, this.seams);
  }

  refresh(state: State, all: readonly Seam[], dark: boolean): void {
    const many = state.model.patches.length > 1;
    this.element.hidden = state.model.patches.every(isCurve);
    for (const one of [this.row, this.together.element, this.hint, this.seams]) one.hidden = !many;
    this.joining.update(state.joining !== null);
    this.together.update(state.settings.together);
    this.hint.textContent = !state.joining ? "" : state.joining.first ? `${state.joining.first}: now click a side of another patch` : "Click near a side of the patch that leads";
    this.hint.hidden = !many || !state.joining;
    const later = leftToPython(state.model).map((rule) => rule.second);
    this.later.textContent = later.length ? `Not moved here, but by Python when the model is saved or read: ${later.join(", ")}` : "";
    this.later.hidden = !later.length;
    const { patches, unit } = state.model, end = (of: Seam["first"]) => `${patches[of.patch]!.name}:${of.side}${of.from > ALL || of.to < 1 - ALL ? ` [${short(of.from, 3)}, ${short(of.to, 3)}]` : ""}`;
    const own = all.filter((seam) => seam.first.patch === state.patch || seam.second.patch === state.patch);
    this.seams.replaceChildren(...own.map((seam) => {
      const swatch = h("b", { class: "order" }, seam.order);
      swatch.style.color = lineColour(`seam ${seam.order}`, dark);
      return h("li", {}, swatch, h("span", {}, `${end(seam.first)} – ${end(seam.second)}`),
        h("small", {}, `gap ${short(seam.gap, 3)}${unit && ` ${unit}`} · angle ${short(seam.angle, 3)}° · jump ${short(seam.curvature, 3)}`));
    }));
  }
}

/** A side was clicked while joining: the first is kept; with the second the two are joined, or released if they were. */
export function clickSide(store: Store, side: string): void {
  const { joining, model } = store.state;
  if (!joining) return;
  const { first, order } = joining, name = (end: string) => end.slice(0, end.lastIndexOf(":"));
  if (!first) return store.set({ joining: { ...joining, first: side } });
  store.set({ joining: { order, first: null } });
  const rules = (model.join ?? []) as readonly Rule[], fail = (text: string) => store.set({ message: { kind: "error", text } });
  const known = rules.filter((rule) => (rule.first === first && rule.second === side) || (rule.first === side && rule.second === first));
  if (known.length) return store.edit(withJoins(model, rules.filter((rule) => !known.includes(rule))));
  if (name(first) === name(side)) return fail("A patch is not joined to itself: click sides of two patches");
  if (rules.some((rule) => rule.second === side)) return fail(`${side} follows another side already: release that first`);
  const leads = (from: string): boolean => from === name(first) || rules.some((rule) => name(rule.first) === from && leads(name(rule.second)));
  if (leads(name(side))) return fail(`${name(first)} follows ${name(side)} already: joins cannot run in a circle`);
  const rule = { first, second: side, order };
  store.edit(joined(model, rule) ?? { ...model, join: [...rules, rule] });
}
