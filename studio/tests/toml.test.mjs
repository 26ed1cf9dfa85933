// Model files as TOML: what is written is read back as it was.
import assert from "node:assert/strict";
import { test } from "node:test";
import lists from "../../tests/data/toml_1_0.json" with { type: "json" };
import data from "../src/data.json" with { type: "json" };
import { load } from "./load.mjs";

const { fromToml, toToml } = await load("toml.ts");
const { fromDict, toDict } = await load("numerics/index.ts");

for (const preset of data.presets) {
  test(`${preset.name} survives`, () => {
    const model = fromDict(preset);
    assert.deepEqual(fromToml(toToml(model)), toDict(model));
  });
}

test("bases of its own survive, in one patch and in several", () => {
  const bases = { mine: { functions: ["r*(1+lam*t*r)", "t*(1-lam*r^2)"], parameters: { lam: [-0.5, 0.5, 0.1] }, source: "A paper, eq. 2" }, plain: { functions: ["r", "t"] } };
  const one = { kind: "tensor", basis: ["mine", "plain"], bases, points: [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]] };
  for (const keys of [{ name: "one", ...one }, { name: "two", patch: [{ name: "a", ...one }, { name: "b", kind: "sphere" }] }]) {
    const model = fromDict(keys);
    assert.deepEqual(fromToml(toToml(model)), toDict(model));
    assert.deepEqual(toDict(fromDict(fromToml(toToml(model)))), toDict(model));
  }
});

for (const name of ['with "quotes" and \\', "ε, 日本, 🦋", "\ta tab"]) {
  test(`the name ${JSON.stringify(name)} survives`, () => {
    assert.equal(fromToml(toToml(fromDict({ kind: "sphere", name }))).name, name);
  });
}

test("a mistake is told with its place", () => {
  assert.throws(() => fromToml("kind = "), /^Error: not valid TOML: .* \(at line 1, column \d+\)$/);
});

for (const [text, line] of lists.refused) {
  test(`${JSON.stringify(text)} is refused, as by Python`, () => {
    assert.throws(() => fromToml(text), new RegExp(`^Error: not valid TOML: .* \\(at line ${line}, column \\d+\\)$`));
  });
}

for (const text of lists.read) test(`${JSON.stringify(text)} is read, as by Python`, () => void fromToml(text));
