/** The right panel: shape parameters, colour, overlays, light and section. */

import type { Box } from "../app/cells";
import type { Settings } from "../app/settings";
import { activePatch, shapeSets, type State, type Store } from "../app/state";
import { choicesOf, isClassical, isStandard, type Shaped } from "../numerics/chosen";
import { isCurve } from "../numerics/curve";
import { holds, rangeOf } from "../numerics/formulas";
import { KINDS, shapeOf, shapeParameters, valueOf, type Patch } from "../numerics/model";
import { QUANTITIES, type Quantity } from "../numerics/quantity";
import { lineColour } from "../view/overlays";
import { ALONG, sectionNormal } from "../view/section";
import { button, choice, numberField, section, segmented, slider, toggle, type Control, type Slider } from "./controls";
import { h } from "./dom";
import { capital, parameterParts, parameterSymbol, short, symbol } from "./format";

type Binding = (settings: Settings, dark: boolean) => void;

export class Inspector {
  readonly element = h("aside", { class: "panel right", "aria-label": "Shape and analysis" });
  private readonly shape = h("div", { class: "shape" });
  private readonly fixed = h("p", { class: "hint", hidden: true }, "Four sets are shown side by side; choose “One” to set the shape.");
  private readonly bindings: Binding[] = [];
  /** Sections that say nothing of a curve. */
  private readonly surfaces: readonly HTMLElement[];
  private controls: Control<number>[] = [];
  /** Whether there are curves alone, and whether there are some. */
  private curves = false;
  private some = false;
  private shapeFor = "";
  private fields: { readonly key: string; readonly control: Control<number> }[] = [];

  constructor(private readonly store: Store) {
    this.surfaces = [section("Colour", true, ...this.colour()), section("Light lines", true, ...this.stripes()), section("Section", false, ...this.cut())];
    const [colour, light, cut] = this.surfaces as [HTMLElement, HTMLElement, HTMLElement];
    this.element.append(section("Shape", true, this.shape), colour, section("Show", true, ...this.overlays()), light, cut);
    store.subscribe((now, before) => {
      if (now.model !== before.model || now.patch !== before.patch) this.showShape(now);
    });
  }

  /** Show the settings; `dark` is the theme in force. */
  refresh(state: State, dark: boolean): void {
    const { patches } = state.model;
    this.curves = patches.every(isCurve);
    this.some = patches.some(isCurve);
    for (const one of this.surfaces) one.hidden = this.curves;
    for (const bind of this.bindings) bind(state.settings, dark);
    this.showShape(state);
  }

  private showShape(state: State): void {
    const patch = activePatch(state), parameters = shapeParameters(patch), values = parameters.length ? shapeOf(patch) : [];
    const free = patch["unchecked_shape"] === true;
    const dimensions = Object.entries(KINDS[patch.kind]!.fields).filter(([, f]) => f.type === "number" || f.type === "positive").map(([key]) => key);
    const form = JSON.stringify([patch.kind, patch["basis"], parameters, free]);
    if (form !== this.shapeFor) {
      this.shapeFor = form;
      this.build(patch, parameters, dimensions, free);
    }
    values.forEach((value, i) => this.controls[i]?.update(value));
    for (const { key, control } of this.fields) control.update(valueOf(patch, key) as number);
    // Four fixed sets are shown: there is no cell that another shape would be seen in.
    const fixed = state.compare === "sets" && shapeSets(patch).length > 0;
    this.fixed.hidden = !fixed;
    for (const { element } of this.controls) for (const input of element.querySelectorAll("input")) input.disabled = fixed;
    for (const chip of this.shape.querySelectorAll<HTMLButtonElement>(".chip")) chip.disabled = fixed;
    const now = JSON.stringify(values);
    for (const chip of this.shape.querySelectorAll<HTMLElement>(".chip")) chip.setAttribute("aria-pressed", String(chip.dataset["shape"] === now));
  }

