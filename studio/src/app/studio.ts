/** The studio put together: state, panels and picture, and what has to be worked out again after a change. */

import { handlesOf } from "../edit/handles";
import { curveOf, isCurve } from "../numerics/curve";
import type { Model } from "../numerics/model";
import { QUANTITY } from "../numerics/quantity";
import { AimsPanel } from "../ui/aims-panel";
import { Hud } from "../ui/hud";
import { Inspector } from "../ui/inspector";
import { Legend } from "../ui/legend";
import { ModelPanel } from "../ui/model-panel";
import { showHelp, type PictureChoice } from "../ui/dialogs";
import { h } from "../ui/dom";
import { ProbePanel } from "../ui/probe";
import { StatusBar } from "../ui/status";
import { TopBar } from "../ui/topbar";
import type { ViewName } from "../view/camera";
import { frameOf, toScene, UNIT_FRAME, type Frame } from "../view/frame";
import { compose } from "../view/picture";
import type { Sharpest } from "../view/radius";
import { rangeOf, type Range } from "../view/range";
import { sectionGrips } from "../view/section";
import { Stage } from "../view/stage";
import { boxOf, cellsOf, type Shown } from "./cells";
import { Drafts } from "./drafts";
import { Files } from "./files";
import { Follower, NO_AIMS } from "./aims";
import { LiveHost, type Host } from "./host";
import { press } from "./keys";
import { Painter } from "./painter";
import { listen, still } from "./pointer";
import { Proofs } from "./proofs";
import { remembered, type Settings } from "./settings";
import { activePatch, Store, type Source, type State } from "./state";
import { warningOf } from "./warning";

const QUICK = 160; // ms between frames

export interface Start {
  readonly model: Model;
  readonly source: Source | null;
  readonly quantity?: string;
  /** Called with the model after every change, also while dragging. */
  onModel?(model: Model): void;
}

export class Studio {
  readonly store: Store;
  readonly root: HTMLElement;
  readonly stage: Stage;
  private readonly canvas = h("canvas", { class: "view", tabindex: 0, role: "application", "aria-label": "The surface. Arrow keys turn it; ? lists all keys." });
  private readonly centre = h("div", { class: "picture" }, this.canvas);
  private readonly legend = new Legend();
  private readonly hud: Hud;
  private readonly bar: TopBar;
  private readonly inspector: Inspector;
  private readonly model: ModelPanel;
  /** Of the live studio alone: a page from disk has nobody to measure for it. */
  private readonly aims: AimsPanel | null = null;
  private readonly probe: ProbePanel;
  private readonly status: StatusBar;
  private readonly files: Files;
  private readonly drafts: Drafts;
  private frame: Frame = UNIT_FRAME;
  private range: Range | null = null;
  private sharp: { cell: number; at: Sharpest }[] = [];
  private readonly painter: Painter;
  private readonly proofs: Proofs | null;
  private surfaces = 0;
  private planned = 0;
  private shownAt = 0;
  private settling = 0;
  private dark = false;
  private stale = true;
  private refit = true;
  private fitAfter = false;
  /** Another model or kind is shown: plane curves are looked at from the top, what follows them is not. */
  private fresh = true;
  private flat = false;
  private from: ViewName | null = null;

