// As estimate.c.
import { readFileSync } from "node:fs";
import { estimate, estimateText } from "../../js/dist/index.node.js";

const text = readFileSync(0, "utf8");
const loads = [0, 1, 100];
const digits = (number) => number.toExponential(12).replace(/e([-+])(\d)$/, "e$10$2").toUpperCase();
for (const { friction_coefficient, low, high } of estimate(text, loads).slice(1)) console.log([friction_coefficient, low, high].map(digits).join(" "));
process.stdout.write(estimateText(text, loads));
