// Lets Node import TypeScript from src/: bundled in memory, by what builds the studio.
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const source = join(dirname(fileURLToPath(import.meta.url)), "../src");

/** The module src/NAME. */
export async function load(name) {
  const options = { bundle: true, format: "esm", platform: "node", write: false };
  const { outputFiles } = await build({ ...options, entryPoints: [join(source, name)] });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString("base64")}`);
}
