/** Tables of kinds: those of quintrig from its bundle, and those of installed packages that a page is told of. */

import data from "../data.json";
import { learnBases, type ToldBasis } from "./library";

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
  /** Whether it is a surface: else a curve. */
  readonly surface: boolean;
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
  readonly library?: readonly ToldBasis[];
}

/** The range of the shape parameters of the quintic basis. */
export const SHAPE_RANGE = data.shapeRange as [number, number];

const tables: Record<string, Kind> = { ...(data.kinds as unknown as Record<string, Kind>) };
const starters: Record<string, unknown> = { ...data.starters };
export const KINDS: Readonly<Record<string, Kind>> = tables;
export const STARTERS: Readonly<Record<string, unknown>> = starters;

/** Add the kinds and bases of installed packages; those of quintrig stay what they are. */
export function install(brought: Installed): void {
  learnBases(brought.library ?? []);
  for (const [name, kind] of Object.entries(brought.kinds ?? {})) tables[name] ??= kind;
  for (const [name, starter] of Object.entries(brought.starters ?? {})) starters[name] ??= starter;
}

/** The value of a key, or its default. */
export function valueOf(patch: Patch, key: string): unknown {
  return patch[key] ?? KINDS[patch.kind]?.fields[key]?.default;
}
