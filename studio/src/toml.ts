/** Model files as TOML. */

import { parse, TomlError } from "smol-toml";

import { beyond } from "./toml-strict";
import { ModelError, toDict, type Model } from "./numerics/model";

const DEEPEST = 20;

/** Write a model as TOML. */
export const toToml = (model: Model): string => written(toDict(model));

/** Write the keys of a model file, or some of them, as TOML. */
export function written(dict: Record<string, unknown>): string {
  const lines: string[] = [];
  const put = (keys: Record<string, unknown>) => {
    for (const [key, value] of Object.entries(keys)) if (value !== null && value !== undefined) lines.push(`${key} = ${spell(value)}`);
  };
  const { patch, join, ...header } = dict;
  const table = ({ bases, ...keys }: Record<string, unknown>, place = "") => {
    put(keys);
    for (const [name, basis] of Object.entries((bases ?? {}) as Record<string, Record<string, unknown>>)) {
      lines.push("", `[${place}bases.${keyOf(name)}]`);
      put(basis);
    }
  };
  table(header);
  for (const [name, tables] of Object.entries({ patch, join })) {
    for (const one of (tables ?? []) as Record<string, unknown>[]) {
      lines.push("", `[[${name}]]`);
      table(one, `${name}.`);
    }
  }
  return `${lines.join("\n")}\n`;
}

const keyOf = (name: string): string => (/^[\w-]+$/.test(name) ? name : JSON.stringify(name));

function spell(value: unknown, indent = ""): string {
  if (typeof value === "object" && value !== null && !Array.isArray(value)) {
    return `{ ${Object.entries(value).map(([key, one]) => `${keyOf(key)} = ${spell(one)}`).join(", ")} }`;
  }
  if (!Array.isArray(value)) return typeof value === "string" ? JSON.stringify(value) : String(value);
  const short = value.every((item) => !Array.isArray(item)) && !value.some((item) => typeof item === "string" && item.length > 12);
  if (short) return `[${value.map((item) => spell(item)).join(", ")}]`;
  return `[\n${value.map((item) => `${indent}    ${spell(item, `${indent}    `)},\n`).join("")}${indent}]`;
}

/** Read TOML 1.0, as Python does; ModelError in one line, with the place, for what is none. */
export function fromToml(text: string): Record<string, unknown> {
  try {
    // A file may begin with a byte order mark, as Python reads it.
    const source = text.replace(/^\uFEFF/, ""), { ...table } = parse(source, { integersAsBigInt: "asNeeded", maxDepth: DEEPEST });
    const newer = beyond(source);
    if (newer) throw new ModelError(`not valid TOML: ${newer.what} (at line ${newer.line}, column ${newer.column})`);
    return numbers(table) as Record<string, unknown>;
  } catch (error) {
    if (!(error instanceof TomlError)) throw error;
    const [what] = error.message.replace(/^Invalid TOML document: /, "").split("\n");
    throw new ModelError(`not valid TOML: ${what} (at line ${error.line}, column ${error.column})`);
  }
}

/** Integers beyond 2⁵³ as the numbers nearest to them. */
function numbers(value: unknown): unknown {
  if (typeof value === "bigint") return Number(value);
  if (Array.isArray(value)) return value.map(numbers);
  if (typeof value !== "object" || value === null || value instanceof Date) return value;
  return Object.fromEntries(Object.entries(value).map(([key, item]) => [key, numbers(item)]));
}
