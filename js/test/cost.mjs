// What calls for one load cost, and for many by load [ns]: the least of some runs, since others use the processor too.
//
// usage: node test/cost.mjs      prints JSON
import { Model, contact } from "asperity";

const model = new Model({ ...contact("Si", "Si"), height_std: 5e-9, summit_radius: 1e-6, asperity_count: 1e5 });
const loads = Float64Array.from({ length: 20000 }, (_, i) => 1e-3 * (1 + i / 20000));
let sum = 0;

/** @param {() => void} run through all loads */
function cost(run) {
  let least = Infinity;
  for (let i = 0; i < 50; i++) {
    const begin = performance.now();
    run();
    least = Math.min(least, performance.now() - begin);
  }
  return (1e6 * least) / loads.length;
}

const found = {
  one: cost(() => loads.forEach((load) => (sum += model.frictionForceAtLoad(load)))),
  one_with_slope: cost(() => loads.forEach((load) => (sum += model.frictionForceAndSlopeAtLoad(load).slope))),
  many: cost(() => (sum += model.frictionForceAtLoad(loads)[0])),
  many_with_slope: cost(() => (sum += model.frictionForceAndSlopeAtLoad(loads).slope[0])),
};
if (!Number.isFinite(sum)) throw new Error("no forces");
console.log(JSON.stringify(found));