  private build(patch: Patch, parameters: readonly Shaped[], dimensions: readonly string[], free: boolean): void {
    const { store } = this;
    const change = (i: number, value: number) => {
      const now = activePatch(store.state);
      store.editPatch({ ...now, shape: shapeOf(now).map((x, k) => (k === i ? value : x)) }, `shape ${i}`);
    };
    this.controls = parameters.map((one, i) => {
      const { low, high, open, label } = one, step = 10 ** Math.floor(Math.log10((high - low) / 200));
      return slider({
        label: parameterSymbol(label), name: parameterParts(label).filter(Boolean).join(" "), step, marks: marksOf(low, high), hard: !free,
        min: low + step * Number(open[0]), max: open[1] ? low + step * Math.ceil((high - low) / step - 1 - 1e-9) : high,
        allowed: { holds: (value) => holds(one, value), words: `a number in ${rangeOf(one)}` },
        onInput: (value) => change(i, value), onSettle: () => store.settle(),
      });
    });
    const along = alongOf(patch), several = new Set(parameters.map((one) => one.of)).size > 1 || !isStandard(patch);
    const rows: (HTMLElement | string)[] = [];
    this.controls.forEach((control, i) => {
      const { of } = parameters[i]!;
      if (several && along[of] && of !== parameters[i - 1]?.of) rows.push(h("div", { class: "subtitle" }, along[of]!));
      rows.push(control.element);
    });
    this.fields = dimensions.map((key) => {
      const act = (value: number, gesture: string | null) => store.editPatch({ ...activePatch(store.state), [key]: value }, gesture);
      if (key === "scale") {
        const control = slider({
          label: symbol("\\lambda"), name: "lambda", min: 0.1, max: 4, step: 0.01, marks: [1, 1.5, 3],
          onInput: (value) => act(value, "scale"), onSettle: () => store.settle(),
        });
        return { key, control };
      }
      const positive = KINDS[patch.kind]!.fields[key]!.type === "positive";
      return { key, control: numberField({ label: capital(key), name: capital(key), positive, step: 0.1, onChange: (value) => act(value, null) }) };
    });
    if (this.fields.length) rows.push(h("div", { class: "subtitle" }, patch.kind === "swung" ? "scale of the trajectory" : "dimensions"), ...this.fields.map((f) => f.control.element));
    const sets = shapeSets(patch);
    if (sets.length) {
      rows.push(h("div", { class: "subtitle" }, "sets of the thesis"), h("div", { class: "chips" }, ...[...sets, sets[0]!.map(() => 0)].map((set) => {
        const chip = button(`(${set.join(", ").replaceAll("-", "−")})`, `Set the shape parameters to ${set.join(", ")}`, () => store.editPatch({ ...activePatch(store.state), shape: set }), "chip");
        chip.dataset["shape"] = JSON.stringify(set);
        return chip;
      })));
    }
    const what = isCurve(patch) ? "curve" : "surface";
    if (!rows.length) rows.push(h("p", { class: "hint" }, isClassical(patch) ? "On the Bernstein basis no shape parameters act: drag the control points." : `This ${what} has no shape parameters: drag its control points.`));
    this.shape.replaceChildren(this.fixed, ...rows);
  }

