/** The probe: what is under the pointer, and a table of pinned points. */

import data from "../data.json";
import { activePatch, type Pin, type State, type Store } from "../app/state";
import { curveOf, isCurve } from "../numerics/curve";
import { build, type Model, type Patch } from "../numerics/model";
import { QUANTITIES, QUANTITY, type Quantity } from "../numerics/quantity";
import { analyse, type Sample } from "../numerics/sample";
import { normalSide } from "../numerics/surface";
import { covers } from "../numerics/trim";
import { button, numberField, toggle } from "./controls";
import { download, fileName, h, icon, ICONS } from "./dom";
import { capital, short, symbol, unitText, valueText } from "./format";

const USUAL = ["gaussian", "mean", "k1", "k2", "shape_index", "curvedness", "hk_type", "shape_class", "point_type"];

/** Every quantity at one point of a patch. */
export function probe(model: Model, pin: Pin): Sample {
  return analyse(build(model.patches[pin.patch]!), [pin.u], [pin.v], true);
}

/** Whether a point lies on its patch: a trimmed face has no values where it is cut off. */
const onFace = (model: Model, { patch, u, v }: Pin): boolean => covers(build(model.patches[patch]!), u, v);

/** A value as people are told it: what is rounding beside the curvedness of the point is 0, as in Python's tables. */
export function told(sample: Sample, q: Quantity, part = 0): number {
  const value = sample[q.key]![part]!;
  if (q.colour === "classes" || q.power >= 0) return value;
  return Math.abs(value) <= data.limits.noise * sample["curvedness"]![0]! ** -q.power ? 0 : value;
}

const normalOf = (patch: Patch, named: boolean): string =>
  `normal ${normalSide(build(patch))} S_u x S_v${named ? ` on ${patch.name.replaceAll("\n", " ")}` : ""}`;

/** The pins on surfaces, or those on curves, as the active patch is one. */
const pinsLike = (state: State): readonly Pin[] =>
  state.pins.filter(({ patch }) => patch < state.model.patches.length && isCurve(state.model.patches[patch]!) === isCurve(activePatch(state)));

export class ProbePanel {
  readonly element: HTMLElement;
  private readonly body = h("div", { class: "probe-body" });
  private readonly count = h("span", { class: "badge" });
  private readonly surfaces: readonly HTMLElement[];
  private readonly hint = h("span", { class: "hint" });
  private readonly first = h("span", {}, h("i", { class: "math" }, "u"));
  private all = false;
  private u = 0.5;
  private v = 0.5;

  constructor(private readonly store: Store, private readonly unfolded: () => void) {
    const u = numberField({ label: this.first, name: "u to pin", step: 0.05, onChange: (x) => (this.u = Math.min(1, Math.max(0, x))) });
    const v = numberField({ label: h("i", { class: "math" }, "v"), name: "v to pin", step: 0.05, onChange: (x) => (this.v = Math.min(1, Math.max(0, x))) });
    u.update(this.u);
    v.update(this.v);
    const more = toggle("All quantities", (on) => {
      this.all = on;
      this.refresh(store.state);
    });
    this.surfaces = [v.element, more.element];
    const tools = h("div", { class: "probe-tools" },
      u.element, v.element, button("Pin", "Pin the point at these parameters", () => this.add()),
      more.element, h("span", { class: "spacer" }),
      button("CSV", "Save the table as CSV", () => this.save()),
      button("Clear", "Clear: remove all pins", () => store.set({ pins: [] })));
    this.element = h("details", { class: "probe" }, h("summary", {}, icon(ICONS.pin), "Probe", this.count, this.hint), tools, this.body);
    this.element.addEventListener("toggle", () => this.unfolded());
    this.suit(store.state);
    store.subscribe((now, before) => {
      if (now.model !== before.model || now.patch !== before.patch) this.suit(now);
      if (now.pins.length > before.pins.length) (this.element as HTMLDetailsElement).open = true;
      if (now.pins !== before.pins || ((now.model !== before.model || now.patch !== before.patch) && now.pins.length)) this.refresh(now);
    });
  }

  /** A curve has one parameter, and few quantities. */
  private suit(state: State): void {
    const curve = isCurve(activePatch(state));
    for (const one of this.surfaces) one.hidden = curve;
    this.hint.textContent = `click the ${curve ? "curve" : "surface"} to pin a point`;
    this.first.replaceChildren(h("i", { class: "math" }, curve ? "t" : "u"));
  }

  private add(): void {
    const { pins, patch } = this.store.state;
    this.store.set({ pins: [...pins, { patch, u: this.u, v: this.v }] });
  }

  /** The pins of a model of curves: t, point, curvature, its radius and the torsion; a plane curve has neither z nor torsion. */
  private curves({ model }: State, pins: readonly Pin[]): { heads: [string, string][]; rows: (string | number)[][] } {
    const flat = pins.every((pin) => curveOf(model.patches[pin.patch]!).flat), per = model.unit ? `1/${model.unit}` : "";
    const names = ["x", "y", ...(flat ? [] : ["z"])].map((name): [string, string] => [name, model.unit]);
    const heads: [string, string][] = [["t", ""], ...names, ["κ", per], ["1/κ", model.unit], ...(flat ? [] : [["τ", per] as [string, string]])];
    const rows = pins.map((pin) => {
      const { t, point, curvature, torsion } = curveOf(model.patches[pin.patch]!).at(pin.u);
      return [t, ...point.slice(0, flat ? 2 : 3), curvature, 1 / curvature, ...(flat ? [] : [torsion])];
    });
    return { heads, rows };
  }

