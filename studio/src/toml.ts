/** Model files as TOML: enough of the language to read and write what a model may hold. */

import { ModelError, toDict, type Model } from "./numerics/model";

/** Write a model as TOML. */
export function toToml(model: Model): string {
  const dict = toDict(model);
  const lines: string[] = [];
  const put = (keys: Record<string, unknown>) => {
    for (const [key, value] of Object.entries(keys)) if (value !== null && value !== undefined) lines.push(`${key} = ${spell(value)}`);
  };
  const { patch, ...header } = dict;
  put(header);
  for (const table of (patch ?? []) as Record<string, unknown>[]) {
    lines.push("", "[[patch]]");
    put(table);
  }
  return `${lines.join("\n")}\n`;
}

function spell(value: unknown, indent = ""): string {
  if (!Array.isArray(value)) return typeof value === "string" ? JSON.stringify(value) : String(value);
  if (value.every((item) => !Array.isArray(item))) return `[${value.map((item) => spell(item)).join(", ")}]`;
  return `[\n${value.map((item) => `${indent}    ${spell(item, `${indent}    `)},\n`).join("")}${indent}]`;
}

/** Read TOML: keys, strings, numbers, booleans, arrays and [[patch]] tables; ModelError with the line for anything else. */
export function fromToml(text: string): Record<string, unknown> {
  let at = 0;
  const root: Record<string, unknown> = {};
  let table = root;
  const fail = (what: string): never => {
    throw new ModelError(`not valid TOML: ${what} (at line ${text.slice(0, at).split("\n").length})`);
  };
  const blank = (lines: boolean) => {
    for (;;) {
      while (at < text.length && (" \t\r".includes(text[at]!) || (lines && text[at] === "\n"))) at++;
      if (text[at] !== "#") return;
      while (at < text.length && text[at] !== "\n") at++;
    }
  };
  const match = (pattern: RegExp): string | null => {
    pattern.lastIndex = at;
    const found = pattern.exec(text);
    if (found) at += found[0].length;
    return found ? found[0] : null;
  };
  const value = (depth: number): unknown => {
    if (depth > 20) fail("nested too deeply");
    if (text[at] === "[") {
      at++;
      const list: unknown[] = [];
      for (;;) {
        blank(true);
        if (text[at] === "]") break;
        list.push(value(depth + 1));
        blank(true);
        if (text[at] === ",") at++;
        else if (text[at] !== "]") fail("expected , or ]");
      }
      at++;
      return list;
    }
    const string = match(/"(?:[^"\\\n]|\\.)*"|'[^'\n]*'/y);
    if (string) return string.startsWith("'") ? string.slice(1, -1) : (JSON.parse(string) as string);
    const word = match(/[+\-\w.]+/y);
    if (word === "true" || word === "false") return word === "true";
    if (word && /^[+-]?(\d[\d_]*(\.\d[\d_]*)?([eE][+-]?\d+)?|inf|nan)$/.test(word)) {
      return Number(word.replaceAll("_", "").replace(/inf$/, "Infinity").replace(/^[+-]?nan$/, "NaN"));
    }
    return fail("expected a value");
  };
  for (;;) {
    blank(true);
    if (at >= text.length) return root;
    if (match(/\[\[\s*patch\s*\]\]/y)) {
      table = {};
      root["patch"] = [...((root["patch"] as unknown[] | undefined) ?? []), table];
    } else {
      const key = match(/[\w-]+/y) ?? fail("expected a key");
      blank(false);
      if (text[at] !== "=") fail(`expected = after ${key}`);
      at++;
      blank(false);
      if (Object.hasOwn(table, key)) fail(`the key ${key} stands twice`);
      table[key] = value(0);
    }
    blank(false);
    if (at < text.length && text[at] !== "\n") fail("expected the end of the line");
  }
}
