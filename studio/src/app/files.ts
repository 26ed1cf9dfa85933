/** Opening, saving, pictures and exports. */

import type { Model } from "../numerics/model";
import { toDict } from "../numerics/model";
import { toToml } from "../toml";
import { QUANTITY, unitOf } from "../numerics/quantity";
import type { Item } from "../ui/controls";
import { ask, askName, askPicture, askTolerance, type PictureChoice } from "../ui/dialogs";
import { download, fileName, h } from "../ui/dom";
import { short } from "../ui/format";
import { Conflict, Lost, type Format, type Host } from "./host";
import { activePatch, type Store } from "./state";

const LARGEST = 16 * 2 ** 20;
const BEAT = 15_000; // ms between looks at whether the server is there

export class Files {
  private known: readonly string[] = [];
  private formats: readonly Format[] = [];
  /** The model and patch that the formats were asked for. */
  private asked = "";
  private lost = false;

  constructor(
    private readonly store: Store, private readonly host: Host, private readonly root: () => HTMLElement,
    private readonly draw: (choice: PictureChoice) => Promise<HTMLCanvasElement>, private readonly size: () => readonly [number, number],
    private readonly ends: () => readonly [number, number] | null,
  ) {
    void this.look();
  }

  /** Ask the server what there is to open. */
  async look(): Promise<void> {
    try {
      this.known = await this.host.list();
    } catch {
      this.known = [];
    }
  }

  /** Ask the server what the model can be exported to; whether that is news. */
  async lookAtFormats(): Promise<boolean> {
    const { state } = this.store, patch = activePatch(state).name, wanted = `${patch}\n${toToml(state.model)}`;
    if (wanted === this.asked) return false;
    this.asked = wanted;
    try {
      this.formats = await this.host.formats(state.model, patch);
    } catch {
      this.asked = "";
    }
    return true;
  }

  openItems(): (Item | string)[] {
    const here = this.known.map((name) => ({ label: name, act: () => void this.load(name) }));
    return [{ label: "From this computer …", hint: "or drop a file on the picture", act: () => this.choose() }, ...(here.length ? ["In the folder", ...here] : [])];
  }

  saveItems(): (Item | string)[] {
    const { model, source } = this.store.state;
    const live = this.host.kind === "live";
    return [
      ...(live ? [{ label: source ? `Save ${source.name}` : "Save …", hint: "Ctrl S", act: () => void this.save() }, { label: "Save as …", act: () => void this.saveAs() }] : []),
      { label: "Download TOML", act: () => download(`${fileName(model.name)}.toml`, toToml(model)) },
      { label: "Download JSON", act: () => download(`${fileName(model.name)}.json`, `${JSON.stringify(toDict(model), null, 1)}\n`, "application/json") },
    ];
  }

  exportItems(): (Item | string)[] {
    if (this.host.kind !== "live") return [{ label: "Exports need the live studio", hint: "quintrig view MODEL", disabled: true, act: () => {} }];
    if (!this.formats.length) return [{ label: "Asking what this model can be written as …", disabled: true, act: () => {} }];
    const families = [...new Set(this.formats.map((format) => format.family))];
    return families.flatMap((family) => [family, ...this.formats.filter((format) => format.family === family).map((format) => ({
      label: format.label, hint: format.suffix, ...(format.reason ? { disabled: true, reason: format.reason } : {}), act: () => void this.guard(() => this.export(format)),
    }))]);
  }

  /** Let the server write a file of the model as it is now, and tell what it tells. */
  private async export(format: Format): Promise<void> {
    const { model, settings } = this.store.state, patch = activePatch(this.store.state).name, ends = this.ends();
    const q = QUANTITY[settings.quantity];
    const coloured = q ? `${q.name}${ends ? `, ${short(ends[0])} to ${short(ends[1])} ${unitOf(q, model.unit)}` : ""}`.trim() : "none";
    const answer = format.takes ? await askTolerance(this.root(), format.label, model.unit, format.takes === "tolerance" ? "" : coloured) : { tolerance: null };
    if (!answer) return;
    this.store.set({ message: { kind: "note", text: `Writing ${format.label} …`, lines: [] } });
    const order = { model, patch, colour: q ? settings.quantity : "", low: ends?.[0] ?? null, high: ends?.[1] ?? null, ...answer };
    const { name, notes } = await this.host.export(order, format);
    this.store.set({ message: { kind: "note", text: `Exported ${name}`, lines: notes } });
  }

  /** Start on a preset or starter. */
  async start(model: Model): Promise<void> {
    if (await this.leave()) this.store.open(model, null);
  }

  async load(name: string): Promise<void> {
    await this.guard(async () => {
      const { model, source } = await this.host.load(name);
      // Asked last, so that nothing changed while the file was on its way is lost.
      if (await this.leave()) this.store.open(model, source);
    });
  }