  private colour(): (HTMLElement | string)[] {
    const { store } = this;
    const group = (label: string, test: (q: Quantity) => boolean) => ({
      label, options: QUANTITIES.filter((q) => q.colour !== "vector" && test(q)).map((q) => ({ value: q.key, label: `${capital(q.name)}${q.colour === "classes" ? "" : `  ${q.symbol}`}` })),
    });
    const form = (q: Quantity) => "EFGLMN".includes(q.key);
    const invariant = (q: Quantity) => /^(beta|gamma)\d/.test(q.key);
    const quantity = choice("Colour by", [
      { label: "", options: [{ value: "none", label: "No colour" }] },
      group("Curvature", (q) => q.colour !== "classes" && !form(q) && !invariant(q)),
      group("Types", (q) => q.colour === "classes"),
      group("Invariants, plane metric", (q) => invariant(q) && !q.key.endsWith("_surface")),
      group("Invariants, surface metric", (q) => q.key.endsWith("_surface")),
      group("Fundamental forms", form),
    ], (key) => store.setting({ quantity: key, range: store.state.settings.range === "fixed" ? "robust" : store.state.settings.range }));
    const range = segmented("Range of colours", [
      { value: "robust" as const, label: "Percentiles", title: "Leave out a few extreme values at either end" },
      { value: "full" as const, label: "All", title: "From the least to the greatest value" },
      { value: "fixed" as const, label: "Fixed", title: "Ends given by hand" },
    ], (value) => store.setting({ range: value }));
    const cut = slider({ label: "cut", name: "Percentile cut at either end", min: 0, max: 20, step: 0.5, marks: [2, 5, 10], hard: true, onInput: (percentile) => store.setting({ percentile }) });
    const low = numberField({ label: "from", name: "Lowest colour", onChange: (value) => store.setting({ low: value }) });
    const high = numberField({ label: "to", name: "Highest colour", onChange: (value) => store.setting({ high: value }) });
    const fixed = h("div", { class: "pair" }, low.element, high.element);
    const contours = toggle("Contour lines", (on) => store.setting({ contours: on }), undefined, "Ten steps from end to end");
    this.bindings.push((s) => {
      const q = QUANTITIES.find((one) => one.key === s.quantity);
      const real = q !== undefined && q.colour !== "classes";
      quantity.update(s.quantity);
      range.update(s.range);
      cut.update(s.percentile);
      low.update(s.low);
      high.update(s.high);
      contours.update(s.contours);
      range.element.hidden = contours.element.hidden = !real;
      cut.element.hidden = !real || s.range !== "robust";
      fixed.hidden = !real || s.range !== "fixed";
    });
    return [quantity.element, range.element, cut.element, fixed, contours.element];
  }

  private overlays(): HTMLElement[] {
    const { store } = this;
    const rule = (...names: Parameters<typeof lineColour>[0][]) => {
      const box = h("span", { class: "keys" }, ...names.map(() => h("span", { class: "key" })));
      this.bindings.push((_, dark) => names.forEach((name, i) => ((box.children[i] as HTMLElement).style.background = lineColour(name, dark))));
      return box;
    };
    const flag = (key: "comb" | "net" | "curves" | "directions" | "normals" | "zeroK" | "zeroH" | "minRadius" | "seams" | "wireframe", label: Node | string, swatch?: HTMLElement, hint = "") => {
      const control = toggle(label, (on) => store.setting({ [key]: on }), swatch, hint);
      this.bindings.push((s) => {
        control.update(s[key]);
        control.element.hidden = key === "comb" ? !this.some : key !== "net" && this.curves;
      });
      return control.element;
    };
    const math = (latex: string, ...rest: string[]) => h("span", {}, symbol(latex), ...rest);
    const combs = segmented("Combs along iso-curves", [
      { value: "off" as const, label: "Off" }, { value: "u" as const, label: h("i", {}, "u") }, { value: "v" as const, label: h("i", {}, "v") }, { value: "both" as const, label: "Both" },
    ], (value) => store.setting({ combs: value }));
    const scale = slider({ label: "size", name: "Size of the combs", min: 0.1, max: 3, step: 0.1, marks: [1], onInput: (combScale) => store.setting({ combScale }) });
    this.bindings.push((s) => {
      combs.update(s.combs);
      scale.update(s.combScale);
      combs.element.parentElement!.hidden = this.curves;
      scale.element.hidden = !(this.some && s.comb) && (this.curves || s.combs === "off");
    });
    const net = h("span", {});
    this.bindings.push(() => (net.textContent = this.curves ? "Polygon" : "Control net"));
    return [
      h("div", { class: "switches" },
        flag("net", net, rule("net")),
        flag("comb", "Comb", rule("combU"), "Curvature comb: teeth as long as the curvature, on the outer side of the bend"),
        flag("curves", "Iso-curves"),
        flag("directions", "Directions", rule("first", "second"), "Principal directions. Strong: of κ1; light: of κ2"),
        flag("normals", "Normals", rule("normals")),
        flag("zeroK", math("K", " = 0"), rule("zeroK"), "Parabolic lines"),
        flag("zeroH", math("H", " = 0"), rule("zeroH")),
        flag("minRadius", "Smallest radius"),
        flag("seams", "Seams", undefined, "Red: open; orange: G0; yellow: G1; green: G2; blue: G3"),
        flag("wireframe", "Wireframe")),
      h("div", { class: "row" }, h("span", { class: "caption" }, "Combs"), combs.element), scale.element,
    ];
  }

