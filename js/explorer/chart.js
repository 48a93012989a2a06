// The chart: friction coefficient against load, with bands, and grounds that tell which assumptions fail.
import uPlot from "uplot";
import { isPartial } from "./curves.js";
import { measuredOf } from "./fields.js";
import { SHORT, coefficient, decade, strength, title } from "./text.js";

/** Okabe and Ito's colours, which the colour-blind can tell, and dashes for who prints in black. */
export const STYLES = [
  { color: "#0072B2", dash: [] },
  { color: "#C44E00", dash: [9, 4] },
  { color: "#007A5A", dash: [9, 3, 2, 3] },
  { color: "#A3457C", dash: [2, 3] },
];

/** Grounds of assumptions that fail; the first that applies is drawn, all are named. */
const GROUNDS = { FEW: "#dedede", CROWDED: "#fdf3c9", PLASTIC: "#f2f0f9", STEEP: "#eaf4f0", ATOMIC: "#f7eef3", ADHESIVE: "#f8eedf",
  BROAD: "#eef1e6", STRONG: "#f6ebe6", FEW_WAVES: "#e9eef6" };
const OTHER_GROUND = "#eeeeee";
/** How opaque a band and its edges are, in hexadecimal: of the active surface, of the others. Grounds must be seen through it. */
const BAND = [["1c", "80"], ["0c", "40"]];
const FONT = "system-ui, sans-serif";
const INK = "#222";

