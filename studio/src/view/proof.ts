/** What is proved, refuted and open on a surface, as a picture over its parameters. */

import { DataTexture, NearestFilter, RGBAFormat, UnsignedByteType } from "three";
import { rgb, type Rgb } from "../ui/colours";

export type ProofState = "proved" | "refuted" | "open";

/** Rectangles u, v, u, v of one surface, and the state of each. */
export interface Regions {
  readonly rectangles: readonly (readonly number[])[];
  readonly states: readonly ProofState[];
}

/** Told apart by those who see no red or no green, too (Okabe and Ito 2008). */
export const PROOF_COLOURS: Readonly<Record<ProofState, Rgb>> = { proved: rgb("#009e73"), refuted: rgb("#d55e00"), open: rgb("#f0e442") };

const SIDE = 512;

/** The regions as a texture, u to the right and v upwards; clear where nothing is said. */
export function proofTexture({ rectangles, states }: Regions): DataTexture {
  const bytes = new Uint8Array(4 * SIDE * SIDE);
  rectangles.forEach(([u0, v0, u1, v1], k) => {
    const colour = [...PROOF_COLOURS[states[k]!], 255];
    for (let j = Math.floor(v0! * SIDE); j < Math.ceil(v1! * SIDE); j++) {
      for (let i = Math.floor(u0! * SIDE); i < Math.ceil(u1! * SIDE); i++) bytes.set(colour, 4 * (j * SIDE + i));
    }
  });
  const texture = new DataTexture(bytes, SIDE, SIDE, RGBAFormat, UnsignedByteType);
  texture.magFilter = texture.minFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}
