/** The controls that the panels are made of. Each is an element with a way to show a new value. */

import { h, typed, type Child } from "./dom";

export interface Control<T> {
  readonly element: HTMLElement;
  update(value: T): void;
}

let serial = 0;
const fresh = (name: string): string => `${name}-${++serial}`;

export interface Slider extends Control<number> {
  /** Let it run over another range. */
  bounds(min: number, max: number, step: number): void;
}

export interface SliderOptions {
  readonly label: Node | string;
  /** What a screen reader says. */
  readonly name: string;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly marks?: readonly number[];
  readonly hard?: boolean;
  /** What may be typed where that is not just from `min` to `max`, and how that is said. */
  readonly allowed?: { holds(value: number): boolean; readonly words: string };
  onInput(value: number): void;
  onSettle?(): void;
}

const busy = new WeakSet<EventTarget>();

/** Whether somebody is typing in a field: until it is committed it must not be replaced, and its keys are its own. */
export const isTyping = (field: EventTarget): boolean => busy.has(field);

/** Follow whether somebody types in a field; `restore` puts back what holds when they leave or give up. */
export function typing(field: HTMLInputElement, restore: () => void): void {
  field.addEventListener("input", () => busy.add(field));
  field.addEventListener("change", () => busy.delete(field));
  const leave = () => {
    busy.delete(field);
    restore();
  };
  field.addEventListener("blur", leave);
  field.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !isTyping(field)) return;
    event.stopPropagation();
    leave();
  });
}

/** Say what is wrong with what was typed; the field itself goes back to what holds. */
function refuse(field: HTMLInputElement, good: boolean, expected: string): void {
  field.classList.toggle("wrong", !good);
  field.title = good ? "" : `${field.value || "That"} was not taken: expected ${expected}`;
}

/** A slider with a number field and marks at special values; values beyond it may be typed unless `hard`. */
export function slider(options: SliderOptions): Slider {
  let { min, max } = options;
  const { step } = options;
  const id = fresh("slider");
  const share = (value: number) => `${(100 * (Math.min(max, Math.max(min, value)) - min)) / (max - min)}%`;
  const range = h("input", { type: "range", id, min, max, step, "aria-label": options.name });
  const field = h("input", { type: "number", class: "number", step, "aria-label": `${options.name}, number`, ...(options.hard && !options.allowed ? { min, max } : {}) });
  const fill = h("div", { class: "track" });
  let shown = NaN;
  const restore = () => void (field.value = Number.isNaN(shown) ? "" : String(Number(shown.toPrecision(8))));
  typing(field, restore);
  range.addEventListener("input", () => {
    show(Number(range.value));
    options.onInput(Number(range.value));
  });
  range.addEventListener("change", () => options.onSettle?.());
  field.addEventListener("change", () => {
    const value = typed(field);
    const inside = options.allowed?.holds(value) ?? (value >= min && value <= max);
    const good = Number.isFinite(value) && (!options.hard || inside);
    refuse(field, good, options.hard ? (options.allowed?.words ?? `a number from ${min} to ${max}`) : "a number");
    if (!good || value === shown) return restore();
    shown = value;
    restore();
    options.onInput(value);
    options.onSettle?.();
  });
  const marks = (options.marks ?? []).map((mark) => {
    const tick = h("span", { class: "mark" }, String(mark).replace("-", "−"));
    tick.style.left = share(mark);
    return tick;
  });
  const show = (value: number) => {
    fill.style.setProperty("--share", share(value));
    fill.style.setProperty("--zero", share(0));
  };
  const element = h(
    "div", { class: "slider" },
    h("label", { for: id, class: "symbol" }, options.label),
    h("div", { class: "range" }, fill, range, h("div", { class: "marks", "aria-hidden": "true" }, ...marks)),
    field,
  );
  return {
    element,
    update(value) {
      range.value = String(value);
      shown = value;
      show(value);
      if (isTyping(field)) return;
      restore();
      field.classList.remove("wrong");
    },
    bounds(low, high, fine) {
      min = low;
      max = high;
      Object.assign(range, { min: String(low), max: String(high), step: String(fine) });
      field.step = String(fine);
    },
  };
}

export interface NumberOptions {
  readonly label: Node | string;
  readonly name: string;
  readonly step?: number;
  readonly positive?: boolean;
  onChange(value: number): void;
}

export function numberField(options: NumberOptions): Control<number> {
  const field = h("input", { type: "number", class: "number", step: options.step ?? "any", "aria-label": options.name });
  let shown = NaN;
  const restore = () => void (field.value = Number.isNaN(shown) ? "" : String(Number(shown.toPrecision(10))));
  typing(field, restore);
  field.addEventListener("change", () => {
    const value = typed(field);
    const good = Number.isFinite(value) && Math.abs(value) <= 1e50 && (!options.positive || value > 0);
    refuse(field, good, options.positive ? "a number greater than 0" : "a number");
    if (!good || value === shown) return restore();
    shown = value;
    restore();
    options.onChange(value);
  });
  const element = h("label", { class: "field" }, h("span", {}, options.label), field);
  return {
    element,
    update(value) {
      shown = value;
      if (isTyping(field)) return;
      field.disabled = Number.isNaN(value);
      restore();
      field.classList.remove("wrong");
    },
  };
}

export function toggle(label: Child, onChange: (on: boolean) => void, swatch?: HTMLElement, hint = ""): Control<boolean> {
  const box = h("input", { type: "checkbox", class: "switch" });
  box.addEventListener("change", () => onChange(box.checked));
  const element = h("label", { class: "toggle", title: hint || false }, box, h("span", {}, label), swatch);
  return { element, update: (on) => void (box.checked = on) };
}

