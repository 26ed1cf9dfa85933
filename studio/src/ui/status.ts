/** The bar at the bottom, and the banner for what needs an answer. */

import type { State, Store } from "../app/state";
import type { Curve } from "../numerics/curve";
import { normalSide, type Surface } from "../numerics/surface";
import type { Sharpest } from "../view/radius";
import { button } from "./controls";
import { h, icon, ICONS } from "./dom";
import { short } from "./format";

interface Facts {
  readonly side: number;
  readonly cost: number;
  readonly singular: number;
  readonly points: number;
  readonly sharp: Sharpest | null;
  /** The active patch's; null where it cannot be built. */
  readonly surface: Surface | null;
  /** The active patch where it is a curve. */
  readonly curve: Curve | null;
  readonly warning: string;
}

export class StatusBar {
  readonly element = h("footer", { class: "status" });
  readonly banner = h("div", { class: "banners" });
  private readonly left = h("span", {});
  private readonly warning = h("span", { class: "warning" });
  private readonly right = h("span", { class: "quiet" });
  private shown: State["message"] = null;
  private timer = 0;

  constructor(private readonly store: Store) {
    this.element.append(this.left, this.warning, h("span", { class: "spacer" }), this.right);
    store.subscribe((now) => {
      if (now.message !== this.shown) this.say(now.message);
    });
  }

  refresh(state: State, facts: Facts): void {
    const { unit } = state.model;
    if (facts.curve) {
      this.left.textContent = told(facts.curve, unit);
      this.warning.textContent = facts.warning;
      this.right.textContent = "";
      return;
    }
    this.left.replaceChildren(...(facts.surface ? ["Normal ", normalSide(facts.surface), " ", h("i", { class: "math" }, "S"), h("sub", {}, "u"), " × ", h("i", { class: "math" }, "S"), h("sub", {}, "v")] : ["No surface"]), unit ? ` · lengths in ${unit}` : " · no unit",
      facts.sharp ? ` · smallest radius ${short(facts.sharp.radius)}${unit ? ` ${unit}` : ""} at u = ${short(facts.sharp.u)}, v = ${short(facts.sharp.v)}` : "");
    const bare = facts.singular === facts.points && !facts.warning ? "No point has a tangent plane: this is a curve" : "";
    const singular = !facts.singular || facts.singular === facts.points ? bare : `${facts.singular} of ${facts.points} points singular (grey)`;
    this.warning.textContent = [singular, facts.warning].filter(Boolean).join(" · ");
    this.right.textContent = `${facts.side} × ${facts.side} points, ${facts.cost.toFixed(1)} ms`;
  }

  /** A question with two answers, until one is given or the function returned is called. */
  offer(text: string, yes: string, act: () => void, no: string, refuse: () => void): () => void {
    const box = h("div", { class: "banner", role: "alert" }, h("span", {}, text));
    box.append(
      button(yes, yes, () => {
        box.remove();
        act();
      }, "button primary"),
      button(no, no, () => {
        box.remove();
        refuse();
      }));
    this.banner.append(box);
    return () => box.remove();
  }

  warn(text: string): void {
    this.store.set({ message: { kind: "error", text } });
  }

  private say(message: State["message"]): void {
    this.shown = message;
    clearTimeout(this.timer);
    this.banner.querySelector(".message")?.remove();
    if (!message) return;
    this.banner.append(h("div", { class: `banner message ${message.kind}`, role: message.kind === "error" ? "alert" : "status" },
      h("div", {}, message.text, message.lines?.length ? h("ul", {}, ...message.lines.map((line) => h("li", {}, line))) : null),
      ...(message.actions ?? []).map(({ label, act }) => button(label, label, act)),
      button(icon(ICONS.close), "Close", () => this.store.set({ message: null }), "tiny")));
    if (message.kind === "note" && !message.lines && !message.actions) this.timer = window.setTimeout(() => this.store.set({ message: null }), 4000);
  }
}

const LOOKS = 401; // at a curve, for its greatest curvature

/** Length and greatest curvature of a curve, in words. */
function told(curve: Curve, unit: string): string {
  const points = curve.sample(LOOKS).filter(({ curvature }) => Number.isFinite(curvature)), length = unit ? ` ${unit}` : "";
  const most = points.reduce((best, one) => (Math.abs(one.curvature) > Math.abs(best.curvature) ? one : best), points[0] ?? curve.at(0.5));
  const bend = curve.bends(most.curvature) ? `greatest curvature ${short(most.curvature)}${unit ? ` 1/${unit}` : ""} at t = ${short(most.t, 3)}` : "straight";
  const side = curve.flat ? " · positive turns left" : "";
  return `Length ${short(curve.length, 5)}${length} · ${bend}${side}${unit ? "" : " · no unit"}`;
}