  constructor(private readonly container: HTMLElement, private readonly host: Host, start: Start) {
    const settings: Settings = { ...remembered(), ...(start.quantity ? { quantity: start.quantity } : {}) };
    this.store = new Store({
      model: start.model, saved: start.model, source: start.source, patch: 0, selected: null, settings, compare: "off", kept: [], pins: [],
      hover: null, canUndo: false, canRedo: false, moving: false, joining: null, aims: NO_AIMS, beside: null, lights: [], message: null, opened: 1,
    });
    const { store } = this;
    this.stage = new Stage(this.canvas);
    this.proofs = host.prove ? new Proofs(store, host, () => this.plan(true)) : null;
    this.painter = new Painter(this.stage, (patch) => this.proofs?.of(patch) ?? null, (message) => this.status.warn(message));
    this.files = new Files(store, host, () => this.root, (choice) => this.picture(choice), () => [this.centre.clientWidth, this.centre.clientHeight], () => this.range && [this.range.low, this.range.high]);
    this.bar = new TopBar(store, this.files, () => this.switchTheme(), () => void showHelp(this.root), () => this.root.classList.toggle("with-left"), host.kind !== "live");
    this.model = new ModelPanel(store);
    this.inspector = new Inspector(store);
    if (host instanceof LiveHost) {
      this.aims = new AimsPanel(store, host);
      this.inspector.element.append(this.aims.element);
      new Follower(store, host);
    }
    if (this.proofs) this.inspector.element.append(this.proofs.element);
    this.probe = new ProbePanel(store, () => this.plan());
    this.status = new StatusBar(store);
    this.hud = new Hud(store, this.stage, { fit: () => this.fit(), view: (name) => this.view(name) });
    this.centre.append(this.hud.element, this.legend.element);
    this.root = h("div", { class: `studio ${host.kind}` },
      this.bar.element, this.model.element,
      h("main", { class: "centre" }, this.status.banner, this.centre, this.probe.element),
      this.inspector.element, this.status.element);
    container.append(this.root);
    this.drafts = new Drafts(host.place);
    listen(this.canvas, { store, stage: this.stage, frame: () => this.frame, fit: () => this.fit(), editable: (cell) => cellsOf(store.state)[cell]?.editable ?? false, redraw: () => this.plan(), ownsWheel: () => host.kind === "live" || this.canvas.matches(":focus") });
    // A live page is all studio: its keys work also when the focus is on nothing.
    const keyed: HTMLElement | Document = host.kind === "live" ? document : this.root;
    keyed.addEventListener("keydown", (event) => {
      if (!(event instanceof KeyboardEvent) || this.root.querySelector("dialog[open]")) return;
      if (press(event, { store, stage: this.stage, files: this.files, frame: () => this.frame, fit: () => this.fit(), view: (name) => this.view(name), redraw: () => this.plan(), help: () => void showHelp(this.root) })) event.preventDefault();
    });
    this.files.receive(this.root);
    this.canvas.addEventListener("webglcontextrestored", () => this.plan(true));
    new ResizeObserver(() => {
      this.resize();
      this.hurry();
    }).observe(this.centre);
    new ResizeObserver(() => {
      // The picture ends where the closed probe begins; the open one lies over it, and the buttons stand on it.
      this.stage.covered = Math.max(0, this.probe.element.offsetHeight - (this.root.querySelector<HTMLElement>(".centre")!.clientHeight - this.centre.clientHeight));
      this.centre.style.setProperty("--covered", `${this.stage.covered}px`);
    }).observe(this.probe.element);
    const scheme = matchMedia("(prefers-color-scheme: dark)");
    scheme.addEventListener("change", () => this.plan(true));
    store.subscribe((now, before) => this.changed(now, before, start));
    if (!this.stage.works) this.status.warn("This browser has no WebGL: you see still pictures. Everything else works.");
    this.resize();
    this.plan(true);
    if (host.kind !== "notebook") {
      this.drafts.watch(store, this.status);
    }
    if (host.kind === "live") this.files.watch();
  }

  private changed(now: State, before: State, start: Start): void {
    if (now.model !== before.model) {
      start.onModel?.(now.model);
      if (now.model.patches.some((patch, i) => patch.kind !== before.model.patches[i]?.kind) || now.model.patches.length !== before.model.patches.length) this.refit = this.fresh = true;
    }
    if (now.opened !== before.opened) this.refit = this.fresh = true;
    const shownBefore = before.compare !== now.compare;
    if (now.hover !== before.hover && now.model === before.model && now.settings === before.settings) this.hud.refresh(now, this.frame, this.sharp);
    if (now.model !== before.model || now.settings !== before.settings || now.patch !== before.patch || shownBefore || now.kept !== before.kept || now.saved !== before.saved || now.moving !== before.moving || now.selected !== before.selected) this.plan(true);
    if (now.joining !== before.joining) this.plan(true);
    if (now.aims !== before.aims || now.beside !== before.beside || now.lights !== before.lights) this.plan(true);
    if (now.message !== before.message || now.pins !== before.pins) this.plan();
  }