/** The chart in an element; `onPoint` is told the load under the pointer. */
export class Chart {
  constructor(element, onPoint) {
    this.element = element;
    this.onPoint = onPoint;
    this.shown = null;
    this.load = null;
    new ResizeObserver(() => this.shown && this.#draw()).observe(element);
  }

  /**
   * Shows curves.
   * @param {{ letter, surface, curve, style }[]} curves
   * @param {{ active, logarithmic, band }} options the curve whose grounds are drawn; the axis of friction
   */
  show(curves, options) {
    this.shown = { curves, options };
    this.#draw();
  }

  /** Marks a load. */
  mark(load) {
    this.load = load;
    this.plot?.redraw(false);
  }

  #draw() {
    const { curves, options } = this.shown;
    this.plot?.destroy();
    this.plot = undefined;
    if (!curves.length) return;
    const narrow = this.element.clientWidth < 520;
    const data = [curves[0].curve.loads];
    const series = [{}];
    const bands = [];
    for (const { letter, curve, style } of options.band ? curves : []) {
      const [fill, stroke] = BAND[letter === options.active ? 0 : 1].map((opaque) => style.color + opaque);
      const edge = { stroke, width: 1, pxAlign: 0, points: { show: false } };
      bands.push({ series: [data.length, data.length + 1], fill });
      data.push(curve.high, curve.low);
      series.push(edge, edge);
    }
    // Every curve after all bands, which would lie over it.
    for (const { curve, style } of curves) {
      data.push(curve.mu);
      series.push({ stroke: style.color, width: 2.5, dash: style.dash, pxAlign: 0, points: { show: false } });
    }
    this.plot = new uPlot(
      {
        width: this.element.clientWidth,
        height: Math.round(Math.min(Math.max(this.element.clientWidth * 0.58, 300), 520)),
        padding: [14, narrow ? 26 : 96, 0, 4],
        legend: { show: false },
        cursor: { y: false, drag: { x: false, y: false }, points: { show: false } },
        scales: { x: { time: false, distr: 3, range: (_, low, high) => [low, high] }, y: yScale(curves, options) },
        axes: [this.#loadAxis(narrow), this.#frictionAxis(options)],
        series,
        bands,
        hooks: {
          drawClear: [(plot) => this.#grounds(plot)],
          draw: [(plot) => this.#labels(plot, narrow), (plot) => this.#measured(plot), (plot) => this.#mark(plot)],
          setCursor: [(plot) => this.#pointed(plot)],
        },
      },
      data,
      this.element,
    );
  }

  #loadAxis(narrow) {
    const decades = (plot) => {
      const [low, high] = [plot.scales.x.min, plot.scales.x.max].map(Math.log10);
      const every = Math.ceil((high - low) / (narrow ? 5 : 10));
      const found = [];
      for (let power = Math.ceil(low - 1e-9); power <= high + 1e-9; power++) if (power % every === 0) found.push(10 ** power);
      return found;
    };
    return {
      ...AXIS,
      label: "Normal load",
      size: 34,
      labelSize: 24,
      splits: decades,
      values: (_, splits) => splits.map(decade),
    };
  }

  #frictionAxis({ logarithmic }) {
    const values = (_, splits) => splits.map((value) => String(Number(value.toPrecision(6))));
    return { ...AXIS, label: "Friction coefficient μ", size: 58, values, ...(logarithmic ? { splits: logSplits } : {}) };
  }

  /** Which assumptions fail for the active surface, as grounds with names. */
  #grounds(plot) {
    const { curves, options } = this.shown;
    const { curve } = curves.find(({ letter }) => letter === options.active) ?? curves[0];
    const { ctx } = plot;
    const { left, top, width, height } = plot.bbox;
    const ratio = devicePixelRatio;
    ctx.save();
    ctx.beginPath();
    ctx.rect(left, top, width, height);
    ctx.clip();
    const order = Object.keys(GROUNDS);
    // What holds at every load is said below the chart; a ground would cover all of it.
    const warnings = curve.warnings.filter((warning) => isPartial(warning, curve.loads));
    const sorted = warnings.sort((one, other) => order.indexOf(other.name) - order.indexOf(one.name));
    const edges = sorted.map((warning) => ({ warning, x: warning.span.map((load) => plot.valToPos(load, "x", true)) }));
    for (const { warning, x } of edges) {
      ctx.fillStyle = GROUNDS[warning.name] ?? OTHER_GROUND;
      ctx.fillRect(x[0], top, x[1] - x[0], height);
    }
    ctx.font = `${12 * ratio}px ${FONT}`;
    ctx.textAlign = "left";
    ctx.textBaseline = "top";
    let y = top + 6 * ratio;
    for (const { warning, x } of edges.reverse()) {
      const margin = 5 * ratio;
      const seen = Math.min(x[1], left + width) - Math.max(x[0], left);
      const lines = wrapped(ctx, SHORT[warning.name] ?? warning.name, seen - margin);
      const room = Math.max(...lines.map((line) => ctx.measureText(line).width)) + 2 * margin;
      const at = Math.max(left, Math.min(x[0], left + width - room));
      ctx.fillStyle = "#555";
      lines.forEach((line, row) => ctx.fillText(line, at + margin, y + 14 * row * ratio));
      y += 14 * lines.length * ratio;
      ctx.fillRect(x[0], y, x[1] - x[0], ratio);
      y += 3 * ratio;
    }
    ctx.restore();
  }

  /** Each curve is named at its end. */
  #labels(plot, narrow) {
    const { ctx } = plot;
    const ratio = devicePixelRatio;
    const { left, top, width, height } = plot.bbox;
    const ends = this.shown.curves
      .map(({ letter, surface, curve, style }) => ({
        text: narrow ? letter : title(letter, surface),
        color: style.color,
        y: plot.valToPos(curve.mu.at(-1), "y", true),
      }))
      .sort((one, other) => one.y - other.y);
    // From the top downwards none begins before the one above ends.
    const step = 15 * ratio;
    ends.forEach((end, i) => {
      end.y = Math.min(Math.max(end.y, i ? ends[i - 1].y + step : top), top + height - (ends.length - 1 - i) * step);
    });
    ctx.save();
    ctx.font = `600 ${13 * ratio}px ${FONT}`;
    ctx.textAlign = "left";
    ctx.textBaseline = "middle";
    for (const { text, color, y } of ends) {
      ctx.fillStyle = color;
      ctx.fillText(text, left + width + 6 * ratio, y);
    }
    ctx.restore();
  }

