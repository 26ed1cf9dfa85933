/** Dialogs: each resolves with what was chosen, or null. */

import { button, toggle } from "./controls";
import { h, type Child } from "./dom";

/** Show a dialog with these contents and buttons; resolves with the button's value, null for Escape. */
export function ask<T extends string>(root: HTMLElement, title: string, body: readonly Child[], buttons: readonly (readonly [T, string])[]): Promise<T | null> {
  return new Promise((done) => {
    const dialog = h("dialog", { "aria-label": title });
    const finish = (value: T | null) => {
      dialog.close();
      dialog.remove();
      done(value);
    };
    const form = h("form", { method: "dialog" },
      h("h2", {}, title), h("div", { class: "dialog-body" }, ...body),
      h("div", { class: "dialog-buttons" }, ...buttons.map(([value, label], i) => {
        const choice = button(label, label, () => finish(value), i === 0 ? "button primary" : "button");
        return choice;
      })));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      finish(buttons[0]?.[0] ?? null);
    });
    dialog.addEventListener("cancel", (event) => {
      event.preventDefault();
      finish(null);
    });
    dialog.addEventListener("keydown", (event) => event.stopPropagation());
    dialog.append(form);
    root.append(dialog);
    dialog.showModal();
    (form.querySelector<HTMLElement>("input") ?? form.querySelector<HTMLElement>(".primary"))?.focus();
  });
}

/** Ask for a file name. */
export async function askName(root: HTMLElement, title: string, name: string): Promise<string | null> {
  const field = h("input", { type: "text", value: name, "aria-label": "File name", spellcheck: "false" });
  const answer = await ask(root, title, [h("label", { class: "field wide" }, h("span", {}, "File name"), field), h("p", { class: "hint" }, "Ends in .toml or .json; saved in the folder that the studio was opened on.")], [["save", "Save"], ["cancel", "Cancel"]]);
  return answer === "save" ? field.value.trim() : null;
}

/** Ask for the tolerance of a file; `colours` says those of a mesh. Without a number, the usual one is taken. */
export async function askTolerance(root: HTMLElement, format: string, unit: string, colours: string): Promise<{ tolerance: number | null } | null> {
  const field = h("input", { type: "number", class: "number", min: 0, step: "any", placeholder: "usual", "aria-label": `Tolerance${unit ? ` in ${unit}` : ""}` });
  const body = [
    h("label", { class: "field wide" }, h("span", {}, `Tolerance${unit ? ` (${unit})` : ""}`), field),
    h("p", { class: "hint" }, "How far the file may be from the surface. Left empty: a mesh keeps to a thousandth of its size, a flat pattern to what a cutter can do."),
    ...(colours ? [h("p", { class: "hint" }, `Colours as shown: ${colours}, where the format has colours.`)] : []),
  ];
  for (;;) {
    const answer = await ask(root, `Export ${format}`, body, [["export", "Export"], ["cancel", "Cancel"]]);
    if (answer !== "export") return null;
    if (!field.value && field.validity.valid) return { tolerance: null };
    const tolerance = Number(field.value);
    if (field.validity.valid && tolerance > 0 && tolerance < Infinity) return { tolerance };
    if (!body.some((one) => one.classList.contains("error"))) body.push(h("p", { class: "hint error", role: "alert" }, "Expected a length greater than 0, or nothing."));
  }
}

export interface PictureChoice {
  readonly width: number;
  readonly height: number;
  readonly background: "theme" | "white" | "none";
  readonly legend: boolean;
}

/** Ask for the size and background of a picture. */
export async function askPicture(root: HTMLElement, width: number, height: number): Promise<PictureChoice | null> {
  const size = (name: string, value: number) => h("input", { type: "number", class: "number", min: 64, max: 8192, step: 1, value, "aria-label": name });
  const across = size("Width in pixels", Math.round(width)), down = size("Height in pixels", Math.round(height));
  const set = (w: number, t: number) => {
    across.value = String(w);
    down.value = String(t);
  };
  const presets = h("div", { class: "chips" },
    button("1920 × 1080", "1920 × 1080", () => set(1920, 1080), "chip"), button("3840 × 2160", "3840 × 2160", () => set(3840, 2160), "chip"), button("2000 × 2000", "2000 × 2000", () => set(2000, 2000), "chip"));
  const background = h("select", { "aria-label": "Background" }, h("option", { value: "theme" }, "As shown"), h("option", { value: "white" }, "White"), h("option", { value: "none" }, "Transparent"));
  let legend = true;
  const withLegend = toggle("With legend", (on) => (legend = on));
  withLegend.update(true);
  const answer = await ask(root, "Save a picture", [
    h("div", { class: "pair" }, h("label", { class: "field" }, h("span", {}, "Width"), across), h("label", { class: "field" }, h("span", {}, "Height"), down)),
    presets, h("label", { class: "row" }, h("span", { class: "caption" }, "Background"), background), withLegend.element,
  ], [["save", "Save PNG"], ["cancel", "Cancel"]]);
  if (answer !== "save") return null;
  const limited = (field: HTMLInputElement, fallback: number) => Math.min(8192, Math.max(64, Math.round(Number(field.value)) || fallback));
  return { width: limited(across, width), height: limited(down, height), background: background.value as PictureChoice["background"], legend };
}

const KEYS: readonly (readonly [string, string])[] = [
  ["Ctrl Z, Ctrl Shift Z", "undo, redo"], ["Ctrl S, Ctrl O", "save, open"], ["1 to 6", "views: oblique, top, side, back, front, bottom"], ["P", "perspective or parallel"],
  ["F", "fit"], ["N", "control net"], ["I", "iso-curves"], ["W", "wireframe"], ["Z", "zebra"], ["C", "compare: next arrangement"],
  ["arrows", "turn the view, or move the chosen point by the snap step"], ["Shift arrows", "pan, or move by ten steps"], ["+ −", "zoom"],
  ["[ ]", "choose the control point before or after"], ["Esc", "let go of the point"], ["Enter", "pin the point in the middle of the picture"],
];

export const showHelp = (root: HTMLElement): Promise<string | null> =>
  ask(root, "Keys and pointer", [
    h("p", {}, "Drag to turn, with Shift or the right button to pan, wheel to zoom; on a screen to touch, two fingers pan and zoom. Drag a control point to move it. Click the surface to pin a point."),
    h("dl", { class: "keys-list" }, ...KEYS.flatMap(([keys, what]) => [h("dt", {}, keys), h("dd", {}, what)])),
    h("p", { class: "hint" }, "Grey is where a quantity has no value. The signs of H, κ1, κ2 and S follow the normal; the bar at the bottom says which way it points."),
  ], [["close", "Close"]]);