  /** Ask for a frame; `stale` when more than the camera changed. */
  plan(stale = false): void {
    this.stale ||= stale;
    if (this.planned) return;
    const asked = performance.now();
    this.planned = requestAnimationFrame((now) => {
      this.planned = 0;
      if (this.store.state.moving) this.painter.waited(performance.now() - asked);
      this.show(now);
    });
  }

  /** Draw what is planned before the browser paints: a canvas of a new size is empty. */
  private hurry(): void {
    if (!this.planned) return;
    cancelAnimationFrame(this.planned);
    this.planned = 0;
    this.show(performance.now());
  }

  private show(now: number): void {
    // Frames that follow each other quickly are part of a movement; one more is drawn when it is over.
    const quick = this.store.state.moving || now - this.shownAt < QUICK;
    this.shownAt = now;
    this.stage.economy(quick);
    clearTimeout(this.settling);
    if (quick && this.stage.software) this.settling = window.setTimeout(() => this.plan(), QUICK + 40);
    const gliding = this.stage.orbit.step(now);
    const start = performance.now();
    this.surfaces = 0;
    if (this.stale) {
      this.stale = false;
      this.work();
    }
    const worked = performance.now();
    this.stage.draw();
    this.hud.refresh(this.store.state, this.frame, this.sharp);
    this.root.dispatchEvent(new CustomEvent("drawn", { detail: { start, surfaces: this.surfaces, evaluated: worked - start, drawn: performance.now() - worked } }));
    if (gliding) this.plan();
  }

  /** Bring everything that follows from the state up to date. */
  private work(): void {
    const { state } = this.store, { settings } = state;
    this.dark = settings.theme === "dark" || (settings.theme === "auto" && this.darkAround());
    this.root.dataset["theme"] = this.dark ? "dark" : "light";
    const shown = cellsOf(this.store.state);
    if (this.stage.cells.length !== shown.length) this.fitAfter = true;
    this.stage.layout(shown.length, this.margin());
    if (this.refit) this.reframe(shown);
    this.surfaces = this.painter.evaluate(shown, state, this.frame);
    const { meshes } = this.painter;
    const q = QUANTITY[settings.quantity];
    this.range = q && meshes.length && q.colour !== "classes" ? rangeOf(meshes, q, settings) : null;
    const active = activePatch(state);
    if (state.model.patches.every(isCurve)) this.legend.element.hidden = true;
    else if (!q) this.legend.plain(settings.stripes !== "none");
    else if (this.range) this.legend.real(q.key, this.range, state.model.unit, this.dark);
    else this.legend.classes(q.key, meshes.map((mesh) => mesh.counts));
    this.stage.style(settings, this.range, this.dark, this.frame, state.patch);
    this.painter.decorate(shown, state, this.frame);
    if (this.fitAfter && this.from) this.stage.view(this.from, this.frame, true, this.margin());
    else if (this.fitAfter) this.stage.fit(this.frame, true, this.margin());
    this.from = null;
    this.fitAfter = false;
    this.sharp = settings.minRadius && !state.moving ? this.painter.sharpest() : [];
    this.bar.refresh(state);
    this.inspector.refresh(state, this.dark);
    this.aims?.refresh(state);
    this.model.refresh(state);
    this.model.body.refresh(state, this.painter.seams, this.dark);
    this.hud.labels(shown.map((one) => one.label), state);
    const surface = this.stage.cells[0]?.pieces[state.patch]?.surface ?? null;
    this.status.refresh(state, {
      side: this.painter.side, cost: this.painter.cost, singular: meshes.reduce((sum, mesh) => sum + mesh.singular, 0), points: meshes.reduce((sum, mesh) => sum + mesh.places, 0),
      sharp: this.sharp[0]?.at ?? null, surface, curve: isCurve(active) ? curveOf(active) : null, warning: warningOf(state, surface),
    });
  }

