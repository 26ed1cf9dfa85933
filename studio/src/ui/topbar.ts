/** The bar at the top: model name, files, undo, comparison, picture, export, theme. */

import type { Files } from "../app/files";
import { PRESETS, starterOf, type Compare, type State, type Store } from "../app/state";
import { KINDS } from "../numerics/model";
import { button, isTyping, menu, segmented, typing, type Control, type Item } from "./controls";
import { h, icon, ICONS } from "./dom";
import { capital } from "./format";
import { keep } from "./kept";

export class TopBar {
  readonly element: HTMLElement;
  private readonly name: HTMLInputElement;
  private readonly dirty = h("span", { class: "dirty", title: "Not saved" });
  private readonly undo: HTMLButtonElement;
  private readonly redo: HTMLButtonElement;
  private readonly compare: Control<Compare>;

  constructor(store: Store, files: Files, theme: () => void, help: () => void, panel: () => void, embedded: boolean) {
    this.name = h("input", { class: "name", "aria-label": "Name of the model", spellcheck: "false", maxlength: 200 });
    typing(this.name, () => void (this.name.value = store.state.model.name));
    this.name.addEventListener("change", () => {
      const name = this.name.value.trim();
      if (!name) return void (this.name.value = store.state.model.name);
      const { model } = store.state;
      const patches = model.patches.length === 1 ? [{ ...model.patches[0]!, name }] : model.patches;
      store.edit({ ...model, name, patches });
    });
    this.undo = button(icon(ICONS.undo), "Undo (Ctrl Z)", () => store.undo(), "button square");
    this.redo = button(icon(ICONS.redo), "Redo (Ctrl Shift Z)", () => store.redo(), "button square");
    const models = (): (Item | string)[] => [
      "Presets", ...PRESETS.map((model) => ({ label: model.name, hint: model.patches[0]!.kind.replaceAll("_", " "), act: () => void files.start(model) })),
      "Starters", ...Object.entries(KINDS).filter(([, kind]) => kind.construction).map(([kind, { title }]) => ({ label: capital(kind), hint: title, act: () => void files.start(starterOf(kind)) })),
    ];
    this.compare = segmented<Compare>("Compare", [
      { value: "off", label: "One", title: "The model alone" },
      { value: "before", label: "Before | now", title: "As last saved or opened, beside the model now" },
      { value: "sets", label: "Four sets", title: "The four sets of shape parameters of the thesis, on one scale" },
      { value: "kept", label: "Kept", title: "The model beside those you kept" },
    ], (compare) => (compare === "kept" && !store.state.kept.length ? keep(store) : store.set({ compare })));
    const keeper = button("Keep", "Keep the model as it is now, to compare with", () => keep(store), "button quiet");
    this.element = h("header", { class: "bar" },
      embedded ? null : h("span", { class: "brand", title: "quintrig" }, mark(), h("span", {}, "quintrig")),
      button(icon(ICONS.side), "Construction and control points", panel, "button square drawer"),
      this.name, this.dirty,
      h("div", { class: "group" },
        menu(h("span", {}, "Models", icon(ICONS.down)), "Models: presets and starters", models),
        menu(h("span", {}, icon(ICONS.open), h("span", { class: "word" }, "Open"), icon(ICONS.down)), "Open a model", () => files.openItems()),
        menu(h("span", {}, icon(ICONS.save), h("span", { class: "word" }, "Save"), icon(ICONS.down)), "Save the model", () => files.saveItems())),
      h("div", { class: "group tight" }, this.undo, this.redo),
      h("div", { class: "group tight" }, this.compare.element, keeper),
      h("span", { class: "spacer" }),
      h("div", { class: "group tight last" },
        button(icon(ICONS.picture), "Save a picture", () => void files.picture(), "button square"),
        menu(icon(ICONS.export), "Export", () => files.exportItems(), "button square", () => files.lookAtFormats()),
        button(icon(ICONS.sun), "Light or dark", theme, "button square theme"),
        button(icon(ICONS.help), "Keys and pointer (?)", help, "button square")));
  }

  refresh(state: State): void {
    if (!isTyping(this.name)) this.name.value = state.model.name;
    this.name.style.setProperty("--letters", String(Math.min(30, Math.max(6, this.name.value.length))));
    this.dirty.hidden = state.model === state.saved;
    this.undo.disabled = !state.canUndo;
    this.redo.disabled = !state.canRedo;
    this.compare.update(state.compare);
  }
}

/** The mark: a small curved patch. */
function mark(): SVGElement {
  const svg = icon("M2 11c3-6 9-1 12-7M2 11c2 3 5 3 6.5 2.2M14 4c.3 3-1.500 7.200-5.500 9.200M5.500 7.700c1 2.500 3 4 5.600 3.700M9.500 6.600c.7 1.900 1.900 3 3.400 3.100");
  svg.classList.add("mark-icon");
  return svg;
}
