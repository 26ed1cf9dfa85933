/** What the colours mean: a scale with histogram for real quantities, a list of types for classes. */

import { QUANTITY, wordsOf } from "../numerics/quantity";
import type { Range } from "../view/range";
import { BACK, classColours, css, FRONT, mapColours, UNDEFINED } from "./colours";
import { h } from "./dom";
import { capital, exponent, percent, raised, short, symbol, unitText } from "./format";

export class Legend {
  readonly element = h("figure", { class: "legend", "aria-label": "Legend" });
  private readonly bar = h("canvas", { class: "colours", width: 1, height: 256 });
  private readonly plot = h("canvas", { class: "histogram", width: 64, height: 192, "aria-hidden": "true" });
  private shown = "";
  private ticks: HTMLElement[] = [];
  private readonly note = h("figcaption", {});

  /** Show a real quantity's scale. */
  real(key: string, range: Range, unit: string, dark: boolean): void {
    this.element.hidden = false;
    const q = QUANTITY[key]!;
    const power = exponent(Math.max(Math.abs(range.low), Math.abs(range.high)));
    if (this.shown !== `${key} ${unit} ${power}`) {
      this.shown = `${key} ${unit} ${power}`;
      const context = this.bar.getContext("2d")!;
      mapColours(q).forEach((colour, i, all) => {
        context.fillStyle = css(colour);
        context.fillRect(0, all.length - 1 - i, 1, 1);
      });
      this.ticks = Array.from({ length: 5 }, () => h("span", { class: "tick" }));
      const units = `${power ? `10${raised(power)} ` : ""}${unitText(q, unit)}`.trim();
      this.element.replaceChildren(
        h("div", { class: "legend-title" }, h("span", {}, capital(q.name)), h("span", { class: "legend-symbol" }, symbol(q.latex), units ? h("span", { class: "unit" }, units) : null)),
        h("div", { class: "scale" }, this.plot, this.bar, h("div", { class: "ticks" }, ...this.ticks)),
        this.note,
      );
    }
    const { low, high } = range, text = (value: number) => short(Math.abs(value) <= range.noise ? 0 : value / 10 ** power, 3);
    this.ticks.forEach((tick, i) => {
      const share = i / (this.ticks.length - 1);
      tick.textContent = text(low + (high - low) * share);
      tick.style.bottom = `${100 * share}%`;
    });
    this.histogram(range, dark);
    const lines: (HTMLElement | string)[] = !range.finite ? ["no point has a finite value"] : [h("dl", { class: "facts" }, h("dt", {}, "max"), h("dd", {}, text(range.most)), h("dt", {}, "mean"), h("dd", {}, text(range.mean)), h("dt", {}, "min"), h("dd", {}, text(range.least)))];
    if (range.below + range.above > 0) lines.push(h("div", {}, `${percent(range.below + range.above)} beyond ends`));
    const none = [[range.missing - range.infinite, "undefined"], [range.infinite, "infinite"]] as const;
    for (const [count, word] of none) if (count) lines.push(h("div", { class: "missing" }, swatch(css(UNDEFINED)), `${count} ${word}`));
    this.note.replaceChildren(...lines);
  }

  /** Show the types that occur, with their share of the points; `parts` counts the types of each surface. */
  classes(key: string, parts: readonly (readonly number[])[]): void {
    this.shown = "";
    this.element.hidden = false;
    const q = QUANTITY[key]!, colours = classColours(key);
    const counts = colours.map((_, code) => parts.reduce((sum, part) => sum + (part[code] ?? 0), 0)), total = counts.reduce((sum, count) => sum + count, 0);
    const rows = q.classes.map((name, code) => ({ name, code })).filter(({ code }) => code > 0 || counts[0]! > 0);
    this.element.replaceChildren(
      h("div", { class: "legend-title" }, h("span", {}, capital(q.name))),
      h("ul", { class: "types" }, ...rows.map(({ name, code }) =>
        h("li", { class: counts[code] ? "" : "absent", title: wordsOf(key, code) || false }, swatch(css(colours[code]!)), h("span", {}, name), h("span", { class: "share" }, counts[code] ? percent(counts[code]! / total) : "–")))),
    );
  }

  /** No quantity: the two sides, where their colours are seen. */
  plain(stripes: boolean): void {
    this.element.hidden = stripes;
    if (this.shown === "plain") return;
    this.shown = "plain";
    this.element.replaceChildren(h("ul", { class: "types" },
      h("li", {}, swatch(css(FRONT)), h("span", {}, "side the normal points to")), h("li", {}, swatch(css(BACK)), h("span", {}, "other side"))));
  }

  private histogram(range: Range, dark: boolean): void {
    const { width, height } = this.plot, context = this.plot.getContext("2d")!;
    context.clearRect(0, 0, width, height);
    const most = Math.max(...range.histogram, 1), step = height / range.histogram.length;
    context.fillStyle = dark ? "rgb(255 255 255 / 38%)" : "rgb(20 30 45 / 30%)";
    range.histogram.forEach((count, i) => {
      const length = count ? Math.max(2, Math.sqrt(count / most) * width) : 0;
      context.fillRect(width - length, height - (i + 1) * step, length, step - 1);
    });
  }
}

const swatch = (colour: string): HTMLElement => {
  const box = h("span", { class: "swatch" });
  box.style.background = colour;
  return box;
};