  /** Choose the frame of the picture anew from the surfaces shown. */
  private reframe(shown: readonly Shown[]): void {
    this.refit = false;
    const box = boxOf(shown);
    if (!box) return;
    this.frame = frameOf(box.low, box.high);
    const flat = shown.every(({ model }) => model.patches.every((patch) => isCurve(patch) && curveOf(patch).flat));
    if (this.fresh && (flat || this.flat)) this.from = flat ? "top" : "iso";
    [this.fresh, this.flat] = [false, flat];
    this.inspector.sectionBox(box);
    this.store.setting({ sectionAt: 0, snapStep: 10 ** Math.round(Math.log10(Math.max(2 / this.frame.scale, 1e-30) / 100)) });
    this.fitAfter = true;
  }

  /** Width of the strip that the legend covers, in CSS pixels. */
  private margin(): number {
    return this.legend.element.offsetWidth + 10;
  }

  private view(name: ViewName): void {
    this.stage.view(name, this.frame, still(), this.margin());
    this.plan();
  }

  private fit(): void {
    this.refit = true;
    this.plan(true);
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.centre;
    if (!width || !height) return;
    this.stage.resize(width, height, Math.min(2, devicePixelRatio || 1));
    // A view that nobody has moved stays fitted.
    this.fitAfter ||= !this.stage.orbit.moved;
    this.plan(true);
  }

  /** Whether the window, or the page around the viewer, is dark. */
  private darkAround(): boolean {
    if (this.host.kind === "notebook" && document.body.dataset["jpThemeLight"]) return document.body.dataset["jpThemeLight"] === "false";
    const wanted = matchMedia("(prefers-color-scheme: dark)").matches;
    // A page that says nothing of dark is light whatever the system prefers.
    return wanted && (this.host.kind === "live" || getComputedStyle(document.documentElement).colorScheme.includes("dark"));
  }

  private switchTheme(): void {
    this.store.setting({ theme: this.dark ? "light" : "dark" });
  }

  private async picture(choice: PictureChoice): Promise<HTMLCanvasElement> {
    const style = getComputedStyle(this.root);
    const background = choice.background === "white" ? "#ffffff" : choice.background === "theme" ? style.getPropertyValue("--ground-flat").trim() : null;
    const image = await this.stage.picture(choice.width, choice.height, background);
    const { state } = this.store;
    return compose(image, choice, state, this.range, this.stage.cells, cellsOf(this.store.state).map((one) => one.label), this.dark && choice.background === "theme");
  }

  /** Where the handle of a control point, or a grip of the section plane, is in the window, in CSS pixels; null where there is none. */
  locate(id: string): { x: number; y: number } | null {
    const { state } = this.store, patch = state.model.patches[state.patch]!, grips = sectionGrips(state.settings, this.frame);
    const handle = handlesOf(patch).find((one) => one.id === id);
    if (!handle && id !== "move" && id !== "tilt") return null;
    const p = this.stage.project(0, handle ? toScene(this.frame, handle.position) : grips[id as "move" | "tilt"]), box = this.canvas.getBoundingClientRect();
    return { x: box.left + p.x, y: box.top + p.y };
  }

  /** Show another model that came from outside, such as a notebook's kernel. */
  receive(model: Model): void {
    this.store.open(model, null);
  }

  dispose(): void {
    cancelAnimationFrame(this.planned);
    clearTimeout(this.settling);
    this.stage.dispose();
    this.container.replaceChildren();
  }
}