export interface Option<T extends string> {
  readonly value: T;
  readonly label: Child;
  readonly title?: string;
}

/** A row of buttons of which one is chosen; arrow keys move along it. */
export function segmented<T extends string>(name: string, options: readonly Option<T>[], onChange: (value: T) => void): Control<T> {
  const buttons = options.map((option) => {
    const button = h("button", { type: "button", role: "radio", class: "segment", title: option.title ?? false, "data-value": option.value }, option.label);
    button.addEventListener("click", () => onChange(option.value));
    return button;
  });
  const element = h("div", { class: "segmented", role: "radiogroup", "aria-label": name }, ...buttons);
  element.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    const at = buttons.indexOf(event.target as HTMLButtonElement);
    if (!step || at < 0) return;
    event.preventDefault();
    event.stopPropagation();
    const next = (at + step + buttons.length) % buttons.length;
    buttons[next]!.focus();
    onChange(options[next]!.value);
  });
  return {
    element,
    update(value) {
      buttons.forEach((button, i) => {
        const chosen = options[i]!.value === value;
        button.setAttribute("aria-checked", String(chosen));
        button.tabIndex = chosen || (i === 0 && !options.some((o) => o.value === value)) ? 0 : -1;
      });
    },
  };
}

export interface Group<T extends string> {
  readonly label: string;
  readonly options: readonly { readonly value: T; readonly label: string }[];
}

export function choice<T extends string>(name: string, groups: readonly Group<T>[], onChange: (value: T) => void): Control<T> {
  const options = (group: Group<T>) => group.options.map((o) => h("option", { value: o.value }, o.label));
  const select = h(
    "select", { "aria-label": name },
    ...groups.flatMap((group) => (group.label ? [h("optgroup", { label: group.label }, ...options(group))] : options(group))),
  );
  select.addEventListener("change", () => onChange(select.value as T));
  return { element: select, update: (value) => void (select.value = value) };
}

export function button(label: Child, title: string, onClick: () => void, name = "button"): HTMLButtonElement {
  return h("button", { type: "button", class: name, title, "aria-label": title, on: { click: onClick } }, label);
}

export interface Item {
  readonly label: Child;
  readonly hint?: string;
  readonly disabled?: boolean;
  /** Why it is disabled. */
  readonly reason?: string;
  act(): void;
}

/** A button that opens a list of commands. `items` is asked each time it opens, and again where `news` then says that it has some. */
export function menu(label: Child, title: string, items: () => readonly (Item | string)[], name = "button", news?: () => Promise<boolean>): HTMLElement {
  const list = h("div", { class: "menu", role: "menu", "aria-label": title, hidden: true });
  const opener = h("button", { type: "button", class: name, title, "aria-label": title, "aria-haspopup": "menu", "aria-expanded": "false" }, label);
  const box = h("div", { class: "menu-box" }, opener, list);
  const close = (refocus: boolean) => {
    list.hidden = true;
    opener.setAttribute("aria-expanded", "false");
    if (refocus) opener.focus();
  };
  const fill = () => {
    list.replaceChildren(
      ...items().map((item) => {
        if (typeof item === "string") return h("div", { class: "menu-title", role: "presentation" }, item);
        const why = item.reason ? h("small", { class: "reason" }, item.reason.split(/[:;]\s/)[0]!) : item.hint ? h("small", {}, item.hint) : null;
        const entry = h("button", { type: "button", role: "menuitem", class: "menu-item", title: item.reason ?? "", disabled: item.disabled ?? false }, h("span", {}, item.label), why);
        entry.addEventListener("click", () => {
          close(true);
          item.act();
        });
        return entry;
      }),
    );
  };
  const open = () => {
    list.hidden = false;
    opener.setAttribute("aria-expanded", "true");
    fill();
    void news?.().then((some) => {
      if (!some || list.hidden) return;
      const at = [...list.children].indexOf(list.querySelector(":focus")!);
      opener.focus(); // what is replaced cannot keep the focus
      fill();
      (list.children[at] as HTMLElement | undefined)?.focus();
    });
    const right = list.getBoundingClientRect().right;
    const bound = box.closest(".studio")!.getBoundingClientRect().right;
    list.classList.toggle("to-left", right > bound - 8);
    list.querySelector<HTMLElement>("[role=menuitem]:not([disabled])")?.focus();
  };
  opener.addEventListener("click", () => (list.hidden ? open() : close(false)));
  box.addEventListener("focusout", (event) => {
    if (!box.contains(event.relatedTarget as Node | null)) close(false);
  });
  box.addEventListener("keydown", (event) => {
    if (list.hidden) return;
    const entries = [...list.querySelectorAll<HTMLElement>("[role=menuitem]:not([disabled])")];
    const at = entries.indexOf(event.target as HTMLElement);
    event.stopPropagation();
    if (event.key === "Escape") close(true);
    else if (event.key === "ArrowDown" || event.key === "ArrowUp") {
      event.preventDefault();
      entries[(at + (event.key === "ArrowDown" ? 1 : -1) + entries.length) % entries.length]?.focus();
    }
  });
  return box;
}

/** A part of a panel that folds. */
export function section(title: string, open: boolean, ...children: Child[]): HTMLDetailsElement {
  return h("details", { class: "section", open }, h("summary", {}, title), h("div", { class: "section-body" }, ...children));
}
