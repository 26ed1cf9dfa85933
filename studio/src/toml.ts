/** Model files as TOML. */

import { parse, TomlError } from "smol-toml";

import { beyond } from "./toml-strict";
import { ModelError, toDict, type Model } from "./numerics/model";

const DEEPEST = 20;

/** Write a model as TOML. */
export function toToml(model: Model): string {
  const dict = toDict(model);
  const lines: string[] = [];
  const put = (keys: Record<string, unknown>) => {
    for (const [key, value] of Object.entries(keys)) if (value !== null && value !== undefined) lines.push(`${key} = ${spell(value)}`);
  };
  const { patch, join, ...header } = dict;
  put(header);
  for (const [name, tables] of Object.entries({ patch, join })) {
    for (const table of (tables ?? []) as Record<string, unknown>[]) {
      lines.push("", `[[${name}]]`);
      put(table);
    }
  }
  return `${lines.join("\n")}\n`;
}

function spell(value: unknown, indent = ""): string {
  if (!Array.isArray(value)) return typeof value === "string" ? JSON.stringify(value) : String(value);
  if (value.every((item) => !Array.isArray(item))) return `[${value.map((item) => spell(item)).join(", ")}]`;
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
