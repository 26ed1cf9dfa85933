/** How the page builds each kind that it knows: one entry a kind. Every other is built by Python (built.ts). */

import { ruled, swept, swung, symmetric, tensor, type Options, type Vector } from "./construct";
import { developable } from "./envelope";
import { knownBasis, valueOf, type Patch } from "./kinds";
import { nurbs } from "./nurbs";
import * as reference from "./reference";
import type { Surface } from "./surface";

/** The values of a patch, its defaults filled in. */
class Values {
  readonly flip: boolean;
  readonly bezier: Options;
  readonly shape: readonly number[];
  constructor(private readonly patch: Patch) {
    this.flip = this.get("flip");
    this.bezier = { basis: this.get("basis"), flip: this.flip };
    this.shape = this.get("shape");
  }

  get<T>(key: string): T {
    return valueOf(this.patch, key) as T;
  }

  size(key: string): number {
    return this.get(key);
  }

  curve(key: string): Vector[] {
    return this.get(key);
  }

  net(key: string): Vector[][] {
    return this.get(key);
  }
}

export const BUILDERS: Readonly<Record<string, (its: Values) => Surface>> = {
  tensor: (its) => tensor(its.net("points"), its.shape, its.bezier),
  symmetric: (its) => symmetric(its.net("points"), its.get("mirror"), its.shape, its.bezier),
  swept: (its) => swept(its.curve("section"), its.curve("trajectory"), its.shape, its.bezier),
  swung: (its) => swung(its.curve("profile"), its.curve("trajectory"), its.shape, its.size("scale"), its.bezier),
  ruled: (its) => ruled(its.curve("first"), its.curve("second"), its.shape, its.bezier),
  developable: (its) => developable(its.curve("planes"), its.curve("bounds"), its.shape, its.flip),
  nurbs: (its) => nurbs(its.net("points"), its.get("weights"), its.get("degrees"), its.curve("knots"), its.flip, its.net("trim")),
  sphere: (its) => reference.sphere(its.size("radius"), its.flip),
  ellipsoid: (its) => reference.ellipsoid(its.size("a"), its.size("b"), its.size("c"), its.flip),
  cylinder: (its) => reference.cylinder(its.size("radius"), its.size("height"), its.flip),
  cone: (its) => reference.cone(its.size("radius"), its.size("height"), its.flip),
  torus: (its) => reference.torus(its.size("major"), its.size("minor"), its.flip),
  catenoid: (its) => reference.catenoid(its.size("waist"), its.size("height"), its.flip),
  helicoid: (its) => reference.helicoid(its.size("radius"), its.size("pitch"), its.flip),
  hyperbolic_paraboloid: (its) => reference.hyperbolicParaboloid(its.size("size"), its.flip),
  monkey_saddle: (its) => reference.monkeySaddle(its.size("size"), its.flip),
  enneper: (its) => reference.enneper(its.size("size"), its.flip),
};

/** Whether the page builds a patch by itself: its kind, and its basis where it has one. */
export function drawnHere(patch: Patch): boolean {
  return Object.hasOwn(BUILDERS, patch.kind) && knownBasis(valueOf(patch, "basis"));
}

/** Build the surface of a patch that is drawn here. */
export const buildHere = (patch: Patch): Surface => BUILDERS[patch.kind]!(new Values(patch));
