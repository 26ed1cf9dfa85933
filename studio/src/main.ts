export * from "./numerics/index";
