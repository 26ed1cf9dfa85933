/** What lies over the picture: view buttons, cell labels, axes, pins, the point under the pointer, the smallest radius. */

import { mainCell } from "../app/cells";
import { activePatch, type State, type Store } from "../app/state";
import { handlesOf } from "../edit/handles";
import { curveOf, isCurve } from "../numerics/curve";
import type { Patch } from "../numerics/kinds";
import { QUANTITY, wordsOf } from "../numerics/quantity";
import type { ViewName } from "../view/camera";
import { toScene, type Frame } from "../view/frame";
import { gizmo } from "../view/gizmo";
import type { Sharpest } from "../view/radius";
import type { Stage } from "../view/stage";
import { button, segmented } from "./controls";
import { h, icon, ICONS } from "./dom";
import { short, symbol, unitText, valueText } from "./format";
import { told, tools } from "./kept";
import { probe, told as shown } from "./probe";

const SVG = "http://www.w3.org/2000/svg";
const AXES = ["x", "y", "z"] as const;

/** What is told of a point of a curve under the pointer. */
function curveRows(patch: Patch, t: number, unit: string): HTMLElement[] {
  const { flat } = curveOf(patch), at = curveOf(patch).at(t), per = unit ? `1/${unit}` : "";
  const row = (label: string, value: string, of: string) => h("tr", {}, h("th", {}, h("i", { class: "math" }, label)), h("td", {}, value, of ? h("span", { class: "unit" }, of) : null));
  return [
    h("div", { class: "tip-title" }, `t = ${short(t)}`),
    h("div", { class: "tip-point" }, `(${at.point.slice(0, flat ? 2 : 3).map((x) => short(x)).join(", ")})${unit ? ` ${unit}` : ""}`),
    h("table", {}, row("κ", short(at.curvature), per), row("1/κ", short(1 / at.curvature), unit), flat ? null : row("τ", short(at.torsion), per)),
  ];
}

export class Hud {
  readonly element = h("div", { class: "hud" });
  private readonly cells = h("div", { class: "cells" });
  private readonly marks = h("div", { class: "marks-layer" });
  private readonly tip = h("div", { class: "tip", hidden: true, role: "status" });
  private readonly triad = document.createElementNS(SVG, "svg");
  private readonly gizmo = document.createElementNS(SVG, "svg");
  private readonly projection;

  private named = "";

  constructor(private readonly store: Store, private readonly stage: Stage, act: { fit(): void; view(name: ViewName): void }) {
    const view = (name: ViewName, label: string, title: string) => button(label, title, () => act.view(name), "button view-button");
    this.projection = segmented("Projection", [
      { value: "perspective" as const, label: "Perspective" }, { value: "orthographic" as const, label: "Parallel", title: "Orthographic: lengths in the plane of the picture are true" },
    ], (projection) => {
      this.stage.orbit.straight = false;
      store.setting({ projection });
    });
    this.triad.setAttribute("viewBox", "-32 -32 64 64");
    this.triad.setAttribute("class", "triad");
    this.triad.setAttribute("aria-hidden", "true");
    this.gizmo.setAttribute("class", "gizmo");
    this.gizmo.setAttribute("aria-hidden", "true");
    this.element.append(this.cells, this.gizmo, this.marks, this.tip, this.triad,
      h("div", { class: "view-tools", role: "toolbar", "aria-label": "View" },
        view("iso", "Oblique", "Oblique view (1)"), view("top", "Top", "Top view, along −z (2)"), view("side", "Side", "Side view, along +y (3)"), view("back", "Back", "Back view, along −x (4)"),
        view("front", "Front", "Front view, along +x (5)"), view("bottom", "Bottom", "Bottom view, along +z (6)"),
        button(icon(ICONS.fit), "Fit (F)", act.fit, "button square"), this.projection.element));
  }

  /** Name the cells; those of kept variants get their tools. */
  labels(names: readonly string[], state: State): void {
    const first = state.compare === "kept" && names.length > 1 ? 1 : names.length; // the first cell of a kept variant
    const { cells } = this.stage;
    const now = JSON.stringify(cells.map((cell, i) => [names[i], cell.x, cell.y, cell.width, cell.height, i >= first && told(state, i - first)]));
    if (now === this.named) return;
    this.named = now;
    this.cells.replaceChildren(...cells.map((cell, i) => {
      const box = h("div", { class: "cell" }, names[i] ? h("span", { class: "cell-label" }, names[i]!) : null, i >= first ? tools(this.store, i - first) : null);
      Object.assign(box.style, { left: `${cell.x}px`, top: `${cell.y}px`, width: `${cell.width}px`, height: `${cell.height}px` });
      return box;
    }));
  }

