/** How the surface is shown: all that is not the model. Values, never changed; kept between visits. */

import type { Projection } from "../view/camera";

export interface Settings {
  readonly quantity: string;
  /** How the ends of the colour map are found: from percentiles, from all values, or given. */
  readonly range: "robust" | "full" | "fixed";
  readonly percentile: number;
  readonly low: number;
  readonly high: number;
  readonly contours: boolean;
  readonly net: boolean;
  readonly curves: boolean;
  readonly directions: boolean;
  readonly normals: boolean;
  readonly combs: "off" | "u" | "v" | "both";
  readonly combScale: number;
  /** Whether curves have combs. */
  readonly comb: boolean;
  readonly zeroK: boolean;
  readonly zeroH: boolean;
  readonly minRadius: boolean;
  /** Whether seams are drawn in the colours of their orders, and whether shared points move together. */
  readonly seams: boolean;
  readonly together: boolean;
  readonly stripes: "none" | "zebra" | "isophotes" | "reflection" | "highlight";
  readonly density: number;
  readonly lightAzimuth: number;
  readonly lightElevation: number;
  readonly section: boolean;
  /** Azimuth of the plane's normal about z from the x axis, and its tilt out of the xy plane, in degrees. */
  readonly sectionAzimuth: number;
  readonly sectionTilt: number;
  /** How far the plane stands from the middle of what is shown, along its normal, length¹. */
  readonly sectionAt: number;
  readonly clip: boolean;
  readonly wireframe: boolean;
  readonly projection: Projection;
  readonly theme: "auto" | "light" | "dark";
  readonly snap: boolean;
  readonly snapStep: number;
  readonly locks: readonly [boolean, boolean, boolean];
  /** Points a side when nothing moves. */
  readonly resolution: number;
}

export const DEFAULTS: Settings = {
  quantity: "gaussian", range: "robust", percentile: 2, low: -1, high: 1, contours: false,
  net: true, curves: true, directions: false, normals: false, combs: "off", combScale: 1, comb: true, zeroK: false, zeroH: false, minRadius: false, seams: true, together: true,
  stripes: "none", density: 24, lightAzimuth: 30, lightElevation: 60,
  section: false, sectionAzimuth: 0, sectionTilt: 0, sectionAt: 0, clip: false,
  wireframe: false, projection: "perspective", theme: "auto", snap: false, snapStep: 1, locks: [false, false, false], resolution: 150,
};

const KEPT: readonly (keyof Settings)[] = ["theme", "projection", "curves", "net", "resolution"];
const STORE = "quintrig:settings";

/** The settings kept from the last visit, on top of the defaults. */
export function remembered(): Settings {
  try {
    const kept = JSON.parse(localStorage.getItem(STORE) ?? "{}") as Record<string, unknown>;
    const known = KEPT.filter((key) => typeof kept[key] === typeof DEFAULTS[key]);
    return { ...DEFAULTS, ...Object.fromEntries(known.map((key) => [key, kept[key]])) };
  } catch {
    return DEFAULTS; // no storage here, or not ours
  }
}

export function remember(settings: Settings): void {
  try {
    localStorage.setItem(STORE, JSON.stringify(Object.fromEntries(KEPT.map((key) => [key, settings[key]]))));
  } catch {
    // A page from disk, or storage turned off: nothing is kept.
  }
}
