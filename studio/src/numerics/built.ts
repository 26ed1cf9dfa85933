/**
 * Surfaces that Python builds, for kinds and bases that the page does not know: they come with a model, and after a
 * change the page asks for them anew where there is Python to ask. Until an answer comes, the last surface is shown.
 */

import { MOVING, Trigonometric } from "./basis";
import { Formulas } from "./formulas";
import { packed, type Vector } from "./construct";
import { Envelope } from "./envelope";
import { functionsOf, type FamilyKeys } from "./families";
import { KINDS, ModelError, valueOf, type Patch } from "./kinds";
import { movedPlane } from "./origin";
import { Net, type Rows, type Surface } from "./surface";

/** A surface as Python describes it: of a net, of the planes of a strip, or of rows as series. */
interface Described {
  readonly flip: boolean;
  readonly origin: readonly number[];
  readonly net: readonly (readonly Vector[])[] | null;
  readonly dimension: number;
  readonly points?: readonly (readonly Vector[])[];
  readonly planes?: readonly Vector[];
  readonly bounds?: readonly Vector[];
  readonly functions: FamilyKeys;
  readonly blend: FamilyKeys;
}

/** The keys of a patch, and its surface or the reason why there is none. */
export interface Built {
  readonly keys: Readonly<Record<string, unknown>>;
  readonly surface?: Described;
  readonly error?: string;
}

/** Asks Python for the surfaces of patches. */
export type Ask = (patches: readonly Patch[]) => Promise<readonly Built[]>;

/** The surface is on its way. */
export class Pending extends ModelError {}

const MOST = 512, MOST_ASKED = 8;
const known = new Map<string, Surface | ModelError>();
const latest = new Map<string, Surface>();
const wanted = new Map<string, Patch>();
const connections: { readonly ask: Ask; readonly arrived: () => void }[] = [];
let asking = false;

/** From now on ask Python for what is missing, and tell when it is there; the function returned ends that. */
export function connect(ask: Ask, arrived: () => void): () => void {
  const connection = { ask, arrived };
  connections.push(connection);
  return () => void connections.splice(connections.indexOf(connection), 1);
}

/** Take up surfaces that Python has built. */
export function learn(built: readonly Built[]): void {
  for (const { keys, surface, error } of built) {
    keep(spelling(keys as unknown as Patch), surface ? described(surface) : new ModelError(error ?? "there is no surface"));
  }
}

/** The surface of a patch that Python builds; ModelError with the reason where there is none, Pending while it is awaited. */
export function surfaceOf(patch: Patch): Surface {
  const key = spelling(patch), found = known.get(key), place = `${patch.kind} ${patch.name}`;
  if (found instanceof ModelError) throw found;
  if (found) {
    latest.set(place, found);
    return found;
  }
  if (!connections.length) throw new ModelError(`patch "${patch.name}": ${whyFixed(patch)}`);
  wanted.set(key, patch);
  void send();
  const before = latest.get(place);
  if (!before) throw new Pending(`patch "${patch.name}": is being built by Python`);
  return before;
}

/** Why a patch cannot be changed here, in words; empty where it can. */
export const refusal = (patch: Patch): string => (connections.length || known.has(spelling(patch)) ? "" : `patch "${patch.name}": ${whyFixed(patch)}`);

const whyFixed = ({ kind }: Patch): string => `a ${kind} is built by Python, which a page from disk lacks; change it with: quintrig view MODEL`;

/** Ask for the newest of what is missing, one question after the other; the rest of a drag is passed over. */
async function send(): Promise<void> {
  if (asking) return;
  asking = true;
  await Promise.resolve(); // what else one frame needs goes into the same question
  while (wanted.size && connections.length) {
    const asked = [...wanted].slice(-MOST_ASKED);
    wanted.clear();
    try {
      learn(await connections.at(-1)!.ask(asked.map(([, patch]) => patch)));
    } catch (error) {
      for (const [key] of asked) keep(key, new ModelError((error as Error).message));
    }
    for (const [key] of asked) if (!known.has(key)) keep(key, new ModelError("Python did not build this patch"));
    for (const { arrived } of connections) arrived();
  }
  asking = false;
}

function keep(key: string, surface: Surface | ModelError): void {
  known.delete(key);
  known.set(key, surface);
  if (known.size > MOST) known.delete(known.keys().next().value!);
}

/** What a surface depends on, defaults filled in: the same for the same surface, however its keys are written. */
function spelling(patch: Patch): string {
  const keys = Object.keys(KINDS[patch.kind]?.fields ?? {}).sort();
  return JSON.stringify([patch.kind, ...keys.map((key) => valueOf(patch, key) ?? null)]);
}

function described({ origin, flip, net, blend, ...rest }: Described): Surface {
  return { rows: rowsOf(rest, origin), blend: functionsOf(blend), flip, net: net && packed(net), origin };
}

function rowsOf({ points, planes, bounds, functions, dimension }: Omit<Described, "blend" | "origin" | "flip" | "net">, origin: Vector): Rows {
  const own = functionsOf(functions);
  if (points) return new Net(packed(points), own);
  if (planes && bounds && (own instanceof Trigonometric || own instanceof Formulas)) {
    const local = (plane: Vector) => movedPlane(plane, origin), dual = own instanceof Formulas ? own : new Trigonometric(own.alpha, own.zeta, MOVING);
    return new Envelope(planes.map(local), bounds.map(local), dual, !(own instanceof Formulas) || own.partition);
  }
  return { size: own.size / dimension, dimension, derivatives: (u, n, out) => own.derivatives(u, n, out) };
}
