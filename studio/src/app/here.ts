/** What a tab works on, so that a reload comes back to it: a file by its name, another model as it was opened. */

import { fromDict, toDict } from "../numerics/model";
import type { Host, Opened } from "./host";
import type { Store } from "./state";

const PREFIX = "quintrig:here:";

/** Remember what the tab works on, from now on. */
export function stayHere(host: Host, store: Store): void {
  const keep = () => {
    const { source, saved } = store.state;
    try {
      sessionStorage.setItem(PREFIX + host.place, JSON.stringify(source ? { name: source.name } : { model: toDict(saved) }));
    } catch {
      sessionStorage.removeItem(PREFIX + host.place); // too large: a reload starts anew
    }
  };
  store.subscribe((now, before) => {
    if (now.opened !== before.opened || now.source !== before.source) keep();
  });
}

/** What the tab worked on before a reload; null for a new tab, or where that cannot be read any more. */
export async function lastHere(host: Host): Promise<Opened | null> {
  try {
    const here = JSON.parse(sessionStorage.getItem(PREFIX + host.place) ?? "null") as { name?: string; model?: unknown } | null;
    if (!here) return null;
    return here.name ? await host.load(here.name) : { model: fromDict(here.model), source: null };
  } catch {
    return null;
  }
}
