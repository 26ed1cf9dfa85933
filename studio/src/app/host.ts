/** What the studio can ask of the world it runs in: the local server, a page from disk, or a notebook. */

import type { Built } from "../numerics/built";
import { fromDict, ModelError, type Model, type Patch } from "../numerics/model";
import { fromToml, toToml } from "../toml";
import { download, fileName } from "../ui/dom";
import type { Aims, Beside, Light } from "./aims";
import type { Proved } from "./proofs";
import type { Source } from "./state";

/** A kind of file that can be exported to, as in Python's table. */
export interface Format {
  /** The ending, with its dot. */
  readonly suffix: string;
  readonly label: string;
  readonly family: string;
  /** Why it cannot be written here or of this model; empty where it can. */
  readonly reason: string;
  /** What can be said of it before: tolerance, and colours too for a mesh. */
  readonly takes: "" | "tolerance" | "tolerance and colours";
}

/** What an export is of: a flat pattern is of one patch, a mesh is coloured by a quantity between the ends of its map. */
export interface Order {
  readonly model: Model;
  readonly patch: string;
  readonly colour: string;
  readonly low: number | null;
  readonly high: number | null;
  /** Length¹; null for the usual one. */
  readonly tolerance: number | null;
}

/** The file that was handed over, and what to tell about it. */
export interface Delivered {
  readonly name: string;
  readonly notes: readonly string[];
}

export interface Opened {
  readonly model: Model;
  readonly source: Source | null;
}

/** The version on disk is another one than was read. */
export class Conflict extends Error {}

/** The server that the page came from does not answer any more, or another one does, to which the page has no key. */
export class Lost extends Error {
  constructor(readonly stopped: boolean) {
    super(`${stopped ? "The studio's server has stopped: it does not answer." : "The studio's server was started anew, and does not know this tab."} Your work is still here, and unsaved changes are kept in this browser.`);
  }
}

export interface Host {
  readonly kind: "live" | "embedded" | "notebook";
  /** Key under which unsaved work is kept. */
  readonly place: string;
  /** Model files that can be opened by name. */
  list(): Promise<readonly string[]>;
  load(name: string): Promise<Opened>;
  /** Read what was dropped or chosen; ModelError with the message of the command line. */
  read(name: string, text: string): Promise<Model>;
  /** Save under a name; null where saving is a download. Conflict when the file on disk is another than was read. */
  save(name: string, model: Model, tag: string | null): Promise<Source | null>;
  formats(model: Model, patch: string): Promise<readonly Format[]>;
  export(order: Order, format: Format): Promise<Delivered>;
  /** Decide a claim on all points of a model; only where a server does it. */
  prove?(model: Model, claim: string): Promise<Proved>;
}

/** A page without a server: files are read here and saved as downloads. */
export class PageHost implements Host {
  constructor(readonly kind: "embedded" | "notebook", readonly place: string) {}

  list(): Promise<readonly string[]> {
    return Promise.resolve([]);
  }

  load(name: string): Promise<Opened> {
    return Promise.reject(new ModelError(`${name}: a page from disk has no folder to open files from`));
  }

  read(name: string, text: string): Promise<Model> {
    return new Promise((done) => done(parse(name, text)));
  }

  save(name: string, model: Model): Promise<Source | null> {
    download(`${fileName(name.replace(/\.(toml|json)$/i, ""))}.toml`, toToml(model));
    return Promise.resolve(null);
  }

  formats(): Promise<readonly Format[]> {
    return Promise.resolve([]);
  }

  export(): Promise<Delivered> {
    return Promise.reject(new Error("exports need the live studio: quintrig view MODEL"));
  }
}

/** `quintrig view`: the server on this machine reads, checks, saves and exports. */
export class LiveHost implements Host {
  readonly kind = "live";
  constructor(readonly place: string) {}

  async list(): Promise<readonly string[]> {
    return ((await this.ask("GET", "api/files")) as { files: string[] }).files;
  }

  async load(name: string): Promise<Opened> {
    return opened(await this.ask("GET", `api/files/${encodeURIComponent(name)}`));
  }

  async read(name: string, text: string): Promise<Model> {
    const answer = (await this.ask("POST", "api/check", JSON.stringify({ name, text }))) as { model: unknown };
    return fromDict(answer.model);
  }

  async save(name: string, model: Model, tag: string | null): Promise<Source | null> {
    const body = JSON.stringify({ text: toToml(model), tag });
    return (await this.ask("PUT", `api/files/${encodeURIComponent(name)}`, body)) as Source;
  }

