/**
 * Unsaved work, kept in this browser: one draft a tab and model. A tab holds a lock as long as it lives, so that the
 * drafts of other living tabs are left alone and only those of closed ones are offered. A draft carries the file it is
 * a change of, and that file's tag: restored, it can only be saved there, and only over the version it was made from.
 */

import { learnBases, toldBases, type ToldBasis } from "../numerics/library";
import { fromDict, toDict } from "../numerics/model";
import type { Source, State, Store, Work } from "./state";

const PREFIX = "quintrig:draft:";

/** Where a question with two answers is put; the function returned takes it back. */
interface Asker {
  offer(text: string, yes: string, act: () => void, no: string, refuse: () => void): () => void;
}

interface Draft extends Omit<Work, "opened"> {
  readonly key: string;
  readonly when: number;
}

/** What a draft is in the browser's storage. */
interface Stored {
  readonly when: number;
  readonly model: unknown;
  readonly saved?: unknown;
  readonly source?: Source | null;
  /** Bases that the page does not have by itself. */
  readonly library?: readonly ToldBasis[];
}

const MOST_OFFERS = 3;

export class Drafts {
  private readonly key: string;
  private offers: (() => void)[] = [];

  constructor(private readonly place: string) {
    const tab = Math.random().toString(36).slice(2, 10);
    this.key = `${PREFIX}${place}:${tab}`;
    // Held until the tab is gone; without locks (a page from disk in some browsers) every draft is offered.
    void navigator.locks?.request(this.key, () => new Promise(() => {})).catch(() => {});
  }

  /** Keep what is unsaved in a store, from now on, and offer what closed tabs left; a drag is kept when it pauses. */
  watch(store: Store, asker: Asker): void {
    let timer = 0;
    const now = () => this.keep(store.state);
    store.subscribe((state, before) => {
      if (state.opened !== before.opened) void this.offer(store, asker, state.source);
      if (state.model === before.model && state.saved === before.saved && state.source === before.source) return;
      clearTimeout(timer);
      if (state.model === state.saved) now();
      else timer = window.setTimeout(now, 400);
    });
    window.addEventListener("pagehide", now);
    void this.offer(store, asker);
  }

  /** Offer what closed tabs left: of every file, or of the one that is open now. */
  private async offer(store: Store, asker: Asker, only?: Source | null): Promise<void> {
    for (const withdraw of this.offers.splice(0)) withdraw();
    const { opened } = store.state, left = await this.left();
    if (store.state.opened !== opened) return; // another file was opened meanwhile, and asks for itself
    const wanted = only === undefined ? left : left.filter((draft) => only && draft.source?.name === only.name);
    this.offers = wanted.slice(0, MOST_OFFERS).map((draft) => {
      const when = new Date(draft.when).toLocaleString([], { dateStyle: "medium", timeStyle: "short" });
      const file = draft.source ? ` (${draft.source.name})` : "";
      return asker.offer(`Unsaved work on “${draft.model.name}”${file} from ${when} was kept.`, "Restore it", () => {
        store.resume(draft);
        // The old draft goes only when this tab has its own.
        if (this.keep(store.state)) drop(draft.key);
      }, "Discard", () => drop(draft.key));
    });
  }

  /** Keep a model with its file, or forget it when there is nothing unsaved; false where nothing can be kept. */
  private keep({ model, saved, source }: State): boolean {
    try {
      if (model === saved) localStorage.removeItem(this.key);
      else localStorage.setItem(this.key, JSON.stringify({ when: Date.now(), model: toDict(model), saved: toDict(saved), source, library: toldBases() }));
      return true;
    } catch {
      return false; // no storage here, or it is full
    }
  }

  /** The drafts for this place that no living tab owns, the newest first. */
  private async left(): Promise<Draft[]> {
    const held = new Set((await navigator.locks?.query().catch(() => null))?.held?.map((lock) => lock.name) ?? []);
    const found: Draft[] = [];
    for (const key of keys()) {
      if (!key.startsWith(`${PREFIX}${this.place}:`) || key === this.key || held.has(key)) continue;
      try {
        const { when, model, saved, source, library } = JSON.parse(localStorage.getItem(key)!) as Stored;
        learnBases(library ?? []);
        const drawn = fromDict(model);
        // A draft of an earlier version says nothing of its file: it has none.
        found.push({ key, when, model: drawn, saved: saved ? fromDict(saved) : { ...drawn }, source: source ?? null });
      } catch {
        drop(key); // not ours, or of another version
      }
    }
    return found.sort((a, b) => b.when - a.when);
  }
}

function drop(key: string): void {
  localStorage.removeItem(key);
}

function keys(): string[] {
  try {
    return Object.keys(localStorage);
  } catch {
    return [];
  }
}
