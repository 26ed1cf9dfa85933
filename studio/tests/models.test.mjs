// Models: every kind of quintrig starts, is built and comes back, and what is wrong is said in one line.
import assert from "node:assert/strict";
import { test } from "node:test";
import data from "../src/data.json" with { type: "json" };
import { load } from "./load.mjs";

const { analyse, besl, build, BUILDERS, curveOf, fromDict, install, KINDS, shapeClass, toDict } = await load("numerics/index.ts");

test("there is a builder for every kind of quintrig, and for no other", () => {
  assert.deepEqual(Object.keys(BUILDERS).sort(), Object.keys(data.kinds).filter((kind) => data.kinds[kind].surface).sort());
});

for (const [kind, starter] of Object.entries(data.starters)) {
  test(`${kind}: the starter is built, and written as it was read`, () => {
    const model = fromDict(starter);
    if (data.kinds[kind].surface) assert.ok(analyse(build(model.patches[0]), [0.37], [0.58]).curvedness[0] >= 0);
    else assert.ok(curveOf(model.patches[0]).length > 0);
    assert.deepEqual(toDict(fromDict(toDict(model))), toDict(model));
  });
}

test("a sphere has K = 1 / r²", () => {
  const surface = build(fromDict({ kind: "sphere", radius: 4 }).patches[0]);
  for (const k of analyse(surface, [0.2, 0.5], [0.1, 0.9]).gaussian) assert.ok(Math.abs(k - 1 / 16) < 1e-16);
});

for (const [keys, said] of [
  [{ kind: "spere" }, /^patch "spere": kind: expected one of tensor,/],
  [{ kind: "constructor" }, /^patch "constructor": kind: expected one of tensor,/],
  [{ kind: "sphere", constructor: 1 }, /^patch "sphere": unknown key 'constructor'$/],
  [{ kind: "sphere", radius: -1 }, /^patch "sphere": radius: expected a number greater than 0, got -1$/],
  [{ kind: "sphere", radius: 1e51 }, /^patch "sphere": radius: expected a number of size at most 1e50, got 1e\+51$/],
  [{ kind: "sphere", size: 1 }, /^patch "sphere": unknown key 'size'$/],
  [{ ...data.starters.swept, shape: [0, 2, 0, 0] }, /shape\[1\] \(zeta1\) = 2 is outside \[-4, 1\]/],
  [{ ...data.starters.developable, shape: [0, 2] }, /shape\[1\] \(zeta\) = 2 is outside/],
]) {
  test(`it is said what is wrong with ${JSON.stringify(keys).slice(0, 60)}`, () => {
    assert.throws(() => fromDict(keys), (error) => said.test(error.message) && !error.message.includes("\n"));
  });
}

test("a quarter circle of the cubic basis is one: radius, curvature and length", () => {
  const r = 3, points = [[r, 0], [r, 0.5 * r], [0.5 * r, r], [0, r]];
  const curve = curveOf(fromDict({ kind: "curve", basis: "cubic", points }).patches[0]);
  for (const t of [0, 0.2, 0.6, 1]) {
    const { point, curvature } = curve.at(t);
    assert.ok(Math.abs(Math.hypot(...point) - r) < 2e-15 * r && Math.abs(curvature - 1 / r) < 1e-14, `t = ${t}`);
  }
  assert.ok(Math.abs(curve.length - 0.5 * Math.PI * r) < 1e-9);
});

test("bases that patches share stand once, and come back to each", () => {
  const bases = { mine: { functions: ["r", "t"] } }, one = { kind: "curve", points: [[0, 0], [1, 2]], basis: "mine" };
  const keys = { name: "two", bases, patch: [{ ...one, name: "a" }, { ...one, name: "b", points: [[1, 0], [0, 3]] }] };
  const model = fromDict(keys);
  assert.deepEqual(model.patches.map((patch) => patch.bases), [bases, bases]);
  assert.deepEqual(toDict(model), { schema: 1, ...keys });
});

test("curves of both dimensions are no model; curves beside surfaces are", () => {
  const curve = (points) => ({ kind: "curve", name: String(points), basis: "bernstein", points });
  assert.throws(() => fromDict({ patch: [curve([[0, 0], [1, 2]]), curve([[0, 0, 0], [1, 2, 3]])] }), /all in the plane or all in space/);
  assert.equal(fromDict({ patch: [curve([[0, 0], [1, 2]]), { kind: "sphere", name: "ball" }] }).patches.length, 2);
});

test("a kind that a package brings does not take the place of one of ours", () => {
  const { title } = KINDS.sphere;
  install({ kinds: { sphere: { ...KINDS.sphere, title: "A rival" }, pear: { ...KINDS.sphere, title: "Pear" } } });
  assert.equal(KINDS.sphere.title, title);
  assert.equal(KINDS.pear.title, "Pear");
  assert.throws(() => fromDict({ kind: "pear" }), /a pear is built by Python, which a page from disk lacks/);
});

test("breaks between Koenderink's classes belong to the class nearer to a saddle", () => {
  const nudge = 1e-12;
  data.shapeBreaks.forEach((edge, i) => {
    assert.deepEqual([-edge - nudge, -edge, edge, edge + nudge].map((s) => shapeClass(s, 3)), [4 - i, 5 - i, 5 + i, 6 + i]);
  });
  assert.equal(shapeClass(0.3, 0), 0);
  assert.equal(shapeClass(0.3, 5), 10);
});

test("Besl's numbers run from peak to saddle valley", () => {
  const found = [-1, 0, 1].flatMap((h) => [1, 0, -1].map((k) => besl(k, h, 2, 1e-6, 1e-6)));
  assert.deepEqual(found, [1, 2, 3, 4, 5, 6, 7, 8, 9]);
  assert.equal(besl(Number.NaN, Number.NaN, Number.NaN, 1e-6, 1e-6), 0);
});
