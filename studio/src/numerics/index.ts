/** The numerics by themselves: what the agreement test runs in Node and in the browser. */

export { analyse } from "./sample";
export { build, fromDict, toDict, type Model, type Patch } from "./model";
export { QUANTITIES, QUANTITY } from "./quantity";
export { besl, pointType, shapeClass } from "./classify";
export { shapeParameters } from "./chosen";
export { curveOf } from "./curve";
export { BUILDERS } from "./builders";
export { FAMILIES, functionsOf } from "./families";
export { Formulas } from "./formulas";
export { parse } from "./grammar";
export { install, KINDS } from "./kinds";
export { entry, family, LIBRARY } from "./library";
export { seams } from "./seams";