  private stripes(): HTMLElement[] {
    const { store } = this;
    const kind = segmented("Light lines", [
      { value: "none" as const, label: "Off" },
      { value: "zebra" as const, label: "Zebra", title: "Stripes of a striped room, reflected" },
      { value: "isophotes" as const, label: "Isophotes", title: "Lines of equal angle between normal and light" },
      { value: "reflection" as const, label: "Reflect", title: "Reflections of parallel tube lights" },
      { value: "highlight" as const, label: "Highlight", title: "Highlight lines: where the normal meets a tube light; the same from everywhere" },
    ], (stripes) => store.setting({ stripes }));
    const density = slider({ label: "lines", name: "Number of lines", min: 4, max: 80, step: 1, onInput: (value) => store.setting({ density: value }), onSettle: () => store.settle() });
    const azimuth = slider({ label: "turn", name: "Azimuth of the light in degrees", min: -180, max: 180, step: 1, marks: [-90, 0, 90], onInput: (lightAzimuth) => store.setting({ lightAzimuth }) });
    const elevation = slider({ label: "height", name: "Height of the light in degrees", min: -90, max: 90, step: 1, marks: [0, 45], onInput: (lightElevation) => store.setting({ lightElevation }) });
    const ball = h("div", { class: "light-ball", title: "Drag the light" }, h("span", {}));
    const place = (event: PointerEvent) => {
      const box = ball.getBoundingClientRect();
      const x = ((event.clientX - box.left) / box.width) * 2 - 1, y = 1 - ((event.clientY - box.top) / box.height) * 2;
      const r = Math.min(1, Math.hypot(x, y));
      store.setting({ lightAzimuth: Math.round((Math.atan2(y, x) * 180) / Math.PI), lightElevation: Math.round((Math.acos(r) * 180) / Math.PI) });
    };
    ball.addEventListener("pointerdown", (event) => {
      ball.setPointerCapture(event.pointerId);
      place(event);
    });
    ball.addEventListener("pointermove", (event) => {
      if (ball.hasPointerCapture(event.pointerId)) place(event);
    });
    const more = h("div", { class: "light" }, ball, h("div", { class: "stack" }, azimuth.element, elevation.element));
    this.bindings.push((s) => {
      kind.update(s.stripes);
      density.update(s.density);
      azimuth.update(s.lightAzimuth);
      elevation.update(s.lightElevation);
      density.element.hidden = more.hidden = s.stripes === "none";
      const a = (s.lightAzimuth * Math.PI) / 180, r = Math.cos((s.lightElevation * Math.PI) / 180);
      const dot = ball.firstElementChild as HTMLElement;
      dot.style.left = `${50 + 50 * r * Math.cos(a)}%`;
      dot.style.top = `${50 - 50 * r * Math.sin(a)}%`;
      dot.classList.toggle("under", s.lightElevation < 0);
    });
    return [kind.element, density.element, more];
  }

