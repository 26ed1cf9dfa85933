// Builds src/ into the one file that the Python package ships: node build.mjs [OUT]
// The first line of the bundle holds a hash of the sources, so that a test can tell when it is out of date; after it
// come the licences of the packages that are in it, as those ask.
import { createHash } from "node:crypto";
import { readFileSync, readdirSync, renameSync, writeFileSync } from "node:fs";
import { dirname, join, relative, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(here, "../src/quintrig/studio/bundle/studio.js");

const walk = (folder) =>
  readdirSync(folder, { withFileTypes: true }).flatMap((entry) =>
    entry.isDirectory() ? walk(join(folder, entry.name)) : [join(folder, entry.name)],
  );
const settings = ["build.mjs", "package.json", "package-lock.json", "tsconfig.json"].map((name) => join(here, name));
const sources = [...walk(join(here, "src")), ...settings];
const hash = createHash("sha256");
for (const name of sources.map((file) => relative(here, file).replaceAll("\\", "/")).sort()) {
  hash.update(name).update("\0").update(readFileSync(join(here, name))).update("\0");
}

const result = await build({
  entryPoints: [join(here, "src/main.ts")],
  bundle: true,
  format: "esm",
  target: "es2022",
  charset: "utf8",
  minify: true,
  legalComments: "none",
  loader: { ".css": "text" },
  write: false,
  metafile: true,
});

/** The folders of the packages of which something is in the bundle. */
function packages({ outputs }) {
  const used = Object.values(outputs).flatMap(({ inputs }) => Object.entries(inputs).filter(([, part]) => part.bytesInOutput > 0));
  const folders = used.map(([name]) => resolve(name).replaceAll("\\", "/").match(/^.*\/node_modules\/(?:@[^/]+\/)?[^/]+(?=\/)/)?.[0]);
  return [...new Set(folders.filter(Boolean))].sort();
}

/** A package's name, version and licence in full. */
function notice(folder) {
  const { name, version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  const file = readdirSync(folder).find((entry) => /^(licen[cs]e|copying)(\.|$)/i.test(entry));
  if (!file) throw new Error(`${name}: has no licence file, which the bundle would have to carry`);
  return `${name} ${version} (${license})\n\n${readFileSync(join(folder, file), "utf8").trim()}`.replaceAll("*/", "* /");
}

const notices = packages(result.metafile).map((folder) => `/*! ${notice(folder)}\n*/\n`);
const first = `/* quintrig studio; sources sha256 ${hash.digest("hex")}; the licences of the packages in it follow */\n`;
const bundle = [first, ...notices, result.outputFiles[0].text].join("");
const temporary = `${out}.${process.pid}`;
writeFileSync(temporary, bundle);
renameSync(temporary, out);
console.log(`${relative(process.cwd(), out)}: ${(Buffer.byteLength(bundle) / 1024).toFixed(0)} KiB, with ${notices.length} licences of packages`);
