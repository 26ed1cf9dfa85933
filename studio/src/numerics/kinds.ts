/** Tables of kinds: those of quintrig from its bundle, and those of installed packages that a page is told of. */

import data from "../data.json";
import { BASES } from "./basis";

export interface Field {
  readonly type: "points" | "shape" | "plane" | "number" | "positive" | "boolean" | "choice" | "basis" | "raw";
  readonly description: string;
  readonly required: boolean;
  readonly default?: unknown;
  readonly counts?: readonly number[];
  readonly dimension?: number;
  readonly choices?: readonly string[];
}

export interface Kind {
  readonly title: string;
  readonly construction: boolean;
  readonly shapeNames: readonly string[];
  readonly fields: Readonly<Record<string, Field>>;
}

/** What a model file says of one surface; never changed, only replaced. */
export interface Patch {
  readonly kind: string;
  readonly name: string;
  readonly [key: string]: unknown;
}

/** A model that cannot be used: where, what was expected, what was found. */
export class ModelError extends Error {}

/** What a page is told of the kinds of installed packages. */
export interface Installed {
  readonly kinds?: Readonly<Record<string, Kind>>;
  readonly starters?: Readonly<Record<string, unknown>>;
}

const tables: Record<string, Kind> = { ...(data.kinds as unknown as Record<string, Kind>) };
const starters: Record<string, unknown> = { ...data.starters };
export const KINDS: Readonly<Record<string, Kind>> = tables;
export const STARTERS: Readonly<Record<string, unknown>> = starters;

/** Add the kinds of installed packages; those of quintrig stay what they are. */
export function install(brought: Installed): void {
  for (const [name, kind] of Object.entries(brought.kinds ?? {})) tables[name] ??= kind;
  for (const [name, starter] of Object.entries(brought.starters ?? {})) starters[name] ??= starter;
}

/** Whether the page knows a basis, of which it is told the name, two names, or nothing for a kind that has none. */
export const knownBasis = (basis: unknown): boolean => basis === undefined || (typeof basis === "string" && Object.hasOwn(BASES, basis));

/** Shape parameters of a patch; empty for kinds that have none, and for bases that only Python knows. */
export function shapeOf(patch: Patch): readonly number[] {
  return !knownBasis(valueOf(patch, "basis")) ? [] : ((valueOf(patch, "shape") ?? []) as number[]);
}

/** The value of a key, or its default. */
export function valueOf(patch: Patch, key: string): unknown {
  return patch[key] ?? KINDS[patch.kind]?.fields[key]?.default;
}
