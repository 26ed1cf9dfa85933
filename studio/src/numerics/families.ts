/** Every family of functions that the page evaluates, by the name under which Python speaks of it (studio/built.py). */

import { Bernstein, MOVING, Trigonometric, type Still } from "./basis";
import { BSpline } from "./bspline";
import { Chebyshev } from "./chebyshev";
import { Basis, Formulas, parameterOf } from "./formulas";
import { Circular, Hyperbolic, Joined, Powers, type Functions } from "./functions";

/** A family's name and its own parameters; `still` tells at which ends a surface on it stands. */
export interface FamilyKeys {
  readonly family: string;
  readonly still?: Still;
  readonly [key: string]: unknown;
}

/** A family from its keys: `get` gives one of them. */
type Family = (get: <T>(key: string) => T, still: Still) => Functions;

export const FAMILIES: Readonly<Record<string, Family>> = {
  trigonometric: (get, still) => new Trigonometric(get("alpha"), get("zeta"), still),
  bernstein: (get) => new Bernstein(get("degree")),
  bspline: (get) => new BSpline(get("knots"), get("degree")),
  circular: (get) => new Circular(get("start"), get("end")),
  hyperbolic: (get) => new Hyperbolic(get("start"), get("end")),
  powers: (get) => new Powers(get("start"), get("end"), get("degree")),
  joined: (get) => new Joined(get<FamilyKeys[]>("parts").map(functionsOf)),
  formulas: (get) => new Formulas(new Basis("", get("functions"), get<string[]>("names").map((name) => parameterOf(name, -1, 1)), true), get("values")),
  chebyshev: (get) => new Chebyshev(get("breaks"), get("series")),
};

/** The functions that Python describes. */
export function functionsOf(keys: FamilyKeys): Functions {
  const family = FAMILIES[keys.family];
  if (!family) throw new Error(`functions: the page does not know ${keys.family} functions`);
  return family(<T>(key: string) => keys[key] as T, keys.still ?? MOVING);
}
