/** A basis as data: its functions as formulas, and its shape parameters with ranges (Python: basis/formulas.py). */

import { checkValues, sums } from "./formula-checks";
import type { Functions } from "./functions";
import { parse, quoted, RESERVED, type Node } from "./grammar";
import type { Series } from "./series";
import type { Jet } from "./taylor";
import { Tape } from "./tape";

const MOST_FUNCTIONS = 64, MOST_PARAMETERS = 24;

/** A shape parameter: its range, ends that are `open` left out, and the value that it starts from. */
export interface Parameter {
  readonly name: string;
  readonly low: number;
  readonly high: number;
  readonly start: number;
  readonly open: readonly [boolean, boolean];
}

/** A parameter from its name and range; Error where they are none. */
export function parameterOf(name: string, low: number, high: number, start?: number): Parameter {
  if (!/^[A-Za-z_]\w*$/.test(name)) throw new Error(`parameters: expected a name of letters, digits and _, found ${quoted(name.slice(0, 60))}`);
  if (name.length > 30 || RESERVED.includes(name)) {
    throw new Error(`parameters: ${quoted(name.slice(0, 40))} is ${name.length > 30 ? "longer than 30 letters" : "taken by the grammar"}; choose another name`);
  }
  if (!(low < high)) throw new Error(`parameters.${name}: expected a range [low, high] with low < high, found [${told(low)}, ${told(high)}]`);
  return { name, low, high, start: start ?? (low <= 0 && high >= 0 ? 0 : 0.5 * (low + high)), open: [false, false] };
}

/** Whether a value is in the range of a parameter. */
export const holds = ({ low, high, open }: Parameter, value: number): boolean =>
  (open[0] ? value > low : value >= low) && (open[1] ? value < high : value <= high);

/** The range of a parameter in words, such as [-4, 1]. */
export const rangeOf = ({ low, high, open }: Parameter): string => `${open[0] ? "(" : "["}${told(low)}, ${told(high)}${open[1] ? ")" : "]"}`;

/** A number with at most six digits. */
export const told = (value: number): string => String(Number(value.toPrecision(6)));

/** What a paper, a model file or an installed package says of a basis. */
export class Basis {
  readonly trees: readonly Node[];
  private off: { by: number; told: string } | null = null;

  /** `checked` formulas come from Python, which has looked at their values. Error naming the function and the character. */
  constructor(readonly name: string, readonly functions: readonly string[], readonly parameters: readonly Parameter[], checked = false) {
    const names = parameters.map((one) => one.name), count = functions.length;
    if (count < 2 || count > MOST_FUNCTIONS) throw new Error(`functions: expected 2 to ${MOST_FUNCTIONS} formulas, found ${count}`);
    if (names.length > MOST_PARAMETERS) throw new Error(`parameters: expected at most ${MOST_PARAMETERS}, found ${names.length}`);
    this.trees = functions.map((text, i) => {
      try {
        return parse(text, names);
      } catch (error) {
        throw new Error(`functions[${i}]: ${(error as Error).message}`);
      }
    });
    if (!checked) checkValues(this.trees, parameters);
  }

  get size(): number {
    return this.functions.length;
  }

  /** By how much the sum of the functions misses 1 at worst, in samples, and what it is where. */
  get offSum(): { by: number; told: string } {
    return (this.off ??= sums(this.trees, this.parameters));
  }

  /** Whether the functions sum to 1, as far as samples show. */
  get partition(): boolean {
    return this.offSum.by <= 1e-12;
  }
}

/** The functions of a basis at values of its parameters. */
export class Formulas implements Functions {
  readonly size: number;
  private readonly tape: Tape;

  constructor(private readonly basis: Basis, values: readonly number[]) {
    this.size = basis.size;
    this.tape = new Tape(basis.trees, Object.fromEntries(basis.parameters.map(({ name }, i) => [name, values[i]!])));
  }

  /** Whether the functions sum to 1. */
  get partition(): boolean {
    return this.basis.partition;
  }

  /** The Taylor series of every function at t, up to an order; they hold until the next call. */
  series(t: number, order: number): readonly Series[] {
    return this.tape.at(t, order);
  }

  derivatives(t: Float64Array, n: number, out: Float64Array): void {
    const m = this.size;
    for (let p = 0; p < n; p++) {
      this.series(t[p]!, 2).forEach((x, i) => {
        out[p * m + i] = x[0]!;
        out[(n + p) * m + i] = x[1]!;
        out[(2 * n + p) * m + i] = 2 * x[2]!;
      });
    }
  }

  /**
   * Write the series at t of what Σ f_i P_i has for derivative to `out`: of F_i' = f_(i+1)' + ... over the steps between
   * points where the functions sum to 1, summed over those that vanish at the nearer end; else of every f_i'.
   */
  slopes(t: number, _start: boolean, _end: boolean, out: readonly Jet[]): void {
    const series = this.series(t, 3), n = series.length - 1, steps = this.basis.partition;
    for (let k = 0; k < 3; k++) {
      if (!steps) for (let i = 0; i <= n; i++) out[i]![k] = (k + 1) * series[i]![k + 1]!;
      else if (t < 0.5) for (let i = n - 1, sum = 0; i >= 0; i--) out[i]![k] = sum += (k + 1) * series[i + 1]![k + 1]!;
      else for (let i = 0, sum = 0; i < n; i++) out[i]![k] = sum -= (k + 1) * series[i]![k + 1]!;
    }
  }
}
