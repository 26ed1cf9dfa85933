/**
 * Unsaved work, kept in this browser: one draft a tab and model. A tab holds a lock as long as it lives, so that the
 * drafts of other living tabs are left alone and only those of closed ones are offered.
 */

import { fromDict, toDict, type Model } from "../numerics/model";
import type { Store } from "./state";

const PREFIX = "quintrig:draft:";

/** Where a question with two answers is put. */
interface Asker {
  offer(text: string, yes: string, act: () => void, no: string, refuse: () => void): void;
}

interface Draft {
  readonly key: string;
  readonly when: number;
  readonly model: Model;
}

export class Drafts {
  private readonly key: string;

  constructor(private readonly place: string) {
    const tab = Math.random().toString(36).slice(2, 10);
    this.key = `${PREFIX}${place}:${tab}`;
    // Held until the tab is gone; without locks (a page from disk in some browsers) every draft is offered.
    void navigator.locks?.request(this.key, () => new Promise(() => {})).catch(() => {});
  }

  /** Keep what is unsaved in a store, from now on; a drag is kept when it pauses. */
  watch(store: Store): void {
    let timer = 0;
    const now = () => this.keep(store.state.model === store.state.saved ? null : store.state.model);
    store.subscribe((state, before) => {
      if (state.model === before.model && state.saved === before.saved) return;
      clearTimeout(timer);
      if (state.model === state.saved) now();
      else timer = window.setTimeout(now, 400);
    });
    window.addEventListener("pagehide", now);
  }

  /** Offer what a closed tab left; `restore` gets the model. */
  async offer(asker: Asker, restore: (model: Model) => void): Promise<void> {
    const left = await this.left();
    if (!left) return;
    const when = new Date(left.when).toLocaleString([], { dateStyle: "medium", timeStyle: "short" });
    asker.offer(`Unsaved work on “${left.model.name}” from ${when} was kept.`, "Restore it", () => {
      void this.forget();
      restore(left.model);
    }, "Discard", () => void this.forget());
  }

  /** Keep a model, or forget it when there is nothing unsaved. */
  keep(model: Model | null): void {
    try {
      if (model) localStorage.setItem(this.key, JSON.stringify({ when: Date.now(), model: toDict(model) }));
      else localStorage.removeItem(this.key);
    } catch {
      // No storage here: nothing can be kept.
    }
  }

  /** The newest draft for this place that no living tab owns. */
  async left(): Promise<Draft | null> {
    const held = new Set((await navigator.locks?.query().catch(() => null))?.held?.map((lock) => lock.name) ?? []);
    let newest: Draft | null = null;
    for (const key of keys()) {
      if (!key.startsWith(`${PREFIX}${this.place}:`) || key === this.key || held.has(key)) continue;
      try {
        const { when, model } = JSON.parse(localStorage.getItem(key)!) as { when: number; model: unknown };
        if (!newest || when > newest.when) newest = { key, when, model: fromDict(model) };
      } catch {
        localStorage.removeItem(key); // not ours, or of another version
      }
    }
    return newest;
  }

  /** Forget the drafts of this place that no living tab owns. */
  async forget(): Promise<void> {
    for (let draft = await this.left(); draft; draft = await this.left()) localStorage.removeItem(draft.key);
  }
}

function keys(): string[] {
  try {
    return Object.keys(localStorage);
  } catch {
    return [];
  }
}
