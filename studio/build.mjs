// Builds src/ into the one file that the Python package ships: node build.mjs [OUT]
// The first line of the bundle holds a hash of the sources, so that a test can tell when it is out of date.
import { createHash } from "node:crypto";
import { readFileSync, readdirSync, renameSync, writeFileSync } from "node:fs";
import { dirname, join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(here, "../src/quintrig/studio/bundle/studio.js");

const walk = (folder) =>
  readdirSync(folder, { withFileTypes: true }).flatMap((entry) =>
    entry.isDirectory() ? walk(join(folder, entry.name)) : [join(folder, entry.name)],
  );
const sources = [...walk(join(here, "src")), join(here, "build.mjs"), join(here, "package.json"), join(here, "tsconfig.json")];
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
  banner: { js: `/* quintrig studio; sources sha256 ${hash.digest("hex")}; contains three.js (MIT, three.js authors) */` },
});
const temporary = `${out}.${process.pid}`;
writeFileSync(temporary, result.outputFiles[0].contents);
renameSync(temporary, out);
console.log(`${relative(process.cwd(), out)}: ${(result.outputFiles[0].contents.length / 1024).toFixed(0)} KiB`);
