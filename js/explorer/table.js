// The curves as a table, shown in part and copied as a whole.
import { $, copy, element, head } from "./dom.js";
import { page } from "./state.js";
import { coefficient, count, short, title, withUnit } from "./text.js";

/** The table shows one of so many points of the curves; copied, it has all. */
const ROW_EVERY = 12;

/** The columns of the table for one surface. */
const columnsOf = ({ letter, surface }) => [
  `μ ${title(letter, surface)}`, `${letter} low`, `${letter} high`, `${letter} contacts`, `${letter} what fails`,
];

/** Some loads of the curves, with every surface: each so many points one. */
function tableRows(every) {
  const rows = [["Load [N]", ...page.shown.flatMap(columnsOf)]];
  if (!page.shown.length) return rows;
  const { loads } = page.shown[0].curve;
  for (let i = 0; i < loads.length; i += every)
    rows.push([
      loads[i],
      ...page.shown.flatMap(({ curve }) => [
        curve.mu[i], curve.low[i], curve.high[i], curve.states[i].contacting,
        page.library.warningsOf(curve.states[i].warnings).map(short).join("; "),
      ]),
    ]);
  return rows;
}

/** Shows the table. */
export function table() {
  const [names, ...rows] = tableRows(ROW_EVERY);
  const cell = (value, i) => {
    if (typeof value === "string") return element("td", { className: "words" }, value || "–");
    if (i === 0) return element("th", { scope: "row" }, withUnit(value, "N"));
    return element("td", {}, (i - 1) % 5 === 3 ? count(value) : coefficient(value));
  };
  $("table").replaceChildren(head(names), element("tbody", {}, ...rows.map((row) => element("tr", {}, ...row.map(cell)))));
}

/** Copies all of it on request. */
export const listenTable = () =>
  $("copy-table").addEventListener("click", () => copy(tableRows(1).map((row) => row.join(",")).join("\n"), "table-copied"));