  private cut(): HTMLElement[] {
    const { store } = this;
    const on = toggle("Section by a plane", (section) => store.setting({ section }));
    const clip = toggle("Cut the front away", (value) => store.setting({ clip: value }));
    const axis = segmented("Normal of the plane", (["x", "y", "z"] as const).map((value) => ({ value, label: h("i", {}, value), title: `Plane across ${value}` })),
      (value) => store.setting({ sectionAzimuth: ALONG[value][0], sectionTilt: ALONG[value][1], sectionAt: 0 }));
    const azimuth = slider({ label: "turn", name: "Azimuth of the plane's normal in degrees", min: -180, max: 180, step: 1, marks: [-90, 0, 90], onInput: (sectionAzimuth) => store.setting({ sectionAzimuth }) });
    const tilt = slider({ label: "tilt", name: "Tilt of the plane's normal in degrees", min: -90, max: 90, step: 1, marks: [-45, 0, 45], hard: true, onInput: (sectionTilt) => store.setting({ sectionTilt }) });
    const told = h("p", { class: "hint" });
    const offset = slider({ label: "at", name: "Place of the section plane", min: -1, max: 1, step: 0.01, onInput: (at) => store.setting({ sectionAt: at - this.middle }) });
    const parts = [h("div", { class: "row" }, h("span", { class: "caption" }, "Across"), axis.element), azimuth.element, tilt.element, offset.element, told, clip.element];
    this.bindings.push((s) => {
      on.update(s.section);
      clip.update(s.clip);
      const along = (["x", "y", "z"] as const).find((name) => s.sectionTilt === ALONG[name][1] && (name === "z" || s.sectionAzimuth === ALONG[name][0]));
      axis.update(along ?? ("free" as "x"));
      azimuth.update(s.sectionAzimuth);
      tilt.update(s.sectionTilt);
      for (const part of parts) part.hidden = !s.section;
      if (s.section) told.textContent = `${this.showOffset(s, offset)}; drag the red points in the picture`;
    });
    return [on.element, ...parts];
  }

  private middle = 0;
  private box: Box = { low: [0, 0, 0], high: [1, 1, 1] };

  /** Let the section plane run over a box, from its middle. */
  sectionBox(box: Box): void {
    this.box = box;
  }

  /** Show where the plane stands, a x + b y + c z = d in the model's lengths, and return that in words. */
  private showOffset(s: Settings, offset: Slider): string {
    const normal = sectionNormal(s), { low, high } = this.box;
    this.middle = normal.reduce((sum, n, i) => sum + 0.5 * n * (low[i]! + high[i]!), 0);
    const reach = normal.reduce((sum, n, i) => sum + 0.5 * Math.abs(n) * (high[i]! - low[i]!), 0) || 1;
    offset.bounds(this.middle - reach, this.middle + reach, 10 ** Math.floor(Math.log10(reach / 500)));
    const at = this.middle + s.sectionAt, { unit } = this.store.state.model;
    offset.update(Number(at.toPrecision(5)));
    const sum = normal.map((n, i) => [Number(n.toFixed(3)), "xyz"[i]!] as const).filter(([n]) => n !== 0)
      .map(([n, name], i) => `${n < 0 ? "− " : i ? "+ " : ""}${Math.abs(n) === 1 ? "" : `${Math.abs(n)} `}${name}`).join(" ");
    return `${sum} = ${short(at)}${unit ? ` ${unit}` : ""}`;
  }
}

/** What each basis of a patch is for, with its name where it is not the quintic one. */
function alongOf(patch: Patch): readonly string[] {
  try {
    const choices = choicesOf(patch), curve = patch.kind === "ruled" ? ["first curve", "second curve"] : choices.length > 1 ? ["along u", "along v"] : [""];
    return choices.map(({ entry }, i) => [curve[i], isStandard(patch) ? "" : entry.title].filter(Boolean).join(": "));
  } catch {
    return [];
  }
}

/** The values to mark on a slider: a few whole numbers, or its ends where it holds hardly any. */
function marksOf(low: number, high: number): number[] {
  for (const step of [1, 2, 5, 10, 20, 50, 100]) {
    const first = Math.ceil(low / step), count = Math.floor(high / step) - first + 1;
    if (count >= 2 && count <= 6) return Array.from({ length: count }, (_, i) => (first + i) * step);
  }
  return [low, high].map((x) => Number(x.toPrecision(3)));
}
