/** Numbers and symbols as people read them. */

import { QUANTITY, unitOf, type Quantity } from "../numerics/quantity";

/** Four significant digits with a real minus sign, as short as it can be told. */
export function short(value: number, digits = 4): string {
  if (Number.isNaN(value)) return "undefined";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text = size >= 1e5 || size < 1e-3 ? exponential(value, digits) : String(Number(value.toPrecision(digits)));
  return text.replace("-", "−");
}

function exponential(value: number, digits: number): string {
  const [mantissa, power] = value.toExponential(digits - 1).split("e") as [string, string];
  return `${Number(mantissa)}·10${raised(Number(power))}`;
}

/** The power of ten, a multiple of 3, to take out of numbers up to `largest`; 0 where they read well. */
export const exponent = (largest: number): number =>
  !(largest > 0) || !Number.isFinite(largest) || (largest >= 0.01 && largest < 1e4) ? 0 : 3 * Math.floor(Math.log10(largest) / 3);

/** An integer in superscript digits. */
export const raised = (power: number): string => String(power).replace(/[-\d]/g, (c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(c)]!));

export const percent = (share: number): string => (share > 0 && share < 0.001 ? "<0.1 %" : `${short(100 * share, share < 0.1 ? 2 : 3)} %`);

export const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

const GREEK: Readonly<Record<string, string>> = {
  alpha: "α", beta: "β", gamma: "γ", delta: "δ", zeta: "ζ", theta: "θ", kappa: "κ", lam: "λ", lambda: "λ", mu: "μ", nu: "ν", rho: "ρ", sigma: "σ",
  tau: "τ", phi: "φ", omega: "ω",
};

/** The letters and the number of a shape parameter, such as lam and 1,2 for lam1_2. */
export function parameterParts(label: string): readonly [string, string] {
  const letters = label.replace(/[\d_]+$/, "");
  return [letters, label.slice(letters.length).replaceAll("_", ",")];
}

/** A shape parameter as it is read: its letter, with its number below. */
export function parameterSymbol(label: string): HTMLElement {
  const [letters, number] = parameterParts(label), box = element("span", "", "math");
  box.append(element("i", GREEK[letters] ?? letters), ...(number ? [element("sub", number)] : []));
  return box;
}

/** A symbol as elements with real sub- and superscripts, from the table's LaTeX. */
export function symbol(latex: string): HTMLElement {
  const box = document.createElement("span");
  box.className = "math";
  const words = latex.replace(/\\mathrm\{([^}]*)\}/g, "«$1»").replace(/\\mathbf\{([^}]*)\}/g, "‹$1›").replace(/\\,/g, " ");
  const pattern = /«([^»]*)»|‹([^›]*)›|\\([a-z]+)|([_^])(?:\{([^}]*)\}|(.))|([^\\_^])/g;
  for (const [, roman, bold, greek, script, group, single, plain] of words.matchAll(pattern)) {
    if (roman !== undefined) box.append(element("span", roman, "roman"));
    else if (bold !== undefined) box.append(element("b", bold));
    else if (greek !== undefined) box.append(element("i", GREEK[greek] ?? greek));
    else if (script) box.append(element(script === "_" ? "sub" : "sup", group ?? single ?? ""));
    else if (plain) box.append(/[A-Za-z]/.test(plain) ? element("i", plain) : plain);
  }
  return box;
}

export const symbolOf = (key: string): HTMLElement => symbol(QUANTITY[key]!.latex);

function element(tag: string, text: string, name = ""): HTMLElement {
  const made = document.createElement(tag);
  made.textContent = text;
  if (name) made.className = name;
  return made;
}

/** A quantity's value in words: the name of a class, or a number. */
export function valueText(q: Quantity, value: number, digits = 5): string {
  return q.colour === "classes" ? (q.classes[value] ?? "undefined") : short(value, digits);
}

/** A unit such as `mm⁻²` written `1/mm²`. */
export const unitText = (q: Quantity, length: string): string => unitOf(q, length);
