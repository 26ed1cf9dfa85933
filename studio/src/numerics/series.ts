/** Arithmetic of Taylor series of any order, as in Python's support/taylor.py: x[k] is the k-th derivative divided by k!. */

export type Series = Float64Array;

/** Write the series of x y to `out`, which is neither. */
export function times(x: Series, y: Series, out: Series): void {
  for (let k = 0; k < out.length; k++) {
    let sum = 0;
    for (let i = 0; i <= k; i++) sum += x[i]! * y[k - i]!;
    out[k] = sum;
  }
}

/** Write the series of x / y to `out`, which is neither. */
export function over(x: Series, y: Series, out: Series): void {
  for (let k = 0; k < out.length; k++) {
    let rest = x[k]!;
    for (let i = 0; i < k; i++) rest -= out[i]! * y[k - i]!;
    out[k] = rest / y[0]!;
  }
}

/** Write the series of sqrt(x) to `out`. */
export function root(x: Series, out: Series): void {
  out[0] = Math.sqrt(x[0]!);
  for (let k = 1; k < out.length; k++) {
    let rest = x[k]!;
    for (let i = 1; i < k; i++) rest -= out[i]! * out[k - i]!;
    out[k] = rest / (2 * out[0]);
  }
}

/** Write the series of a function with derivative `slope`(x), itself a series of the same x, to `out` beyond its value. */
function integrate(x: Series, slope: Series, sign: number, out: Series, k: number): void {
  let sum = 0;
  for (let j = 1; j <= k; j++) sum += j * x[j]! * slope[k - j]!;
  out[k] = (sign * sum) / k;
}

/** Write the series of exp(x) to `out`. */
export function exponential(x: Series, out: Series): void {
  out[0] = Math.exp(x[0]!);
  for (let k = 1; k < out.length; k++) integrate(x, out, 1, out, k);
}

let sines = new Float64Array(0), cosines = new Float64Array(0), versines = new Float64Array(0);

/** The series of sin x, cos x and 1 - cos x, or of sinh x, cosh x and cosh x - 1, until the next call; none cancels. */
export function waves(x: Series, hyperbolic: boolean): { sine: Series; cosine: Series; versine: Series } {
  if (sines.length !== x.length) [sines, cosines, versines] = [x.slice(), x.slice(), x.slice()];
  const value = x[0]!, turn = hyperbolic ? 1 : -1;
  sines[0] = hyperbolic ? Math.sinh(value) : Math.sin(value);
  cosines[0] = hyperbolic ? Math.cosh(value) : Math.cos(value);
  versines[0] = 2 * (hyperbolic ? Math.sinh(0.5 * value) : Math.sin(0.5 * value)) ** 2;
  for (let k = 1; k < x.length; k++) {
    integrate(x, cosines, 1, sines, k);
    integrate(x, sines, 1, versines, k);
    cosines[k] = turn * versines[k]!;
  }
  return { sine: sines, cosine: cosines, versine: versines };
}

/** Write the series of x - sin x, or of sinh x - x, to `out`; by their power series where x is small. */
export function rest(x: Series, hyperbolic: boolean, out: Series): void {
  const value = x[0]!, square = hyperbolic ? value * value : -value * value;
  let near = 0;
  for (let k = 10; k > 1; k--) near = ((1 + near) * square) / (2 * k * (2 * k + 1));
  const far = hyperbolic ? Math.sinh(value) - value : value - Math.sin(value);
  const { versine } = waves(x, hyperbolic);
  out[0] = Math.abs(value) < 1.5 ? (value ** 3 * (1 + near)) / 6 : far;
  for (let k = 1; k < out.length; k++) integrate(x, versine, 1, out, k);
}
