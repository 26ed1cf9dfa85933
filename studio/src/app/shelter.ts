/** Where a studio stands in a page. */

import css from "../studio.css";
import type { Studio } from "./studio";

/** Put the styles and a place for the studio into an element, apart from the page around it. */
export function shelter(element: HTMLElement): HTMLElement {
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
export function reachable(element: HTMLElement, studio: Studio): Studio {
  return Object.assign(element, { studio }).studio;
}