  choose(): void {
    const input = h("input", { type: "file", accept: ".toml,.json" });
    input.addEventListener("change", () => {
      const file = input.files?.[0];
      if (file) void this.take(file);
    });
    input.click();
  }

  /** Open a dropped or chosen file; a bad one leaves the work as it is. */
  async take(file: File): Promise<void> {
    await this.guard(async () => {
      if (file.size > LARGEST) throw new Error(`${file.name}: expected at most 16 MB, found ${Math.round(file.size / 2 ** 20)} MB; is this a model?`);
      const model = await this.host.read(file.name, await file.text());
      if (await this.leave()) this.store.open(model, null);
    });
  }

  /** Open what is dropped on an element. */
  receive(element: HTMLElement): void {
    element.addEventListener("dragover", (event) => {
      event.preventDefault();
      element.classList.add("receiving");
    });
    element.addEventListener("dragleave", () => element.classList.remove("receiving"));
    element.addEventListener("drop", (event) => {
      event.preventDefault();
      element.classList.remove("receiving");
      const file = event.dataTransfer?.files[0];
      if (file) void this.take(file);
    });
  }

  async save(): Promise<void> {
    const { source } = this.store.state;
    if (source) await this.write(source.name, source.tag);
    else await this.saveAs();
  }

  async saveAs(): Promise<void> {
    const name = this.host.kind === "live" ? await askName(this.root(), "Save as", `${fileName(this.store.state.model.name)}.toml`) : this.store.state.model.name;
    if (name) await this.write(name, "");
  }

  async picture(): Promise<void> {
    const [width, height] = this.size();
    const choice = await askPicture(this.root(), 2 * width, 2 * height);
    if (!choice) return;
    const canvas = await this.draw(choice);
    canvas.toBlob((blob) => blob && download(`${fileName(this.store.state.model.name)}.png`, blob), "image/png");
  }

  private async write(name: string, tag: string | null): Promise<void> {
    const { model, opened } = this.store.state;
    try {
      const source = await this.host.save(name, model, tag);
      this.store.written(opened, model, source);
      this.store.set({ message: { kind: "note", text: source ? `Saved ${source.name}` : "Downloaded" } });
      void this.look();
    } catch (error) {
      if (!(error instanceof Conflict)) return this.fail(error);
      const answer = await ask(this.root(), "The file is another one now", [h("p", {}, error.message)], [["other", "Save under another name"], ["over", "Overwrite it"], ["cancel", "Cancel"]]);
      if (answer === "over") await this.write(name, null);
      if (answer === "other") await this.saveAs();
    }
  }

  /** Ask before unsaved work is left. */
  private async leave(): Promise<boolean> {
    const { model, saved } = this.store.state;
    if (model === saved) return true;
    const answer = await ask(this.root(), "Leave this model?", [h("p", {}, `The changes to “${model.name}” are not saved.`)], [["stay", "Go on working"], ["leave", "Leave them"]]);
    return answer === "leave";
  }

  private async guard(act: () => Promise<void>): Promise<void> {
    try {
      await act();
    } catch (error) {
      this.fail(error);
    }
  }

  /** Notice that the server has stopped or is another one, also while nothing is asked of it. */
  watch(): void {
    const look = () => void this.connected();
    window.addEventListener("focus", look);
    setInterval(() => document.visibilityState === "visible" && look(), BEAT);
  }

  /** Tell once when the server is lost, and when it is there again. */
  private async connected(): Promise<void> {
    try {
      await this.host.list();
      if (this.lost) this.store.set({ message: { kind: "note", text: "Connected to the studio's server again" } });
      if (this.lost) void this.look();
      this.lost = false;
    } catch (error) {
      if (error instanceof Lost && !this.lost) this.fail(error);
    }
  }

  private fail(error: unknown): void {
    const { message } = error as Error;
    if (!(error instanceof Lost)) return this.store.set({ message: { kind: "error", text: message } });
    this.lost = true;
    const { source } = this.store.state;
    this.store.set({
      message: {
        kind: "error", text: message, lines: [
          `To reconnect: ${error.stopped ? `run “quintrig view ${source?.name ?? "MODEL"}” in a terminal, ` : ""}open the address that quintrig view printed in this browser, then try again here.`,
          "Or download the model, and open it in the new tab.",
        ],
        actions: [
          { label: "Download the model", act: () => this.download() },
          { label: "Try again", act: () => void this.again() },
        ],
      },
    });
  }

  /** Ask the server anew, and say so when it is still not there. */
  private async again(): Promise<void> {
    this.store.set({ message: null });
    await this.guard(async () => void (await this.host.list()));
    await this.connected();
  }

  private download(): void {
    const { model, source } = this.store.state;
    download(source?.name.replace(/\.\w+$/, ".toml") ?? `${fileName(model.name)}.toml`, toToml(model));
  }
}
