/** What the TOML 1.1 reader of the page lets pass and TOML 1.0, as Python reads it, does not. */

/** Where a text goes beyond TOML 1.0, and how; null where it does not. It is known to be TOML 1.1. */
export function beyond(text: string): { what: string; line: number; column: number } | null {
  const open: ("table" | "list" | "header")[] = [];
  let value = false, comma = false, at = 0;
  const token = (pattern: RegExp): string => {
    pattern.lastIndex = at;
    return pattern.exec(text)?.[0] ?? "";
  };
  const refused = (what: string, place = at) => {
    const before = text.slice(0, place).split("\n");
    return { what, line: before.length, column: before.at(-1)!.length + 1 };
  };
  while (at < text.length) {
    const c = text[at]!, inTable = open.at(-1) === "table";
    if (c === '"' || c === "'") {
      const quoted = token(STRING), escape = c === '"' ? /^(?:[^\\]|\\[^ex])*?\\([ex])/.exec(quoted) : null;
      if (escape) return refused(`unknown escape sequence \\${escape[1]}`, at + escape[0].length - 2);
      at += quoted.length || 1;
      value = comma = false;
    } else if (c === "#") at += token(/[^\n]*/y).length;
    else if (c === "\n") {
      if (inTable) return refused("a line break in an inline table");
      if (!open.length) value = false;
      at++;
    } else if (c === "[" || c === "{") {
      open.push(c === "{" ? "table" : value ? "list" : "header");
      value = open.at(-1) === "list";
      comma = false;
      at++;
    } else if (c === "]" || c === "}") {
      if (comma && inTable) return refused("a comma at the end of an inline table");
      open.pop();
      value = comma = false;
      at++;
    } else if (c === "," || c === "=") {
      value = c === "=" || open.at(-1) === "list";
      comma = c === ",";
      at++;
    } else if (/\s/.test(c)) at++;
    else {
      const time = value ? token(TIME) : "", bare = time || token(/[^\s,=\]}#]+/y);
      if (time && !exists(time)) return refused(`the date or time ${time} does not exist or lacks its seconds`);
      at += bare.length;
      value = comma = false;
    }
  }
  return null;
}

const STRING = /"""(?:[^\\]|\\.)*?"{3,5}|'''.*?'{3,5}|"(?:[^"\\]|\\.)*"|'[^']*'/sy;
const TIME = /\d{4}-\d\d-\d\d(?:[Tt ]\d[\d:.]*(?:[Zz]|[+-]\d\d:\d\d)?)?|\d\d:[\d:.]*/y;
const CLOCK = /^([01]\d|2[0-3]):[0-5]\d:[0-5]\d(?:\.\d+)?(?:[Zz]|[+-]([01]\d|2[0-3]):[0-5]\d)?$/;

function exists(time: string): boolean {
  if (time[2] === ":") return CLOCK.test(time);
  const [year, month, day] = time.slice(0, 10).split("-").map(Number) as [number, number, number];
  const date = new Date(0);
  date.setUTCFullYear(year, month - 1, day);
  return year > 0 && date.getUTCMonth() === month - 1 && date.getUTCDate() === day && (time.length === 10 || CLOCK.test(time.slice(11)));
}
