/** The studio put together: state, panels and picture, and what has to be worked out again after a change. */

import { polylines, handles } from "../edit/handles";
import { build, type Model, type Patch } from "../numerics/model";
import { QUANTITY } from "../numerics/quantity";
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
import { sharpest, type Sharpest } from "../view/radius";
import { toothOf } from "../view/overlays";
import { rangeOf, type Range } from "../view/range";
import { Stage, type Cell, type Piece } from "../view/stage";
import { boxOf, cellsOf, type Box, type Shown } from "./cells";
import { Drafts } from "./drafts";
import { Files } from "./files";
import type { Host } from "./host";
import { press } from "./keys";
import { listen, still } from "./pointer";
import { remembered, type Settings } from "./settings";
import { Store, type Source, type State } from "./state";
import { warningOf } from "./warning";

const FRAME_BUDGET = 9; // ms that evaluating everything may take while something moves

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
  private readonly probe: ProbePanel;
  private readonly status: StatusBar;
  private readonly files: Files;
  private readonly drafts: Drafts;
  private frame: Frame = UNIT_FRAME;
  private range: Range | null = null;
  private sharp: { cell: number; at: Sharpest }[] = [];
  private planned = 0;
  private dark = false;
  private stale = true;
  private coarse = 75;
  private cost = 0;
  private refit = true;
  private fitAfter = false;
  private box: Box = { low: [0, 0, 0], high: [1, 1, 1] };

  constructor(private readonly container: HTMLElement, private readonly host: Host, start: Start) {
    const settings: Settings = { ...remembered(), ...(start.quantity ? { quantity: start.quantity } : {}) };
    this.store = new Store({
      model: start.model, saved: start.model, source: start.source, patch: 0, selected: null, settings, compare: "off", kept: [], pins: [],
      hover: null, canUndo: false, canRedo: false, moving: false, message: null, opened: 1,
    });
    const { store } = this;
    this.stage = new Stage(this.canvas);
    this.files = new Files(store, host, () => this.root, (choice) => this.picture(choice), () => [this.centre.clientWidth, this.centre.clientHeight]);
    this.bar = new TopBar(store, this.files, () => this.switchTheme(), () => void showHelp(this.root), host.kind !== "live");
    this.model = new ModelPanel(store);
    this.inspector = new Inspector(store);
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
    this.root.addEventListener("keydown", (event) => {
      if (press(event, { store, stage: this.stage, files: this.files, frame: () => this.frame, fit: () => this.fit(), view: (name) => this.view(name), redraw: () => this.plan(), help: () => void showHelp(this.root) })) event.preventDefault();
    });
    this.files.receive(this.root);
    new ResizeObserver(() => this.resize()).observe(this.centre);
    const scheme = matchMedia("(prefers-color-scheme: dark)");
    scheme.addEventListener("change", () => this.plan(true));
    store.subscribe((now, before) => this.changed(now, before, start));
    if (!this.stage.works) this.status.warn("This browser has no WebGL: you see still pictures. Everything else works.");
    this.resize();
    this.plan(true);
    if (host.kind !== "notebook") {
      this.drafts.watch(store);
      void this.drafts.offer(this.status, (model) => {
        this.refit = true;
        store.edit(model);
      });
    }
  }

  private changed(now: State, before: State, start: Start): void {
    if (now.model !== before.model) {
      start.onModel?.(now.model);
      if (now.model.patches.some((patch, i) => patch.kind !== before.model.patches[i]?.kind) || now.model.patches.length !== before.model.patches.length) this.refit = true;
    }
    if (now.opened !== before.opened) this.refit = true;
    if (now.settings.sectionAxis !== before.settings.sectionAxis) this.placeSection();
    const shownBefore = before.compare !== now.compare;
    if (now.hover !== before.hover && now.model === before.model && now.settings === before.settings) this.hud.refresh(now, this.frame, this.sharp);
    if (now.model !== before.model || now.settings !== before.settings || now.patch !== before.patch || shownBefore || now.kept !== before.kept || now.saved !== before.saved || now.moving !== before.moving || now.selected !== before.selected) this.plan(true);
    if (now.message !== before.message || now.pins !== before.pins) this.plan();
  }

  /** Ask for a frame; `stale` when more than the camera changed. */
  plan(stale = false): void {
    this.stale ||= stale;
    this.planned ||= requestAnimationFrame((now) => {
      this.planned = 0;
      this.show(now);
    });
  }

  private show(now: number): void {
    const gliding = this.stage.orbit.step(now);
    const start = performance.now();
    if (this.stale) {
      this.stale = false;
      this.work();
    }
    const worked = performance.now();
    this.stage.draw();
    this.hud.refresh(this.store.state, this.frame, this.sharp);
    this.root.dispatchEvent(new CustomEvent("drawn", { detail: { evaluated: worked - start, drawn: performance.now() - worked } }));
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
    const side = this.side(settings, state.moving, shown.length);
    if (this.refit) this.reframe(shown);
    const start = performance.now();
    let points = 0;
    shown.forEach(({ model }, i) => {
      const cell = this.stage.cells[i]!;
      cell.resizePieces(model.patches.length);
      model.patches.forEach((patch, k) => (points += this.evaluate(cell.pieces[k]!, patch, side, settings)));
    });
    if (points) this.pace(performance.now() - start, points, settings.resolution);
    const meshes = this.stage.cells.flatMap((cell) => cell.pieces.map((piece) => piece.mesh));
    const q = QUANTITY[settings.quantity];
    this.range = q && q.colour !== "classes" ? rangeOf(meshes, q, settings) : null;
    if (!q) this.legend.plain();
    else if (this.range) this.legend.real(q.key, this.range, state.model.unit, this.dark);
    else this.legend.classes(q.key, meshes.map((mesh) => mesh.values));
    this.stage.style(settings, this.range, this.dark, this.frame, state.patch);
    const tooth = settings.combs === "off" ? 0 : toothOf(meshes, settings, this.frame);
    shown.forEach(({ editable }, i) => this.decorate(this.stage.cells[i]!, state, editable, tooth));
    if (this.fitAfter) this.stage.fit(true, this.margin());
    this.fitAfter = false;
    this.sharp = settings.minRadius && !state.moving ? this.sharpestOf(shown) : [];
    this.bar.refresh(state);
    this.inspector.refresh(state, this.dark);
    this.model.refresh(state);
    this.hud.labels(shown.map((one) => one.label));
    const surface = this.stage.cells[0]?.pieces[state.patch]?.surface ?? null;
    this.status.refresh(state, {
      side, cost: this.cost, singular: meshes.reduce((sum, mesh) => sum + mesh.singular, 0), points: meshes.reduce((sum, mesh) => sum + mesh.grid.count, 0),
      sharp: this.sharp[0]?.at ?? null, surface, warning: warningOf(state, surface),
    });
  }

  /** Evaluate a piece where its patch, resolution or frame changed; the number of points worked out. */
  private evaluate(piece: Piece, patch: Patch, side: number, settings: Settings): number {
    const same = piece.patch === patch && piece.side === side && piece.frame === this.frame;
    if (same && piece.quantity !== settings.quantity) piece.mesh.paint(settings.quantity);
    piece.quantity = settings.quantity;
    if (same) return 0;
    try {
      if (piece.patch !== patch) piece.surface = build(patch);
    } catch (error) {
      this.status.warn((error as Error).message);
      return 0;
    }
    piece.patch = patch;
    piece.side = side;
    piece.frame = this.frame;
    piece.settings = null;
    piece.mesh.update(piece.surface!, side, settings.quantity, this.frame);
    return side * side;
  }

  private decorate(cell: Cell, state: State, editable: boolean, tooth: number): void {
    cell.pieces.forEach((piece, i) => {
      if (!piece.surface || !piece.patch) return;
      if (piece.settings !== state.settings || piece.tooth !== tooth) piece.overlays.update(piece.mesh, state.settings, this.frame, tooth);
      piece.settings = state.settings;
      piece.tooth = tooth;
      const net = state.settings.net;
      const grips = net && editable && i === state.patch ? handles(piece.patch, piece.surface) : [];
      piece.overlays.net(net ? polylines(piece.patch, piece.surface) : [], grips, state.selected, this.frame);
    });
  }

  /** Points a side: as many as can be afforded while something moves, more at rest where classes have edges. */
  private side(settings: Settings, moving: boolean, cells: number): number {
    if (moving) return Math.min(settings.resolution, this.coarse);
    return QUANTITY[settings.quantity]?.colour === "classes" && cells === 1 ? 2 * settings.resolution : settings.resolution;
  }

  /** Choose how many points a side leave a frame's time while something moves. */
  private pace(time: number, points: number, full: number): void {
    this.cost = time;
    const perPoint = time / points, cells = Math.max(1, this.stage.cells.reduce((sum, cell) => sum + cell.pieces.length, 0));
    const fits = Math.sqrt(FRAME_BUDGET / perPoint / cells);
    this.coarse = fits >= full ? full : Math.max(36, Math.min(full, Math.round(fits)));
  }

  /** Choose the frame of the picture anew from the surfaces shown. */
  private reframe(shown: readonly Shown[]): void {
    this.refit = false;
    const box = boxOf(shown);
    if (!box) return;
    this.box = box;
    this.frame = frameOf(box.low, box.high);
    this.placeSection();
    this.store.setting({ snapStep: 10 ** Math.round(Math.log10(Math.max(2 / this.frame.scale, 1e-30) / 100)) });
    this.fitAfter = true;
  }

  /** Let the section plane run over the surface on its axis, and stand in the middle. */
  private placeSection(): void {
    const axis = { x: 0, y: 1, z: 2 }[this.store.state.settings.sectionAxis];
    this.inspector.sectionRange(this.box.low[axis]!, this.box.high[axis]!);
    this.store.setting({ sectionAt: Number(this.frame.centre[axis]!.toPrecision(4)) });
  }

  /** Width of the strip that the legend covers, in CSS pixels. */
  private margin(): number {
    return this.legend.element.offsetWidth + 10;
  }

  private sharpestOf(shown: readonly Shown[]): { cell: number; at: Sharpest }[] {
    return shown.flatMap((_, cell) => {
      const found = this.stage.cells[cell]!.pieces.map((piece) => (piece.surface ? sharpest(piece.surface, piece.mesh) : null)).filter((one) => one !== null);
      const least = found.sort((a, b) => a.radius - b.radius)[0];
      return least ? [{ cell, at: least }] : [];
    });
  }

  private view(name: ViewName): void {
    this.stage.view(name, still(), this.margin());
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

  /** Where the handle of a control point is in the window, in CSS pixels; null where there is none. */
  locate(id: string): { x: number; y: number } | null {
    const { state } = this.store, patch = state.model.patches[state.patch]!;
    const handle = handles(patch, build(patch)).find((one) => one.id === id);
    if (!handle) return null;
    const p = this.stage.project(0, toScene(this.frame, handle.position)), box = this.canvas.getBoundingClientRect();
    return { x: box.left + p.x, y: box.top + p.y };
  }

  /** Show another model that came from outside, such as a notebook's kernel. */
  receive(model: Model): void {
    this.store.open(model, null);
  }

  dispose(): void {
    cancelAnimationFrame(this.planned);
    this.stage.dispose();
    this.container.replaceChildren();
  }
}
