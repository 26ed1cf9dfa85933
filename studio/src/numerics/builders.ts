/** How the page builds each kind of surface that it knows: one entry a kind. Every other is built by Python (built.ts). */

import { choicesOf, chosenOf, mirrored } from "./chosen";
import { ruled, swept, swung, symmetric, tensor, type Bases, type Vector } from "./construct";
import { developable } from "./envelope";
import { valueOf, type Patch } from "./kinds";
import { nurbs } from "./nurbs";
import * as reference from "./reference";
import type { Surface } from "./surface";

/** The values of a patch, its defaults filled in. */
class Values {
  readonly flip: boolean;
  constructor(private readonly patch: Patch) {
    this.flip = this.get("flip");
  }

  get bases(): Bases {
    return chosenOf(this.patch);
  }

  /** Whether the last of the rows given of a symmetric net is its middle one. */
  get odd(): boolean {
    return mirrored(choicesOf(this.patch)[0]!.entry, this.net("points").length) % 2 === 1;
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

  strip(): Surface {
    const [basis] = this.bases;
    return developable(this.curve("planes"), this.curve("bounds"), basis!.dual(), basis!.partition, this.flip);
  }
}

export const BUILDERS: Readonly<Record<string, (its: Values) => Surface>> = {
  tensor: (its) => tensor(its.net("points"), its.bases, its.flip),
  symmetric: (its) => symmetric(its.net("points"), its.get("mirror"), its.odd, its.bases, its.flip),
  swept: (its) => swept(its.curve("section"), its.curve("trajectory"), its.bases, its.flip),
  swung: (its) => swung(its.curve("profile"), its.curve("trajectory"), its.size("scale"), its.bases, its.flip),
  ruled: (its) => ruled(its.curve("first"), its.curve("second"), its.bases, its.flip),
  developable: (its) => its.strip(),
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

/** Whether the page builds a patch by itself. */
export const drawnHere = (patch: Patch): boolean => patch.kind === "curve" || Object.hasOwn(BUILDERS, patch.kind);

/** Build the surface of a patch that is drawn here. */
export const buildHere = (patch: Patch): Surface => BUILDERS[patch.kind]!(new Values(patch));
