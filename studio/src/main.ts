/** The bundle's entry: `mount` for pages, the default export for Jupyter (anywidget), and the numerics for tests. */

import { lastHere, stayHere } from "./app/here";
import { LiveHost, opened, PageHost } from "./app/host";
import { Studio } from "./app/studio";
import { PRESETS } from "./app/state";
import { fromDict, toDict } from "./numerics/model";
import css from "./studio.css";

export * from "./numerics/index";

/** Put the styles and a place for the studio into an element, apart from the page around it. */
function shelter(element: HTMLElement): HTMLElement {
  const shadow = element.shadowRoot ?? element.attachShadow({ mode: "open" });
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(css);
  shadow.adoptedStyleSheets = [sheet];
  const place = document.createElement("div");
  place.className = "place";
  shadow.replaceChildren(place);
  return place;
}

/** Let scripts and tests find the studio of an element. */
function reachable(element: HTMLElement, studio: Studio): Studio {
  return Object.assign(element, { studio }).studio;
}

/** The viewer of a page from disk. */
export function embed(element: HTMLElement, data: { model: unknown; quantity?: string; place?: string }): Studio {
  const host = new PageHost("embedded", data.place ?? location.pathname);
  return reachable(element, new Studio(shelter(element), host, { model: fromDict(data.model), source: null, ...(data.quantity ? { quantity: data.quantity } : {}) }));
}

/** The live studio: asks the server that the page came from for the model. */
export async function live(element: HTMLElement, place: string): Promise<Studio> {
  const host = new LiveHost(place);
  // The token is in a cookie now: keep it out of the address, the history and bookmarks.
  if (location.search) history.replaceState(null, "", location.pathname);
  const before = await lastHere(host), answer = await fetch("api/model");
  const { model, source } = before ?? (answer.ok ? opened(await answer.json()) : { model: PRESETS[0]!, source: null });
  const studio = new Studio(shelter(element), host, { model, source });
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

interface WidgetModel {
  get(key: string): unknown;
  set(key: string, value: unknown): void;
  on(event: string, act: () => void): void;
  off(event: string, act: () => void): void;
  save_changes(): void;
}

/** Jupyter: the kernel's model and the page's are kept the same, whichever side changes. */
function render({ model, el }: { model: WidgetModel; el: HTMLElement }): () => void {
  el.style.height = `${Number(model.get("height"))}px`;
  let echo = "";
  let timer = 0;
  const send = () => {
    model.set("model", JSON.parse(echo));
    model.save_changes();
  };
  const studio = reachable(el, new Studio(shelter(el), new PageHost("notebook", "notebook"), {
    model: fromDict(model.get("model")), source: null, quantity: String(model.get("quantity")),
    onModel(now) {
      const text = JSON.stringify(toDict(now));
      if (text === echo) return;
      echo = text;
      // The kernel hears of a drag a few times a second, and of its end.
      timer ||= window.setTimeout(() => {
        timer = 0;
        send();
      }, 60);
    },
  }));
  echo = JSON.stringify(toDict(studio.store.state.model));
  const receive = () => {
    const next = fromDict(model.get("model")), text = JSON.stringify(toDict(next));
    if (text === echo) return;
    echo = text;
    studio.store.edit(next);
  };
  model.on("change:model", receive);
  return () => {
    model.off("change:model", receive);
    studio.dispose();
  };
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
