// Friction of a surface over a range of loads: every number is one that the library computed at that load.

/** Points of a curve. */
const POINTS = 121;

/** Loads evenly spaced in the logarithm, the ends exact. */
export function loadsOf(lightest, heaviest) {
  const step = Math.log(heaviest / lightest) / (POINTS - 1);
  return Float64Array.from({ length: POINTS }, (_, i) => (i === POINTS - 1 ? heaviest : lightest * Math.exp(i * step)));
}

/** A coefficient of the model, which the copied programs compute too, or of the specimen that was measured, in its band. */
const banded = (model, { load, low, high, measured_specimens, friction_coefficient }) => ({
  mu: measured_specimens ? friction_coefficient : model.frictionAtLoad(load), low, high,
});

/**
 * The curve of a surface.
 * @param {string} text of its surface file
 * @returns {{ model, band, loads, mu, low, high, states, warnings }} `band` gives the coefficient with its band at any load;
 *   the warnings are those somewhere between the loads
 */
export function curveOf(library, text, [lightest, heaviest]) {
  const model = new library.Model(text);
  try {
    const band = (load) => banded(model, library.estimate(text, load));
    const loads = loadsOf(lightest, heaviest);
    const states = Array.from(loads, (load) => model.stateAtLoad(load));
    return { model, band, loads, states, warnings: model.checkLoads(lightest, heaviest), ...columns(library.estimate(text, loads).map((found) => banded(model, found))) };
  } catch (error) {
    model.free();
    throw error;
  }
}

/**
 * Finds between which loads of a curve each of its warnings holds, once: `span`, its ends those of the curve if it holds there;
 * NaN if it holds between two points of the curve alone.
 */
export function findSpans({ model, loads, states, warnings }) {
  for (const warning of warnings) {
    if (warning.span) continue;
    const holds = (state) => (state.warnings & warning.bit) !== 0;
    const [first, last] = [states.findIndex(holds), states.findLastIndex(holds)];
    const edge = (inside, outside) => (outside in loads ? bisected(loads[inside], loads[outside], (load) => holds(model.stateAtLoad(load))) : loads[inside]);
    warning.span = first < 0 ? [NaN, NaN] : [edge(first, first - 1), edge(last, last + 1)];
  }
}

/** The load next to `outside` at which something holds that holds at `inside`, to some 1e-5. */
function bisected(inside, outside, holds) {
  for (let i = 0; i < 13; i++) {
    const middle = Math.sqrt(inside * outside);
    if (holds(middle)) inside = middle;
    else outside = middle;
  }
  return inside;
}

/** Whether a warning holds in a part of the curve only, from one load to another. */
export const isPartial = ({ span }, loads) => span && span[0] < span[1] && (span[0] > loads[0] || span[1] < loads.at(-1));

const columns = (points) => ({
  mu: points.map(({ mu }) => mu),
  low: points.map(({ low }) => low),
  high: points.map(({ high }) => high),
});
