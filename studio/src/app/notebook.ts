/** The studio in Jupyter (anywidget): model, quantity and height are the same in kernel and page, whichever side changes them. */

import { connect, learn, type Ask, type Built } from "../numerics/built";
import type { Installed } from "../numerics/kinds";
import { fromDict, install, toDict } from "../numerics/model";
import { QUANTITY } from "../numerics/quantity";
import { PageHost } from "./host";
import { renew } from "./renewed";
import { reachable, shelter } from "./shelter";
import { Studio } from "./studio";

interface WidgetModel {
  get(key: string): unknown;
  set(key: string, value: unknown): void;
  on(event: string, act: (content?: unknown) => void): void;
  off(event: string, act: (content?: unknown) => void): void;
  send?(content: unknown): void;
  save_changes(): void;
}

const PAUSE = 60; // ms: the kernel hears of a drag a few times a second, and of its end
const LEAST = 240, MOST = 4000; // px, as in the kernel

/** Tell the kernel of values some time after the first that changed, all at once. */
function telling(model: WidgetModel): (key: string, value: () => unknown) => void {
  const waiting = new Map<string, () => unknown>();
  return (key, value) => {
    if (!waiting.size) {
      setTimeout(() => {
        for (const [name, now] of waiting) model.set(name, now());
        waiting.clear();
        model.save_changes();
      }, PAUSE);
    }
    waiting.set(key, value);
  };
}

/** Asks the kernel, by messages, for the surfaces of patches that the page cannot build. */
function asking(model: WidgetModel, hear: (event: string, act: (content?: unknown) => void) => void): Ask {
  let answer: ((built: readonly Built[]) => void) | null = null;
  hear("msg:custom", (content) => {
    const { built } = (content ?? {}) as { built?: readonly Built[] };
    if (built) answer?.(built);
  });
  return (patches) => new Promise((done) => {
    answer = done;
    model.send?.({ build: patches });
  });
}

export function render({ model, el }: { model: WidgetModel; el: HTMLElement }): () => void {
  const tell = telling(model);
  const heard: [string, (content?: unknown) => void][] = [];
  const listen = (event: string, act: (content?: unknown) => void) => {
    heard.push([event, act]);
    model.on(event, act);
  };
  const hear = (key: string, act: () => void) => listen(`change:${key}`, act);
  const brought = (model.get("brought") ?? {}) as Installed & { built?: readonly Built[] };
  install(brought);
  learn(brought.built ?? []);
  let made: Studio | null = null;
  const leave = connect(asking(model, listen), () => made && renew(made.store));
  const text = (now: Parameters<typeof toDict>[0]) => JSON.stringify(toDict(now));
  const colour = () => String(model.get("quantity"));
  let echo = "";
  const studio = reachable(el, new Studio(shelter(el), new PageHost("notebook", "notebook"), {
    model: fromDict(model.get("model")), source: null, quantity: colour(),
    onModel(now) {
      const said = text(now);
      if (said === echo) return;
      echo = said;
      tell("model", () => JSON.parse(echo) as unknown);
    },
  }));
  made = studio;
  const { store } = studio;
  echo = text(store.state.model);
  hear("model", () => {
    const next = fromDict(model.get("model")), said = text(next);
    if (said === echo) return;
    echo = said;
    store.edit(next);
  });

  store.subscribe(({ settings: { quantity } }, before) => {
    if (quantity !== before.settings.quantity && quantity !== colour()) tell("quantity", () => store.state.settings.quantity);
  });
  hear("quantity", () => {
    const key = colour(), { settings } = store.state;
    if (key !== settings.quantity && (key === "none" || QUANTITY[key])) store.setting({ quantity: key, range: settings.range === "fixed" ? "robust" : settings.range });
  });

  // The browser writes the height that a user drags to into the style.
  Object.assign(el.style, { resize: "vertical", overflow: "hidden", minHeight: `${LEAST}px`, maxHeight: `${MOST}px` });
  const tall = () => Math.min(MOST, Math.max(LEAST, Math.round(parseFloat(el.style.height) || LEAST)));
  const stretch = () => void (el.style.height = `${Number(model.get("height"))}px`);
  stretch();
  hear("height", stretch);
  const sizes = new ResizeObserver(() => {
    if (tall() !== model.get("height")) tell("height", tall);
  });
  sizes.observe(el);
  return () => {
    for (const [event, act] of heard) model.off(event, act);
    leave();
    sizes.disconnect();
    studio.dispose();
  };
}
