/** Colours: those of the report's figures, exported from Python, for maps, classes and the two sides of a surface. */

import data from "../data.json";
import type { Quantity } from "../numerics/quantity";

export type Rgb = readonly [number, number, number];

const STEPS = 256;

export const UNDEFINED = rgb(data.palette.undefined);
export const FRONT = rgb(data.palette.front);
export const BACK = rgb(data.palette.back);
export const SERIES: readonly string[] = data.palette.series;

/** The colours of a real quantity's map from its lowest to its highest value, 256 of them. */
export function mapColours(quantity: Quantity): Rgb[] {
  const stops = (quantity.colour === "diverging" ? data.palette.diverging : data.palette.sequential).map(rgb);
  return Array.from({ length: STEPS }, (_, i) => {
    const x = (i / (STEPS - 1)) * (stops.length - 1), k = Math.min(Math.floor(x), stops.length - 2);
    return [0, 1, 2].map((c) => Math.round(stops[k]![c]! + (x - k) * (stops[k + 1]![c]! - stops[k]![c]!))) as unknown as Rgb;
  });
}

/** One colour for each class of a classification. */
export const classColours = (key: string): Rgb[] => (data.palette.classes as Record<string, string[]>)[key]!.map(rgb);

/** The colours one after the other, opaque. */
export const bytes = (colours: readonly Rgb[]): Uint8Array<ArrayBuffer> => Uint8Array.from(colours.flatMap((c) => [...c, 255]));

export const css = ([r, g, b]: Rgb): string => `rgb(${r} ${g} ${b})`;

export function rgb(hex: string): Rgb {
  return [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16)) as unknown as Rgb;
}
