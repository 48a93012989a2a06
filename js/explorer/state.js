// What is set and what is shown, for all parts of the page.
import { STYLES } from "./chart.js";

export const LETTERS = ["A", "B", "C", "D"];

export const page = {
  /** The library and the chart, once they are there. */
  library: undefined,
  chart: undefined,
  /** What is set: surfaces by letter, the one that the fields show. */
  surfaces: new Map(),
  active: "A",
  /** What is shown of each surface that the library takes: letter, surface, style, how well it is known, curve. */
  shown: [],
  /** Where the values are read, from 0 at the lightest load to 1 at the heaviest. */
  readAt: 0.5,
};

export const active = () => page.surfaces.get(page.active);

export const styleOf = (letter) => STYLES[LETTERS.indexOf(letter)];

/** The load at which the values are read. */
export function readLoad() {
  const { loads } = page.shown[0].curve;
  const [lightest, heaviest] = [loads[0], loads.at(-1)];
  return lightest * (heaviest / lightest) ** page.readAt;
}
