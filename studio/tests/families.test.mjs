// Every family of functions: what it sums to, and that its derivatives are those of its values.
import assert from "node:assert/strict";
import { test } from "node:test";
import data from "../src/data.json" with { type: "json" };
import { load } from "./load.mjs";

const { FAMILIES, family, functionsOf, LIBRARY } = await load("numerics/index.ts");

const EXAMPLES = {
  trigonometric: { alpha: -1.5, zeta: 0.7 },
  bernstein: { degree: 4 },
  bspline: { knots: [0, 0, 0, 0, 0.4, 1, 1, 1, 1], degree: 3 },
  circular: { start: -1, end: 2.5 },
  hyperbolic: { start: -1, end: 0.5 },
  powers: { start: -2, end: 3, degree: 4 },
  joined: { parts: [{ family: "powers", start: 0, end: 1, degree: 1 }, { family: "bernstein", degree: 2 }] },
  formulas: { functions: ["r^2*(1+k*t)", "t^2+r*t*(2-k*r)"], names: ["k"], values: [0.7] },
  // T0 + 2 T1 and T2, of x = 2t - 1: 4t - 1 and 2x² - 1
  chebyshev: { breaks: [0, 1], series: [[[[1, 0], [2, 0], [0, 1]], [[4, 0], [0, 8], [0, 0]], [[0, 16], [0, 0], [0, 0]]]] },
};
const SUM_TO_ONE = ["trigonometric", "bernstein", "bspline", "formulas"];

/** Derivatives 0 to 2 of all functions at one t, as rows. */
function at(functions, t) {
  const out = new Float64Array(3 * functions.size);
  functions.derivatives(Float64Array.of(t), 1, out);
  return [0, 1, 2].map((k) => Array.from(out.subarray(k * functions.size, (k + 1) * functions.size)));
}

test("there are the families and bases that Python speaks of, and examples of each", () => {
  assert.deepEqual(Object.keys(FAMILIES).sort(), [...data.families].sort());
  assert.deepEqual(Object.keys(LIBRARY), data.library.map(({ name }) => name));
  assert.deepEqual(Object.keys(EXAMPLES).sort(), Object.keys(FAMILIES).sort());
});

for (const [family, keys] of Object.entries(EXAMPLES)) {
  test(`${family}: derivatives are those of the values`, () => {
    const functions = functionsOf({ family, ...keys }), h = 1e-5;
    for (const t of [0.11, 0.3, 0.62, 0.87]) {
      const [before, here, after] = [t - h, t, t + h].map((x) => at(functions, x));
      for (let i = 0; i < functions.size; i++) {
        for (const k of [0, 1]) {
          const slope = (after[k][i] - before[k][i]) / (2 * h), scale = 1 + Math.abs(here[k + 1][i]);
          assert.ok(Math.abs(slope - here[k + 1][i]) < 1e-6 * scale, `function ${i}, order ${k + 1}, t = ${t}`);
        }
      }
    }
  });
}

for (const family of SUM_TO_ONE) {
  test(`${family}: the functions sum to one, their derivatives to nothing`, () => {
    const functions = functionsOf({ family, ...EXAMPLES[family] });
    for (const t of [0, 0.25, 0.5, 0.9, 1]) {
      const sums = at(functions, t).map((row) => row.reduce((sum, x) => sum + x, 0));
      assert.ok(Math.abs(sums[0] - 1) < 1e-14 && Math.abs(sums[1]) < 1e-12 && Math.abs(sums[2]) < 1e-11, `${sums}`);
    }
  });
}

test("chebyshev: the series are what they say", () => {
  const functions = functionsOf({ family: "chebyshev", ...EXAMPLES.chebyshev });
  assert.deepEqual(at(functions, 0.75), [[2, -0.5], [4, 4], [0, 16]]);
});

for (const { name, sizes } of data.library) {
  test(`${name}: from its formulas, the functions sum to one, start in the first point and end in the last`, () => {
    for (const points of sizes.filter((n) => n <= 8)) {
      const values = LIBRARY[name].basis(points).parameters.map(({ low, high }) => low + 0.6 * (high - low));
      const functions = family(LIBRARY[name], points, values);
      for (const t of [0, 0.2, 0.7, 1]) {
        const [sum, slope, bend] = at(functions, t).map((row) => row.reduce((all, x) => all + x, 0));
        assert.ok(Math.abs(sum - 1) < 1e-12 && Math.abs(slope) < 1e-10 && Math.abs(bend) < 1e-9, `${points} points, t = ${t}: ${sum}, ${slope}, ${bend}`);
      }
      assert.ok(Math.abs(at(functions, 0)[0][0] - 1) < 1e-12 && Math.abs(at(functions, 1)[0].at(-1) - 1) < 1e-12);
    }
  });
}

test("a family that the page does not know is named", () => {
  assert.throws(() => functionsOf({ family: "splines" }), /the page does not know splines functions/);
});
