// Spectral moments of a rough surface, from areal parameters or from a height map, as asperity.Params.from_iso25178 and
// asperity.surface of the Python package compute them.

import { numberOf } from "./library.js";

/** Variances of height, slope and, where it is known, curvature along profiles. @typedef {{ m0: number, m2: number, m4?: number }} Moments */

/**
 * Of an isotropic surface, from what an instrument tells. Lengths in one unit, in m for SI.
 * @param {{ Sq: number, Sdq: number, Sds?: number, Ssc?: number }} areal Sq [length] and Sdq; where it is known, which hardly
 *   matters, the mean curvature of the summits Ssc [1/length], or their density Sds [1/length^2]
 * @returns {Moments}
 */
export function momentsOfAreal({ Sq, Sdq, Sds, Ssc }) {
  for (const [name, value] of Object.entries({ Sq, Sdq, Sds, Ssc }))
    if (value !== undefined && !(value > 0 && Number.isFinite(value)))
      throw new RangeError(`${name} = ${value}: must be finite and > 0`);
  const m2 = (Sdq * Sdq) / 2;
  const moments = { m0: Sq * Sq, m2 };
  if (Ssc !== undefined) return { ...moments, m4: ((9 * Math.PI) / 64) * Ssc * Ssc };
  return Sds === undefined ? moments : { ...moments, m4: 6 * Math.PI * Math.sqrt(3) * m2 * Sds };
}

/**
 * Of a height map, less its mean plane: from differences between neighbouring heights, means over both directions.
 * @param {ArrayLike<number>} heights row after row
 * @param {number} columns in a row
 * @param {number} dx distance of columns, in the unit of the heights
 * @param {number} [dy] distance of rows; by default dx
 * @returns {Required<Moments> & { area: number, isotropy: number }} also the area of the map, and the lesser over the greater
 *   principal mean square slope: 1 for isotropic surfaces, 0 for grooves
 */
export function momentsOfMap(heights, columns, dx, dy = dx) {
  const rows = heights.length / numberOf("columns", columns);
  if (!Number.isInteger(rows))
    throw new RangeError(`height map: ${heights.length} heights in rows of ${columns}: the last row is not whole`);
  if (!(rows >= 3 && columns >= 3))
    throw new RangeError(`height map: ${heights.length} heights in rows of ${columns}: must be at least 3 rows and 3 columns`);
  for (const [name, value] of Object.entries({ dx, dy }))
    if (!(value > 0 && Number.isFinite(value))) throw new RangeError(`${name} = ${value}: must be finite and > 0`);
  const level = levelled(heights, rows, columns);
  const sums = sumsOf(level, rows, columns);
  const m0 = sums.height / (rows * columns);
  const alongX = sums.x / (rows * (columns - 1)) / dx ** 2;
  const alongY = sums.y / ((rows - 1) * columns) / dy ** 2;
  const bentX = sums.xx / (rows * (columns - 2)) / dx ** 4;
  const bentY = sums.yy / ((rows - 2) * columns) / dy ** 4;
  const m2 = (alongX + alongY) / 2;
  if (!(m0 > 0 && m2 > 0)) throw new RangeError("height map: flat but for its tilt: must be rough");
  const inner = (rows - 2) * (columns - 2);
  const [gxx, gxy, gyy] = [sums.gxx / dx ** 2, sums.gxy / dx / dy, sums.gyy / dy ** 2].map((sum) => sum / inner);
  const [mean, half] = [(gxx + gyy) / 2, Math.hypot((gxx - gyy) / 2, gxy)];
  const isotropy = mean > 0 ? Math.max((mean - half) / (mean + half), 0) : 0;
  return { m0, m2, m4: (bentX + bentY) / 2, area: rows * dy * columns * dx, isotropy };
}

/**
 * The heights less their mean plane, by least squares; rows and columns counted from the middle make the three terms
 * orthogonal.
 * @param {ArrayLike<number>} heights @param {number} rows @param {number} columns
 */
function levelled(heights, rows, columns) {
  let [sum, alongX, alongY] = [0, 0, 0];
  const [midX, midY] = [(columns - 1) / 2, (rows - 1) / 2];
  for (let i = 0; i < rows; i++)
    for (let j = 0; j < columns; j++) {
      const height = heights[i * columns + j];
      if (!Number.isFinite(height))
        throw new RangeError(`height map: ${height} in row ${i + 1}, column ${j + 1}: all heights must be known numbers`);
      sum += height;
      alongX += (j - midX) * height;
      alongY += (i - midY) * height;
    }
  const count = rows * columns;
  const mean = sum / count;
  const slopeX = (alongX * 12) / (count * (columns ** 2 - 1));
  const slopeY = (alongY * 12) / (count * (rows ** 2 - 1));
  const level = new Float64Array(count);
  for (let i = 0; i < rows; i++)
    for (let j = 0; j < columns; j++) {
      const at = i * columns + j;
      level[at] = heights[at] - mean - slopeX * (j - midX) - slopeY * (i - midY);
    }
  return level;
}

/** Sums of squares of heights and their differences. @param {Float64Array} z @param {number} rows @param {number} columns */
function sumsOf(z, rows, columns) {
  const sums = { height: 0, x: 0, y: 0, xx: 0, yy: 0, gxx: 0, gxy: 0, gyy: 0 };
  for (let i = 0; i < rows; i++)
    for (let j = 0; j < columns; j++) {
      const at = i * columns + j;
      const [right, below] = [j + 1 < columns, i + 1 < rows];
      sums.height += z[at] ** 2;
      if (right) sums.x += (z[at + 1] - z[at]) ** 2;
      if (below) sums.y += (z[at + columns] - z[at]) ** 2;
      if (j + 2 < columns) sums.xx += (z[at + 2] - 2 * z[at + 1] + z[at]) ** 2;
      if (i + 2 < rows) sums.yy += (z[at + 2 * columns] - 2 * z[at + columns] + z[at]) ** 2;
      if (!right || !below || !i || !j) continue;
      // Both slopes at the four corners that an inner point makes with its neighbours.
      const [after, before] = [z[at + 1] - z[at], z[at] - z[at - 1]];
      const [under, over] = [z[at + columns] - z[at], z[at] - z[at - columns]];
      sums.gxx += (after ** 2 + before ** 2) / 2;
      sums.gxy += ((after + before) * (under + over)) / 4;
      sums.gyy += (under ** 2 + over ** 2) / 2;
    }
  return sums;
}
