/** Making elements. */

export type Child = Node | string | number | null | undefined | false;

interface Props {
  readonly class?: string;
  readonly on?: Readonly<Record<string, (event: never) => void>>;
  readonly [name: string]: unknown;
}

/** An element with attributes, listeners and children; `false` and null leave an attribute or a child out. */
export function h<K extends keyof HTMLElementTagNameMap>(tag: K, props: Props = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(props)) {
    if (name === "on") {
      for (const [event, act] of Object.entries(value as object)) element.addEventListener(event, act as EventListener);
    } else if (name === "class") element.className = String(value);
    else if (name.startsWith("aria-") && typeof value === "boolean") element.setAttribute(name, String(value));
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, String(value));
  }
  element.append(...children.filter((c) => c !== null && c !== undefined && c !== false).map((c) => (typeof c === "number" ? String(c) : (c as Node | string))));
  return element;
}

const SVG = "http://www.w3.org/2000/svg";

/** A 16 × 16 line icon from path data. */
export function icon(path: string): SVGElement {
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("viewBox", "0 0 16 16");
  svg.setAttribute("class", "icon");
  svg.setAttribute("aria-hidden", "true");
  const shape = document.createElementNS(SVG, "path");
  shape.setAttribute("d", path);
  svg.append(shape);
  return svg;
}

export const ICONS = {
  undo: "M3 6h7a3.5 3.5 0 0 1 0 7H6M3 6l3-3M3 6l3 3",
  redo: "M13 6H6a3.5 3.5 0 0 0 0 7h4M13 6l-3-3M13 6l-3 3",
  open: "M2 4.5h4l1.5 1.5H14v7H2zM2 8h12",
  save: "M3 3h8l2 2v8H3zM5.5 3v3.5h4V3M5 13V9h6v4",
  picture: "M2 4h3l1-1.5h4L11 4h3v9H2zM8 6.2a2.4 2.4 0 1 0 0 4.8 2.4 2.4 0 0 0 0-4.8z",
  export: "M8 10V2.5M5 5l3-3 3 3M3 9v4.5h10V9",
  sun: "M8 5.2a2.8 2.8 0 1 0 0 5.6 2.8 2.8 0 0 0 0-5.6zM8 1v1.6M8 13.4V15M1 8h1.6M13.4 8H15M3 3l1.2 1.2M11.8 11.8 13 13M13 3l-1.2 1.2M4.2 11.8 3 13",
  moon: "M13 9.5A5.5 5.5 0 1 1 6.5 3 4.4 4.4 0 0 0 13 9.5z",
  help: "M8 2a6 6 0 1 0 0 12A6 6 0 0 0 8 2zM6.2 6.2a1.9 1.9 0 1 1 2.6 1.8c-.6.3-.8.6-.8 1.2M8 11.2v.3",
  down: "M4.5 6.5 8 10l3.5-3.5",
  fit: "M2.5 6V2.5H6M10 2.5h3.5V6M13.5 10v3.5H10M6 13.5H2.5V10",
  pin: "M8 14V9.5M5 9.5h6L9.8 7V3.5H11v-1H5v1h1.2V7z",
  close: "M4 4l8 8M12 4l-8 8",
  flip: "M8 2v12M5 5 2 8l3 3M11 5l3 3-3 3",
  wire: "M2 12 6 3l8 2-3 9zM4 7.5l8.6 2M9.5 4 6.5 13",
  side: "M2.5 3h11v10h-11zM6 3v10",
} as const;

/** A number input's value, or NaN. */
export const typed = (field: HTMLInputElement): number => (field.value.trim() === "" ? NaN : Number(field.value.replace(",", ".")));

/** Offer a file for download. */
export function download(name: string, content: Blob | string, type = "text/plain"): void {
  const blob = typeof content === "string" ? new Blob([content], { type }) : content;
  const link = h("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** A name for a file from any text. */
export const fileName = (text: string): string =>
  text.normalize("NFKD").replace(/[^\w-]+/g, "_").replace(/^_+|_+$/g, "").toLowerCase() || "surface";