  private showCurves(state: State): void {
    const pins = pinsLike(state), { heads, rows } = this.curves(state, pins), several = state.model.patches.length > 1;
    const head = h("tr", {}, h("th", {}, "#"), several ? h("th", {}, "curve") : null,
      ...heads.map(([name, unit]) => h("th", {}, h("i", { class: "math" }, name), unit ? h("span", { class: "unit" }, unit) : null)), h("th", {}));
    const body = rows.map((values, i) => h("tr", {}, h("td", {}, h("span", { class: "pin-number" }, i + 1)),
      several ? h("td", {}, state.model.patches[pins[i]!.patch]!.name) : null, ...values.map((x) => h("td", {}, short(x as number))),
      h("td", {}, this.remover(pins[i]!, i))));
    this.body.replaceChildren(h("table", {}, h("thead", {}, head), h("tbody", {}, ...body)));
  }

  private remover(pin: Pin, i: number): HTMLElement {
    return button(icon(ICONS.close), `Remove pin ${i + 1}`, () => this.store.set({ pins: this.store.state.pins.filter((one) => one !== pin) }), "tiny");
  }

  private columns(): { q: Quantity; part: number; head: string }[] {
    const keys = this.all ? QUANTITIES.map((q) => q.key) : ["point", ...USUAL];
    return keys.flatMap((key) => {
      const q = QUANTITY[key]!;
      return q.components === 1 ? [{ q, part: 0, head: q.symbol }] : ["x", "y", "z"].map((axis, part) => ({ q, part, head: key === "point" ? axis : `${q.symbol} ${axis}` }));
    });
  }

  refresh(state: State): void {
    this.count.textContent = state.pins.length ? String(state.pins.length) : "";
    if (!state.pins.length) {
      this.body.replaceChildren();
      return;
    }
    if (isCurve(activePatch(state))) return this.showCurves(state);
    const several = state.model.patches.length > 1, columns = this.columns();
    const head = h("tr", {}, h("th", {}, "#"), several ? h("th", {}, "patch") : null, h("th", {}, h("i", { class: "math" }, "u")), h("th", {}, h("i", { class: "math" }, "v")),
      ...columns.map(({ q, head }) => h("th", { title: capital(q.name) },
        q.components === 1 ? (q.colour === "classes" ? capital(q.name) : symbol(q.latex)) : h("i", { class: "math" }, head),
        unitText(q, state.model.unit) ? h("span", { class: "unit" }, unitText(q, state.model.unit)) : null)), h("th", {}));
    const rows = pinsLike(state).map((pin, i) => {
      const sample = probe(state.model, pin);
      return h("tr", {}, h("td", {}, h("span", { class: "pin-number" }, i + 1)), several ? h("td", {}, state.model.patches[pin.patch]!.name) : null,
        h("td", {}, short(pin.u)), h("td", {}, short(pin.v)),
        ...(onFace(state.model, pin)
          ? columns.map(({ q, part }) => h("td", { class: q.colour === "classes" ? "word" : "" }, valueText(q, told(sample, q, part))))
          : [h("td", { class: "word", colspan: columns.length }, "outside the trimmed face")]), h("td", {}, this.remover(pin, i)));
    });
    this.body.replaceChildren(h("table", {}, h("thead", {}, head), h("tbody", {}, ...rows)));
  }

  /** The pins with every quantity and digit. */
  private save(): void {
    const { model } = this.store.state, pins = pinsLike(this.store.state);
    if (isCurve(activePatch(this.store.state))) return this.saveCurves();
    const columns = QUANTITIES.flatMap((q) => Array.from({ length: q.components }, (_, part) => ({ q, part })));
    const name = ({ q, part }: { q: Quantity; part: number }) => (q.components === 1 ? q.key : `${q.key}_${"xyz"[part]!}`);
    const units = columns.map(({ q }) => [q.key, unitText(q, model.unit)] as const).filter(([, unit]) => unit);
    // What begins so is a formula to a spreadsheet; numbers do not come here.
    const guarded = (text: string) => text.replaceAll(/(^|[,;])(\s*)(?=[=+\-@])/g, "$1$2'");
    const quoted = (text: string) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
    const lines = [
      `# ${guarded(model.name.replaceAll("\n", " "))}: ${[...new Set(pins.map((pin) => pin.patch))].map((at) => normalOf(model.patches[at]!, model.patches.length > 1)).join(", ")}`,
      ...(units.length ? [`# Units: ${[...new Map(units)].map(([key, unit]) => `${key} in ${unit}`).join(", ")}`] : []),
      ["patch", "u", "v", ...columns.map(name)].join(","),
      ...pins.map((pin) => {
        const sample = probe(model, pin), on = onFace(model, pin);
        const cell = ({ q, part }: { q: Quantity; part: number }) => {
          const value = sample[q.key]![part]!;
          if (!on) return "";
          return q.colour === "classes" ? quoted(q.classes[value]!) : Number.isNaN(value) ? "" : String(value);
        };
        return [quoted(guarded(model.patches[pin.patch]!.name)), pin.u, pin.v, ...columns.map(cell)].join(",");
      }),
    ];
    download(`${fileName(model.name)}_probe.csv`, `${lines.join("\n")}\n`, "text/csv");
  }

  private saveCurves(): void {
    const { model } = this.store.state, pins = pinsLike(this.store.state), { heads, rows } = this.curves(this.store.state, pins);
    const lines = [
      ["curve", ...heads.map(([name, unit]) => (unit ? `${name} (${unit})` : name))].join(","),
      ...rows.map((values, i) => [JSON.stringify(model.patches[pins[i]!.patch]!.name.replace(/^[=+\-@]/, "'$&")), ...values.map((x) => (Number.isNaN(x) ? "" : x))].join(",")),
    ];
    download(`${fileName(model.name)}_probe.csv`, `${lines.join("\n")}\n`, "text/csv");
  }
}
