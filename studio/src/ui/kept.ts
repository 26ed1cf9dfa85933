/** Over the picture of a kept variant: what differs, and buttons to restore, rename and delete it. */

import { differences } from "../app/differences";
import type { State, Store } from "../app/state";
import { button } from "./controls";
import { ask } from "./dialogs";
import { h } from "./dom";

const MOST = 5, TOLD = 2;

/** Keep the model as it is now and show what is kept. */
export function keep(store: Store): void {
  const { model, kept } = store.state;
  if (kept.length >= MOST) return store.set({ compare: "kept", message: { kind: "note", text: `${MOST} are kept already: delete one first` } });
  const taken = new Set(kept.map((one) => one.label)), number = Array.from({ length: MOST + 1 }, (_, i) => i + 1).find((i) => !taken.has(`kept ${i}`))!;
  store.set({ kept: [...kept, { label: `kept ${number}`, model }], compare: "kept" });
}

/** What differs between a kept variant and the model now. */
export function told(state: State, index: number): string {
  const found = differences(state.kept[index]!.model, state.model);
  return found.length ? `now: ${found.slice(0, TOLD).join("; ")}${found.length > TOLD ? `; ${found.length - TOLD} more` : ""}` : "same as now";
}

/** The tools of a kept variant. */
export function tools(store: Store, index: number): HTMLElement {
  const { label, model } = store.state.kept[index]!, all = differences(model, store.state.model).join("\n");
  const at = () => store.state.kept.findIndex((one) => one.model === model && one.label === label);
  const put = (change: (kept: State["kept"][number]) => State["kept"]) =>
    store.set({ kept: store.state.kept.flatMap((one, i) => (i === at() ? change(one) : [one])) });
  const element: HTMLElement = h("div", { class: "kept" }, h("div", { class: "kept-tools" },
    button("Restore", `Restore ${label}`, () => store.edit(model), "button"),
    button("Rename", `Rename ${label}`, () => void renamed(element.closest<HTMLElement>(".studio")!, label).then((name) => name && put((one) => [{ ...one, label: name }])), "button"),
    button("Delete", `Delete ${label}`, () => {
      put(() => []);
      if (!store.state.kept.length) store.set({ compare: "off" });
    }, "button")), h("div", { class: "differs", title: all || false }, told(store.state, index)));
  return element;
}

async function renamed(root: HTMLElement, label: string): Promise<string> {
  const field = h("input", { type: "text", value: label, maxlength: 60, "aria-label": "Name of the variant" });
  const answer = await ask(root, "Rename", [h("label", { class: "field wide" }, h("span", {}, "Name"), field)], [["rename", "Rename"], ["cancel", "Cancel"]]);
  return answer === "rename" ? field.value.trim() : "";
}