  refresh(state: State, frame: Frame, sharp: readonly { cell: number; at: Sharpest }[]): void {
    this.projection.update(this.stage.orbit.projection);
    this.drawTriad();
    const marks: HTMLElement[] = [];
    const put = (cell: number, point: readonly number[], element: HTMLElement) => {
      const p = this.stage.project(cell, toScene(frame, point)), box = this.stage.cells[cell]!;
      if (p.x < box.x || p.x > box.x + box.width || p.y < box.y || p.y > box.y + box.height) return;
      // A mark seen through the surface says so; there are few, or it would take too long.
      if (marks.length < 8 && !state.moving) element.classList.toggle("behind", this.stage.hides(cell, toScene(frame, point), state.settings, frame));
      element.style.transform = `translate(${p.x.toFixed(1)}px, ${p.y.toFixed(1)}px)`;
      marks.push(element);
    };
    const main = mainCell(state, this.stage.cells.length);
    this.drawGizmo(state, frame, main);
    state.pins.forEach((pin, i) => {
      const patch = state.model.patches[pin.patch];
      if (patch) put(main, isCurve(patch) ? curveOf(patch).at(pin.u).point : Array.from(probe(state.model, pin)["point"]!), h("span", { class: "pin" }, h("b", {}, i + 1)));
    });
    const unit = state.model.unit ? ` ${state.model.unit}` : "";
    for (const { cell, at } of sharp) put(cell, at.point, h("span", { class: "sharpest" }, h("b", {}, "r", h("sub", {}, "min"), ` = ${short(at.radius)}${unit}`)));
    this.marks.replaceChildren(...marks);
    this.showTip(state);
  }

  /** Arms and squares at the selected point. */
  private drawGizmo(state: State, frame: Frame, main: number): void {
    const handle = state.settings.net && handlesOf(activePatch(state)).find((one) => one.id === state.selected);
    const parts = handle && !handle.along ? gizmo(this.stage, main, toScene(frame, handle.position), handle.free.map((can, i) => can && !state.settings.locks[i])) : [];
    this.gizmo.replaceChildren(...parts.map(({ axes, outline }) => {
      const shape = document.createElementNS(SVG, "polygon");
      shape.setAttribute("points", outline.map((spot) => spot.map((x) => x.toFixed(1)).join(",")).join(" "));
      shape.setAttribute("class", axes.length === 1 ? `arm axis-${AXES[axes[0]!]!}` : `square axis-${AXES[3 - axes[0]! - axes[1]!]!}`);
      return shape;
    }));
  }

  private showTip(state: State): void {
    const { hover } = state;
    if (!hover || hover.patch >= state.model.patches.length) return void (this.tip.hidden = true);
    const piece = this.stage.cells[hover.cell]?.pieces[hover.patch];
    if (!piece?.patch) return void (this.tip.hidden = true);
    if (isCurve(piece.patch)) return this.tell(hover, curveRows(piece.patch, hover.u, state.model.unit));
    const sample = probe({ ...state.model, patches: [piece.patch] }, { ...hover, patch: 0 });
    const keys = [...new Set([state.settings.quantity === "none" ? "gaussian" : state.settings.quantity, "gaussian", "mean", "hk_type", "shape_class"])];
    const row = (label: Node | string, value: string, unit = "") => h("tr", {}, h("th", {}, label), h("td", {}, value, unit ? h("span", { class: "unit" }, unit) : null));
    const point = sample["point"]!;
    this.tell(hover, [
      h("div", { class: "tip-title" }, `u = ${short(hover.u)}, v = ${short(hover.v)}`),
      h("div", { class: "tip-point" }, `(${Array.from(point, (x) => short(x)).join(", ")})${state.model.unit ? ` ${state.model.unit}` : ""}`),
      h("table", {}, ...keys.map((key) => {
        const q = QUANTITY[key]!;
        return row(q.colour === "classes" ? q.name : symbol(q.latex), valueText(q, shown(sample, q)), unitText(q, state.model.unit));
      })),
      h("div", { class: "tip-words" }, wordsOf("hk_type", sample["hk_type"]![0]!)),
    ]);
  }

  /** Show a tip beside the pointer. */
  private tell(hover: { readonly x: number; readonly y: number }, rows: readonly HTMLElement[]): void {
    this.tip.replaceChildren(...rows);
    this.tip.hidden = false;
    const bound = this.element.getBoundingClientRect(), size = this.tip.getBoundingClientRect();
    const x = hover.x + 18 + size.width > bound.width ? hover.x - 18 - size.width : hover.x + 18;
    const y = Math.min(Math.max(6, hover.y + 14), bound.height - size.height - 6);
    this.tip.style.transform = `translate(${Math.round(x)}px, ${Math.round(y)}px)`;
  }

  private drawTriad(): void {
    const { right, up, towards } = this.stage.orbit.axes();
    const parts = AXES.map((name, i) => {
      const get = (v: { x: number; y: number; z: number }) => [v.x, v.y, v.z][i]!;
      return { name, x: 20 * get(right), y: -20 * get(up), depth: get(towards) };
    }).sort((a, b) => a.depth - b.depth);
    this.triad.replaceChildren(...parts.flatMap(({ name, x, y }) => {
      const line = document.createElementNS(SVG, "line"), text = document.createElementNS(SVG, "text");
      line.setAttribute("x2", String(x));
      line.setAttribute("y2", String(y));
      line.setAttribute("class", `axis-${name}`);
      text.setAttribute("x", String(x * 1.32));
      text.setAttribute("y", String(y * 1.32));
      text.textContent = name;
      return [line, text];
    }));
  }
}
