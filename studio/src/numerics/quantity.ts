/** The one table of quantities, exported from Python's `quantity.py` when the bundle is built. */

import data from "../data.json";

export type Colour = "diverging" | "sequential" | "classes" | "vector";

export interface Quantity {
  readonly key: string;
  readonly symbol: string;
  readonly latex: string;
  readonly name: string;
  readonly meaning: string;
  readonly source: string;
  /** Power of length in the unit. */
  readonly power: number;
  readonly parity: string;
  readonly colour: Colour;
  readonly partner: string;
  readonly components: number;
  readonly classes: readonly string[];
}

export const QUANTITIES = data.quantities as readonly Quantity[];
export const QUANTITY: Readonly<Record<string, Quantity>> = Object.fromEntries(QUANTITIES.map((q) => [q.key, q]));

/** What the types of a classification look like, in the words of Python's tables of signs; empty where they say nothing. */
export const wordsOf = (key: string, code: number): string => (data.words as Readonly<Record<string, readonly string[]>>)[key]?.[code] ?? "";

/** The unit of a quantity in text, such as `1/mm²`; empty for a pure number or where the model has no unit. */
export function unitOf(quantity: Quantity, length: string): string {
  if (!length || quantity.power === 0) return "";
  const raised = length + ["", "", "²", "³"][Math.abs(quantity.power)]!;
  return quantity.power > 0 ? raised : `1/${raised}`;
}