  async formats(model: Model, patch: string): Promise<readonly Format[]> {
    return ((await this.ask("POST", "api/formats", JSON.stringify({ text: toToml(model), patch }))) as { formats: Format[] }).formats;
  }

  async export({ model, ...order }: Order, { suffix }: Format): Promise<Delivered> {
    const body = JSON.stringify({ text: toToml(model), suffix, ...order });
    const { name, notes, content } = (await this.ask("POST", "api/export", body)) as Delivered & { content: string };
    download(name, new Blob([Uint8Array.from(atob(content), (letter) => letter.charCodeAt(0))]));
    return { name, notes };
  }

  /** Files of the folder that may be shown beside the model. */
  async targets(): Promise<readonly string[]> {
    return ((await this.ask("GET", "api/targets")) as { targets: string[] }).targets;
  }

  /** At most so many points of the target with their distances from the model. */
  async beside(model: Model, { target, align, tolerance }: Aims, most: number): Promise<Beside> {
    const body = JSON.stringify({ text: toToml(model), target, align: align ? "yes" : "", tolerance, most });
    const { places, distances, ...told } = (await this.ask("POST", "api/deviation", body)) as Omit<Beside, "places" | "distances"> & { places: string; distances: string };
    return { ...told, places: numbers(places), distances: numbers(distances) };
  }

  /** What comes of demands on a patch as it is. */
  async lights(model: Model, patch: string, { demands, target }: Aims): Promise<readonly Light[]> {
    return ((await this.ask("POST", "api/demands", JSON.stringify({ text: toToml(model), patch, demands, target }))) as { lights: Light[] }).lights;
  }

  /** The model with a patch of least thin-plate energy, by one control point (`only`) or by all; and that energy. */
  async fairer(model: Model, patch: string, only: string): Promise<{ model: Model; before: number; after: number; notes: readonly string[] }> {
    const answer = (await this.ask("POST", "api/fair", JSON.stringify({ text: toToml(model), patch, only }))) as { model: unknown; before: number; after: number; notes: string[] };
    return { ...answer, model: fromDict(answer.model) };
  }

  /** What comes of a claim on the model, box by box. */
  async prove(model: Model, claim: string): Promise<Proved> {
    return (await this.ask("POST", "api/prove", JSON.stringify({ text: toToml(model), claim }))) as Proved;
  }

  /** The surfaces of patches that the page cannot build. */
  async build(patches: readonly Patch[]): Promise<readonly Built[]> {
    return ((await this.ask("POST", "api/build", JSON.stringify({ patches: JSON.stringify(patches) }))) as { built: Built[] }).built;
  }

  private async ask(method: string, path: string, body?: string): Promise<unknown> {
    return (await this.send(method, path, body)).json();
  }

  private async send(method: string, path: string, body?: string): Promise<Response> {
    let answer: Response;
    try {
      answer = await fetch(path, { method, body: body ?? null, ...(body ? { headers: { "Content-Type": "application/json" } } : {}) });
    } catch {
      throw new Lost(true);
    }
    if (answer.ok) return answer;
    const said = (await answer.json().catch(() => null)) as { error?: string } | null;
    // A refusal without a reason of its own is that of a server with another token, or of another program there.
    if (answer.status === 403 && !said) throw new Lost(false);
    const text = said?.error ?? `the server answered ${answer.status}`;
    if (answer.status === 409) throw new Conflict(text);
    throw answer.status === 422 ? new ModelError(text) : new Error(text);
  }
}

/** Numbers as the server sends them: little-endian doubles in base 64. */
const numbers = (text: string): Float64Array => new Float64Array(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer);

export function opened(answer: unknown): Opened {
  const { model, name, tag } = answer as { model: unknown; name: string; tag: string };
  return { model: fromDict(model), source: name ? { name, tag } : null };
}

function parse(name: string, text: string): Model {
  try {
    if (/\.toml$/i.test(name)) return fromDict(fromToml(text));
    if (!/\.json$/i.test(name)) throw new ModelError("expected a file ending in .toml or .json");
    let data: unknown;
    try {
      data = JSON.parse(text);
    } catch (error) {
      throw new ModelError(`not valid JSON: ${(error as Error).message}`);
    }
    return fromDict(data);
  } catch (error) {
    throw new ModelError(`${name}: ${(error as Error).message}`);
  }
}
