// Friction of a surface over a range of loads: every number is one that the library computed at that load.

/** Points of a curve. */
const POINTS = 121;
/** Of a normal distribution, 95 % lie within so many standard deviations. */
const COVERAGE = 1.959963984540054;
/** Halvings of the interval in which a warning begins or ends: to 1/1000 of the distance of two points. */
const HALVINGS = 10;

/** Loads evenly spaced in the logarithm, the ends exact. */
export function loadsOf(lightest, heaviest) {
  const step = Math.log(heaviest / lightest) / (POINTS - 1);
  return Float64Array.from({ length: POINTS }, (_, i) => (i === POINTS - 1 ? heaviest : lightest * Math.exp(i * step)));
}

/**
 * The standard deviation of ln F that follows from those of the parameters, independent of each other.
 * @param {Record<string, number>} sensitivities
 * @param {Record<string, number>} spread by parameter, relative
 */
export const deviation = (sensitivities, spread) =>
  Math.sqrt(Object.entries(spread).reduce((sum, [name, part]) => sum + (sensitivities[name] * part) ** 2, 0));

/**
 * Sensitivities at a load, of a calibrated law those that are left: a parameter that changes the friction force at the measured
 * point changes the strength too, so that the point is met, and `measured_friction` is what the measured coefficient does.
 * @param {Record<string, number>} sensitivities
 * @param {Record<string, number> | undefined} anchor the sensitivities at the measured load
 */
export function anchored(sensitivities, anchor) {
  if (!anchor) return { ...sensitivities, measured_friction: 0 };
  const strength = (of) => of.slip_stress_1 + of.slip_stress_2;
  const ratio = strength(sensitivities) / strength(anchor);
  const left = Object.entries(sensitivities).map(([name, part]) => [name, part - ratio * anchor[name]]);
  return { ...Object.fromEntries(left), measured_friction: ratio };
}

/** A coefficient with its band, which ends at the cap on coefficients as the coefficient does. */
export function banded(model, load, spread, anchor) {
  const mu = model.frictionAtLoad(load);
  const ratio = model.frictionForceAtLoad(load) / load;
  const cap = mu < ratio * (1 - 1e-12) ? mu : Infinity;
  const reach = Math.exp(COVERAGE * deviation(anchored(model.sensitivitiesAtLoad(load), anchor), spread));
  return { mu, low: Math.min(ratio / reach, cap), high: Math.min(ratio * reach, cap) };
}

/**
 * The curve of a surface; of a calibrated one the band is that of a law that meets the measured point.
 * @returns {{ model, anchor, loads, mu, low, high, states, warnings }} the warnings with the loads between which each holds
 */
export function curveOf(library, params, [lightest, heaviest], spread) {
  const model = new library.Model(params);
  try {
    const loads = loadsOf(lightest, heaviest);
    const anchor = params.calibration_load && model.sensitivitiesAtLoad(params.calibration_load);
    const points = Array.from(loads, (load) => banded(model, load, spread, anchor));
    const states = Array.from(loads, (load) => model.stateAtLoad(load));
    const warnings = model.checkLoads(lightest, heaviest).map((warning) => ({
      ...warning,
      spans: spansOf(model, loads, states, warning.bit),
    }));
    return { model, anchor, loads, states, warnings, ...columns(points) };
  } catch (error) {
    model.free();
    throw error;
  }
}

const columns = (points) => ({
  mu: points.map(({ mu }) => mu),
  low: points.map(({ low }) => low),
  high: points.map(({ high }) => high),
});

/** Where a warning holds: pairs of loads. */
function spansOf(model, loads, states, bit) {
  const spans = [];
  const holds = states.map(({ warnings }) => (warnings & bit) !== 0);
  for (let i = 0; i < loads.length; i++) {
    if (!holds[i]) continue;
    const from = i === 0 ? loads[0] : edge(model, loads[i - 1], loads[i], bit);
    while (holds[i + 1]) i++;
    const to = i === loads.length - 1 ? loads[i] : edge(model, loads[i], loads[i + 1], bit);
    spans.push([from, to]);
  }
  return spans;
}

/** The load between two at which a warning begins or ends. */
function edge(model, low, high, bit) {
  const atLow = (model.stateAtLoad(low).warnings & bit) !== 0;
  for (let i = 0; i < HALVINGS; i++) {
    const middle = Math.sqrt(low * high);
    if (((model.stateAtLoad(middle).warnings & bit) !== 0) === atLow) low = middle;
    else high = middle;
  }
  return Math.sqrt(low * high);
}
