/** The bundle's entry: `mount` for pages, the default export for Jupyter (anywidget), and the numerics for tests. */

import { lastHere, stayHere } from "./app/here";
import { LiveHost, opened, PageHost } from "./app/host";
import { Studio } from "./app/studio";
import { PRESETS } from "./app/state";
import { render } from "./app/notebook";
import { reachable, shelter } from "./app/shelter";
import { renew } from "./app/renewed";
import { connect } from "./numerics/built";
import type { Installed } from "./numerics/kinds";
import { fromDict, install } from "./numerics/model";

export * from "./numerics/index";
export { fromToml } from "./toml";
export { converted } from "./edit/convert";
export { followed, leftToPython } from "./edit/follow";

/** The viewer of a page from disk. */
export function embed(element: HTMLElement, data: { model: unknown; quantity?: string; place?: string; installed?: Installed }): Studio {
  install(data.installed ?? {});
  const host = new PageHost("embedded", data.place ?? location.pathname);
  return reachable(element, new Studio(shelter(element), host, { model: fromDict(data.model), source: null, ...(data.quantity ? { quantity: data.quantity } : {}) }));
}

/** The live studio: asks the server that the page came from for the model. */
export async function live(element: HTMLElement, place: string): Promise<Studio> {
  install(JSON.parse(document.getElementById("quintrig-installed")?.textContent ?? "{}") as Installed);
  const host = new LiveHost(place);
  let made: Studio | null = null;
  connect((patches) => host.build(patches), () => made && renew(made.store));
  // The token is in a cookie now: keep it out of the address, the history and bookmarks.
  if (location.search) history.replaceState(null, "", location.pathname);
  const before = await lastHere(host), answer = await fetch("api/model");
  const { model, source } = before ?? (answer.ok ? opened(await answer.json()) : { model: PRESETS[0]!, source: null });
  const studio = (made = new Studio(shelter(element), host, { model, source }));
  // Without a model a preset is right; a model that cannot be read is told.
  if (!before && !answer.ok && answer.status !== 404) {
    const { error } = (await answer.json().catch(() => ({}))) as { error?: string };
    studio.store.set({ message: { kind: "error", text: error ?? `the server answered ${answer.status}` } });
  }
  const title = () => {
    const { model, saved } = studio.store.state;
    document.title = `${model === saved ? "" : "● "}${model.name} – quintrig`;
  };
  studio.store.subscribe(title);
  stayHere(host, studio.store);
  title();
  return reachable(element, studio);
}

export default { render };

// A page says by the attributes of one element that it holds a studio.
if (typeof document !== "undefined") {
  const element = document.querySelector<HTMLElement>("[data-quintrig]");
  if (element?.dataset["quintrig"] === "live") {
    live(element, element.dataset["place"] ?? "").catch((error: unknown) => (element.textContent = String(error)));
  }
  for (const page of document.querySelectorAll<HTMLElement>("[data-quintrig=embedded]")) {
    const data = document.getElementById(page.dataset["model"] ?? "")?.textContent ?? "null";
    embed(page, JSON.parse(data) as { model: unknown });
  }
}
