// Friction of a surface over a range of loads: every number is one that the library computed at that load.

/** Points of a curve. */
const POINTS = 121;
/** Of a normal distribution, 95 % lie within so many standard deviations. */
const COVERAGE = 1.959963984540054;

/** Loads evenly spaced in the logarithm, the ends exact. */
export function loadsOf(lightest, heaviest) {
  const step = Math.log(heaviest / lightest) / (POINTS - 1);
  return Float64Array.from({ length: POINTS }, (_, i) => (i === POINTS - 1 ? heaviest : lightest * Math.exp(i * step)));
}

/** The band's factor either way, of a quantity whose logarithm has this standard deviation. */
export const reach = (deviation) => Math.exp(COVERAGE * deviation);

/** By how much ln F changes with the logarithm of each parameter; of the strength, one factor on both slip stresses. */
function slopesAt(model, load) {
  const slopes = model.sensitivitiesAtLoad(load);
  return { ...slopes, slip_stress: slopes.slip_stress_1 + slopes.slip_stress_2 };
}

/** The covariance of ln F at two loads, with these slopes, where the parameters are independent of each other. */
const covariance = (one, other, spread) =>
  Object.entries(spread).reduce((sum, [name, part]) => sum + one[name] * other[name] * part ** 2, 0);

/**
 * The standard deviation of ln F that follows from those of the parameters. A measured point narrows it by Bayes' rule: the
 * covariance S of the logarithms becomes S - S h h' S/(h' S h + r^2), with the slopes h at the point and its relative error r.
 * @param {Record<string, number>} slopes of ln F
 * @param {Record<string, number>} spread standard deviations of logarithms, by parameter
 * @param {{ slopes: Record<string, number>, error: number } | undefined} point
 */
export function deviation(slopes, spread, point) {
  const prior = covariance(slopes, slopes, spread);
  if (!point) return Math.sqrt(prior);
  const ofPoint = covariance(point.slopes, point.slopes, spread) + point.error ** 2;
  const learned = ofPoint && covariance(slopes, point.slopes, spread) ** 2 / ofPoint;
  return Math.sqrt(Math.max(prior - learned, 0));
}

/** A coefficient with its band, which ends at the cap on coefficients as the coefficient does. */
export function banded(model, load, spread, point) {
  const mu = model.frictionAtLoad(load);
  const ratio = model.frictionForceAtLoad(load) / load;
  const cap = mu < ratio * (1 - 1e-12) ? mu : Infinity;
  const factor = reach(deviation(slopesAt(model, load), spread, point));
  return { mu, low: Math.min(ratio / factor, cap), high: Math.min(ratio * factor, cap) };
}

/**
 * The curve of a surface.
 * @param {Record<string, number>} spread standard deviations of logarithms, by parameter
 * @returns {{ model, band, loads, mu, low, high, states, warnings }} `band` gives the coefficient with its band at any load;
 *   the warnings are those somewhere between the loads
 */
export function curveOf(library, params, [lightest, heaviest], spread) {
  const model = new library.Model(params);
  try {
    const { calibrated, calibration_error: error } = model.params;
    const point = calibrated && { slopes: slopesAt(model, calibrated.calibration_load), error };
    const band = (load) => banded(model, load, spread, point);
    const loads = loadsOf(lightest, heaviest);
    const states = Array.from(loads, (load) => model.stateAtLoad(load));
    return { model, band, loads, states, warnings: model.checkLoads(lightest, heaviest), ...columns(Array.from(loads, band)) };
  } catch (error) {
    model.free();
    throw error;
  }
}

/**
 * Finds between which loads of a curve each of its warnings holds, once: `span`, its ends those of the curve if it holds there.
 * It takes about as long as the curve itself.
 */
export function findSpans({ model, loads, warnings }) {
  for (const warning of warnings) {
    if (warning.span) continue;
    const [lightest, heaviest] = model.warningLoads(warning.bit) ?? [NaN, NaN];
    warning.span = [Math.max(lightest, loads[0]), Math.min(heaviest, loads.at(-1))];
  }
}

/** Whether a warning holds in a part of the curve only, from one load to another. */
export const isPartial = ({ span }, loads) => span && span[0] < span[1] && (span[0] > loads[0] || span[1] < loads.at(-1));

const columns = (points) => ({
  mu: points.map(({ mu }) => mu),
  low: points.map(({ low }) => low),
  high: points.map(({ high }) => high),
});