  /** The measured points, as diamonds in the colours of their curves, each on the dashed line of a constant. */
  #measured(plot) {
    const { ctx } = plot;
    const { left, top, width, height } = plot.bbox;
    const size = 7 * devicePixelRatio;
    ctx.save();
    ctx.beginPath();
    ctx.rect(left, top, width, height);
    ctx.clip();
    // Where the same point was measured on another of these, it is drawn there.
    const own = this.shown.curves.filter(({ surface }) => !surface.measured_on);
    for (const { surface, style } of own.length ? own : this.shown.curves) {
      const measured = measuredOf(surface);
      if (!measured) continue;
      const [x, y] = [plot.valToPos(measured.load, "x", true), plot.valToPos(measured.mu, "y", true)];
      // What a constant would say.
      ctx.beginPath();
      ctx.setLineDash([6 * devicePixelRatio, 4 * devicePixelRatio]);
      ctx.moveTo(left, y);
      ctx.lineTo(left + width, y);
      ctx.strokeStyle = style.color;
      ctx.lineWidth = devicePixelRatio;
      ctx.stroke();
      ctx.setLineDash([]);
      ctx.font = `${12 * devicePixelRatio}px ${FONT}`;
      ctx.textAlign = "right";
      ctx.textBaseline = "bottom";
      ctx.fillStyle = style.color;
      ctx.fillText(`constant ${measured.mu}`, left + width - 4 * devicePixelRatio, y - size);
      ctx.beginPath();
      for (const [across, up] of [[0, 1], [1, 0], [0, -1], [-1, 0]]) ctx.lineTo(x + across * size, y + up * size);
      ctx.closePath();
      ctx.fillStyle = style.color;
      ctx.strokeStyle = "#fff";
      ctx.lineWidth = 1.5 * devicePixelRatio;
      ctx.fill();
      ctx.stroke();
    }
    ctx.restore();
  }

  /** The load that is read, as a line with a point on each curve. */
  #mark(plot) {
    if (!(this.load >= plot.scales.x.min * (1 - 1e-9) && this.load <= plot.scales.x.max * (1 + 1e-9))) return;
    const { ctx } = plot;
    const ratio = devicePixelRatio;
    const x = plot.valToPos(this.load, "x", true);
    ctx.save();
    ctx.strokeStyle = INK;
    ctx.lineWidth = ratio;
    ctx.setLineDash([4 * ratio, 3 * ratio]);
    ctx.beginPath();
    ctx.moveTo(x, plot.bbox.top);
    ctx.lineTo(x, plot.bbox.top + plot.bbox.height);
    ctx.stroke();
    ctx.setLineDash([]);
    for (const { curve, style } of this.shown.curves) {
      ctx.beginPath();
      ctx.arc(x, plot.valToPos(curve.model.frictionAtLoad(this.load), "y", true), 4.5 * ratio, 0, 2 * Math.PI);
      ctx.fillStyle = "#fff";
      ctx.strokeStyle = style.color;
      ctx.lineWidth = 2 * ratio;
      ctx.fill();
      ctx.stroke();
    }
    ctx.restore();
  }

  #pointed(plot) {
    const { left } = plot.cursor;
    if (left === undefined || left < 0) return;
    const { min, max } = plot.scales.x;
    this.onPoint(Math.min(Math.max(plot.posToVal(left, "x"), min), max));
  }
}

/** A text in lines as wide as the room, or as one word. */
function wrapped(ctx, text, room) {
  const [words, lines] = [text.split(" "), []];
  const width = Math.max(room, ...words.map((word) => ctx.measureText(word).width));
  for (const word of words) {
    const longer = `${lines.at(-1)} ${word}`;
    if (lines.length && ctx.measureText(longer).width <= width) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}

const AXIS = {
  // All places that are chosen here get their label; uPlot would leave some out on a logarithmic axis.
  filter: (_, splits) => splits,
  font: `12px ${FONT}`,
  labelFont: `13px ${FONT}`,
  stroke: INK,
  grid: { stroke: "#00000018", width: 1 },
  ticks: { stroke: "#00000050", width: 1, size: 5 },
};

/** The axis of friction: from 0, or from the lowest value; of bands that of the active surface counts. */
function yScale(curves, { active, logarithmic, band }) {
  const all = curves.flatMap(({ letter, curve }) =>
    band && letter === active ? [...curve.mu, ...curve.low, ...curve.high] : curve.mu,
  );
  const highest = Math.max(...curves.flatMap(({ curve }) => curve.mu));
  const lowest = Math.min(...curves.flatMap(({ curve }) => curve.mu));
  // A band may be very wide: the curves decide how much of it is shown.
  const room = logarithmic ? 12 : 2.5;
  const top = Math.min(Math.max(...all), room * highest);
  if (!logarithmic) return { range: () => uPlot.rangeNum(0, top, { min: { pad: 0, hard: 0 }, max: { pad: 0.06 } }) };
  const foot = Math.max(Math.min(...all), lowest / room);
  return { distr: 3, range: () => [foot / 1.1, top * 1.1] };
}

/** Numbers of one digit, 1, 2 and 5 of each decade. */
function logSplits(plot) {
  const { min, max } = plot.scales.y;
  const found = [];
  for (let power = Math.floor(Math.log10(min)); 10 ** power <= max; power++)
    for (const digit of [1, 2, 5]) {
      const value = Number(`${digit}e${power}`);
      if (value >= min && value <= max) found.push(value);
    }
  return found;
}

/** What a screen reader is told of the picture. */
export const description = (curves) =>
  curves
    .map(({ letter, surface, curve }) => `${title(letter, surface)} from ${coefficient(curve.mu[0])} to ${coefficient(curve.mu.at(-1))}, strength ${strength(surface)}`)
    .join("; ");
