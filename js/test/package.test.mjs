// The package in Node: every number is the native library's, bit for bit, and so is every message.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { AsperityError, INTERFACES, MATERIALS, Model, PAIRS, Status, calibrate, calibrateForce, contact, estimate, estimateText, interfaceOf, material, memorySize, mccoolSummits, pair, paper, readEstimate, readText, toText, version, warningsOf, warningsText, withElasticPlastic, withInterface } from "asperity";
import { CONSTANTS } from "../dist/header.js";
import { answers, bits, contactOf, entries, entryOf, mccoolOf, warningLoads, warningsText as nativeText } from "./native.mjs";

const silicon = { ...contact("Si", "Si"), height_std: 5e-9, summit_radius: 1e-6, asperity_count: 1e5, nominal_area: 1e-8 };
const surfaces = {
  silicon,
  "a pair with a measured slip stress": { ...contact("mica", "Au"), m0: 4e-18, m2: 0.002, m4: 8e12, nominal_area: 1e-9 },
  "Weibull heights": { ...silicon, skew: -0.4 },
  "Johnson heights": { ...silicon, skew: 0.3, kurtosis: 3.5 },
  "radii that grow with height": { ...silicon, radius_amplitude: 0.5, radius_rate: 1 },
  "no adhesion": { ...silicon, work_of_adhesion: 0, attraction: 0 },
  "strong adhesion": { ...silicon, work_of_adhesion: 2, adhesion_range: 2e-10 },
  "summits that yield": { ...contact("steel", "steel"), contact_law: 1, work_of_adhesion: 0, height_std: 2e-7,
    summit_radius: 2e-5, asperity_count: 1e4, nominal_area: 1e-6 },
  "a strength that grows with pressure": { ...silicon, pressure_coefficient: 0.1 },
  "one measured point": { ...silicon, pressure_coefficient: 0.02, calibration_load: 1e-3, calibration_friction_coefficient: 0.2 },
};
/** The bits of all warnings. */
const KNOWN = Object.entries(CONSTANTS).flatMap(([name, bit]) => (name.startsWith("WARNING_") ? [bit] : []));
const loads = Array.from({ length: 25 }, (_, i) => 1e-7 * 10 ** (i / 3));

for (const [name, params] of Object.entries(surfaces)) {
  test(`the load at a gap is that of the exact state: ${name}`, () => {
    const model = new Model(params);
    const { gap, dload_dgap: slope } = model.stateAtLoad(1e-3);
    const found = model.loadAndSlopeAtGap(gap);
    assert.ok(Math.abs(found.value / 1e-3 - 1) < 1e-8 && Math.abs(found.slope / slope - 1) < 1e-6);
    assert.equal(model.loadAtGap(gap), found.value);
    assert.deepEqual([...model.loadAtGap([1, gap])], [0, found.value]);
    assert.throws(() => model.loadAtGap([gap, NaN]), /element 1: gap = NaN/);
  });

  test(`answers have the bits of the native library: ${name}`, () => {
    const native = answers(params, loads);
    assert.ok(native.loads, native.refused);
    const model = new Model(params);
    const friction = model.frictionAndSlopeAtLoad(loads);
    const force = model.frictionForceAndSlopeAtLoad(loads);
    const stiffness = model.tangentialStiffnessAtLoad(loads);
    const radii = model.contactRadiusSumAndSlopeAtLoad(loads);
    loads.forEach((load, i) => {
      const numbers = [friction.value[i], friction.slope[i], force.value[i], force.slope[i], stiffness[i], radii.value[i], radii.slope[i]];
      const { warnings, ...state } = model.stateAtLoad(load);
      const ours = [...numbers, ...Object.values(state), ...Object.values(model.sensitivitiesAtLoad(load))].map(bits);
      ours.splice(numbers.length + Object.keys(model.stateAtLoad(load)).indexOf("warnings"), 0, BigInt(warnings));
      assert.deepEqual(ours, native.loads[i], `at ${load} N`);
    });
    const warnings = model.checkLoads(loads[0], loads.at(-1)).reduce((sum, { bit }) => sum + bit, 0);
    assert.equal(BigInt(warnings), native.warnings);
    const between = KNOWN.map((bit) => (model.warningLoads(bit) ?? [NaN, NaN]).map(bits));
    assert.deepEqual(between, warningLoads(params, KNOWN));
    model.free();
  });
}

test("parameters that the library refuses are refused in its words", () => {
  const bad = [
    { ...silicon, height_std: -1 },
    { ...silicon, heigth_std: 1 },
    { ...silicon, summit_radius: NaN },
    { ...silicon, skew: 0, kurtosis: 1 },
    { ...silicon, work_of_adhesion: 63 },
    { ...silicon, contact_law: 1 },
    { ...silicon, slip_radius_1: 0.5 },
    { ...silicon, nominal_area: 1e-2 },
    { ...silicon, calibration_error: 5 },
    { ...silicon, m0: 1e-18 },
    contact("Si", "Si"),
  ];
  for (const params of bad) {
    const { refused } = answers(params, [1]);
    assert.ok(refused, JSON.stringify(params));
    assert.throws(() => new Model(params), { name: "AsperityError", message: refused });
  }
});

test("loads that the library refuses are refused in its words, in arrays by their index", () => {
  const model = new Model(silicon);
  const [heavy] = answers(silicon, [1e300]).loads;
  assert.throws(() => model.frictionAtLoad(1e300), { message: heavy.refused, status: Status.OUT_OF_RANGE });
  const many = new Float64Array(5000).fill(1e-3);
  many[4321] = NaN;
  const message = "element 4321: load = NaN: must be finite";
  assert.throws(() => model.frictionForceAtLoad(many), { message, status: Status.INVALID_LOAD });
  many[4321] = -1; // below pull-off: open, and no error
  assert.equal(model.frictionForceAtLoad(many)[4321], 0);
  assert.throws(() => model.stateAtLoad(-1), { status: Status.SEPARATED });
  assert.throws(() => model.frictionAtLoad(/** @type {any} */ ("1")), TypeError);
});

test("an array gives what its loads give one by one, however long it is", () => {
  const model = new Model(silicon);
  const many = Float64Array.from({ length: 5001 }, (_, i) => -1e-7 + 1e-9 * i ** 2);
  const found = model.frictionForceAtLoad(many);
  many.forEach((load, i) => assert.equal(found[i], model.frictionForceAtLoad(load)));
  assert.equal(model.frictionAtLoad([]).length, 0);
});

test("warnings come with what to do about them", () => {
  const [few, ...others] = new Model(silicon).checkLoads(1e-5, 0.1);
  assert.equal(few.name, "FEW");
  assert.match(few.text, /^fewer than 20 summits touch, .* use heavier loads or a larger area/);
  assert.deepEqual(others.map(({ name }) => name), ["UNCALIBRATED", "BROAD"]);
  assert.deepEqual(warningsOf(CONSTANTS.WARNING_STEEP | CONSTANTS.WARNING_FEW).map(({ name }) => name), ["STEEP", "FEW"]);
});

test("a warning holds between two loads, or at none", () => {
  const model = new Model(silicon);
  const [lightest, heaviest] = model.warningLoads(CONSTANTS.WARNING_FEW) ?? [];
  assert.ok(lightest > 0 && heaviest > lightest);
  const names = (load) => warningsOf(model.stateAtLoad(load).warnings).map(({ name }) => name);
  assert.ok(names(0.999 * heaviest).includes("FEW") && !names(1.001 * heaviest).includes("FEW"));
  assert.equal(new Model({ ...silicon, hardness: 0 }).warningLoads(CONSTANTS.WARNING_PLASTIC), null);
  const [{ refused }] = warningLoads(silicon, [3]);
  assert.throws(() => model.warningLoads(3), { name: "AsperityError", message: refused, status: Status.INVALID_PARAMETER });
  for (const wrong of ["FEW", 1.5, -1]) assert.throws(() => model.warningLoads(/** @type {any} */ (wrong)), TypeError);
});

test("several warnings are told in the library's words, a line each", () => {
  for (const bits of [0, CONSTANTS.WARNING_FEW, KNOWN.reduce((sum, bit) => sum + bit), 2 ** 40])
    assert.equal(warningsText(bits), nativeText(bits));
  assert.equal(warningsText(0), "no warning");
  assert.equal(warningsText(CONSTANTS.WARNING_STEEP + CONSTANTS.WARNING_FEW).split("\n").length, 2);
  assert.throws(() => warningsText(/** @type {any} */ ("FEW")), TypeError);
});

test("summits per area stand for their number", () => {
  const { asperity_count, ...others } = silicon;
  assert.equal(new Model({ ...others, summit_density: 1e13 }).params.asperity_count, asperity_count);
  assert.throws(() => new Model({ ...others, nominal_area: 0, summit_density: 1e13 }), /nominal_area: must be set/);
  assert.throws(() => new Model({ ...silicon, summit_density: 1e13 }), /must not be given together with asperity_count/);
});

test("words stand for heights and contact laws, and parameters come back", () => {
  const model = new Model({ ...silicon, attraction: false, height_distribution: "weibull", weibull_shape: 4 });
  const { params } = model;
  assert.equal(params.height_distribution, "weibull");
  assert.equal(params.contact_law, "maugis");
  assert.equal(params.attraction, false);
  const copy = new Model(params);
  assert.equal(copy.frictionAtLoad(1e-3), model.frictionAtLoad(1e-3));
  assert.throws(() => new Model({ ...silicon, contact_law: /** @type {any} */ ("hertz") }), /"maugis", "elastic-plastic"/);
  assert.throws(() => model.setParams({ ...silicon, height_std: -1 }), AsperityError);
  assert.equal(copy.frictionAtLoad(1e-3), model.frictionAtLoad(1e-3));
  model.setParams(silicon);
  assert.equal(bits(model.frictionAtLoad(1e-3)), answers(silicon, [1e-3]).loads[0][0]);
});

test("a table of heights is read, and handed back", () => {
  const height = Float64Array.from({ length: 31 }, (_, i) => (i - 15) / 3);
  const density = height.map((z) => Math.exp((-z * z) / 2));
  const model = new Model({ ...silicon, table_height: height, table_density: density });
  // Straight lines between the points of a Gaussian density.
  assert.ok(Math.abs(model.frictionAtLoad(0.1) / new Model(silicon).frictionAtLoad(0.1) - 1) < 0.05);
  assert.equal(model.params.height_distribution, "tabulated");
  assert.deepEqual(model.params.table_density, density);
  assert.throws(() => new Model({ ...silicon, table_height: [1, 2], table_density: [1] }), /table_density: 1 numbers for 2/);
  const long = Array.from({ length: 3000 }, (_, i) => i);
  assert.throws(() => new Model({ ...silicon, table_height: long, table_density: long }), /table_length/);
});

test("a measured point is met, changes the slip stresses alone, and is kept", () => {
  const [load, mu] = [2e-3, 0.15];
  for (const params of [silicon, { ...silicon, pressure_coefficient: 0.1 }, surfaces["summits that yield"]]) {
    const made = calibrate(params, load, mu);
    const model = new Model(made);
    assert.ok(Math.abs(model.frictionAtLoad(load) / mu - 1) < 1e-8);
    const { slip_stress_1, slip_stress_2, calibrated, ...others } = made;
    assert.deepEqual(others, (({ slip_stress_1: one, ...rest }) => rest)(params));
    assert.deepEqual(calibrated, { calibration_load: load, calibration_friction_force: mu * load });
    const before = new Model(params).params;
    assert.ok(Math.abs(slip_stress_1 / before.slip_stress_1 / (slip_stress_2 / before.slip_stress_2) - 1) < 1e-12);
    assert.deepEqual(calibrateForce(params, load, mu * load), made);
    for (const measured of [{ calibration_friction_coefficient: mu }, { calibration_friction_force: mu * load }])
      assert.deepEqual(new Model({ ...params, calibration_load: load, ...measured }).params, model.params);
    // Another point in its place, not on top of it.
    const other = { calibration_load: 1, calibration_friction_coefficient: 1 };
    assert.deepEqual(calibrate({ ...params, ...other }, load, mu), made);
  }
  // With adhesion there is friction at no load.
  const sticky = surfaces["strong adhesion"];
  const force = new Model(sticky).frictionForceAtLoad(0) / 3;
  assert.ok(Math.abs(new Model(calibrateForce(sticky, 0, force)).frictionForceAtLoad(0) / force - 1) < 1e-8);
});

test("a measurement that is kept goes with the surfaces, and does not calibrate others again", () => {
  const model = new Model({ ...calibrate(silicon, 1e-3, 0.2), calibration_error: 0.1 });
  const { params } = model;
  assert.deepEqual(params.calibrated, { calibration_load: 1e-3, calibration_friction_force: 2e-4 });
  assert.equal(params.calibration_error, 0.1);
  assert.equal(new Model(silicon).params.calibrated, undefined);
  assert.equal(new Model(silicon).params.calibration_error, 0.05);
  assert.deepEqual(new Model(params).params, params);
  const rougher = new Model({ ...params, height_std: 2 * params.height_std });
  assert.equal(rougher.params.slip_stress_1, params.slip_stress_1);
  assert.deepEqual(rougher.params.calibrated, params.calibrated);
  assert.notEqual(rougher.frictionAtLoad(1e-3), model.frictionAtLoad(1e-3));
  const again = new Model({ ...params, calibration_load: 2e-3, calibration_friction_coefficient: 0.3 });
  assert.ok(Math.abs(again.frictionAtLoad(2e-3) / 0.3 - 1) < 1e-8);
  assert.equal(again.params.calibrated.calibration_load, 2e-3);
  assert.equal(withInterface({ ...contact("steel", "steel"), ...params }, "MoS2 film in dry air").calibrated, undefined);
  assert.throws(() => new Model({ ...silicon, calibrated: /** @type {any} */ ({ calibration_load: 1 }) }), TypeError);
});

test("the strength counts as the default until something of it is given", () => {
  const names = (params) => new Model(params).checkLoads(1e-4, 1e-2).map(({ name }) => name);
  const one = { ...silicon, asperity_count: 1, nominal_area: 0 };
  for (const params of [silicon, one, { ...silicon, slip_radius_1: 30 }]) assert.ok(names(params).includes("UNCALIBRATED"));
  const given = { slip_stress_1: 0.01 };
  for (const params of [calibrate(one, 1e-3, 0.2), { ...silicon, ...given }, { ...silicon, pressure_coefficient: 0.1 }])
    assert.ok(!names(params).includes("UNCALIBRATED"));
  // Measured is measured, also where the default was right.
  const { friction_force } = new Model(silicon).stateAtLoad(1e-3);
  assert.ok(!names(calibrateForce(silicon, 1e-3, friction_force)).includes("UNCALIBRATED"));
});

test("the paper's case has its groups", () => {
  const { alpha, beta, gamma, lambda } = new Model(paper()).summary();
  for (const [found, wanted] of [[alpha, 0.01], [beta, 1000], [gamma, 0.001]]) assert.ok(Math.abs(found / wanted - 1) < 1e-14);
  assert.ok(lambda > 0);
  assert.equal(new Model({ ...paper(), skew: -0.4 }).params.height_distribution, "weibull");
});

const STEEL = `\ufeffpair = "steel/steel"\r
contact_law = "elastic-plastic"
work_of_adhesion = 0
slip_onset = "whole"
nominal_area = 1e-4
calibration_load = 1000
calibration_friction_coefficient = 0.16
[roughness]
Ra = [0.8e-6, 0.4e-6]
RSm = [80e-6, 60e-6]
`;

test("a text in TOML is a surface", () => {
  const params = readText(STEEL);
  assert.equal(params.contact_law, "elastic-plastic");
  assert.equal(params.slip_onset, "whole");
  assert.equal(params.calibrated.calibration_load, 1000);
  assert.ok(Math.abs(new Model(params).frictionAtLoad(1000) / 0.16 - 1) < 1e-8);
  // What the text does not give is left out, or is that of others.
  assert.ok(!("height_std" in readText("pair = 'steel/steel'")));
  assert.equal(readText("height_std = 1e-9", silicon).summit_radius, silicon.summit_radius);
});

test("a text alone has friction with its band", () => {
  const text = `pair = "steel/steel"\nnominal_area = 1e-4\nmeasured = [1000, 0.16]\n[roughness]\nprocess = "ground"\nRa = 0.8e-6\n`;
  const one = estimate(text, 10);
  assert.ok(Math.abs(one.friction_coefficient - 0.194) < 5e-4 && one.low > 0.16 && one.high < 0.23);
  assert.equal(one.strength_source, "measured");
  assert.ok(Math.abs(one.friction_force / (10 * one.friction_coefficient) - 1) < 1e-15);
  const many = estimate(text, Float64Array.from({ length: 3000 }, (_, i) => 1 + i));
  assert.equal(many.length, 3000);
  assert.ok(Math.abs(many[9].low / one.low - 1) < 1e-6 && many[2999].load === 3000);
  assert.match(estimateText(text, [10]), /^mu\(10 N\) = 0\.194, 95 % band 0\.167 to 0\.221\nrests on: /);
  assert.ok(one.contacts > 20 && one.specimen_scatter < 0.1 && one.is_of_pressures === false);
  const pressure = estimate(text.replace("nominal_area = 1e-4", ""), 1e7);
  assert.ok(pressure.is_of_pressures && Number.isNaN(pressure.contacts));
  const params = readEstimate(text);
  assert.ok(params.contact_law === "elastic-plastic" && Math.abs(new Model(params).frictionAtLoad(10) / one.friction_coefficient - 1) < 3e-8);
  assert.deepEqual(readText(toText(params)), params);
  assert.throws(() => readEstimate("mu = 1"), { status: Status.INVALID_PARAMETER, message: /^line 1: mu: no such key/ });
  assert.deepEqual(estimate(text, []), []);
  assert.throws(() => estimate(text, NaN), { status: Status.INVALID_LOAD, message: /element 0: load = NaN/ });
  for (const load of [undefined, null, "10", {}])
    assert.throws(() => estimate(text, load), { name: "TypeError", message: /^load = .*: must be a number or an array of numbers$/ });
  assert.throws(() => contact("Si/Si", "Si"), { message: "Si/Si: no material has this name; it is a pair: give each body by its own name" });
  assert.throws(() => estimate("measured = 0.16", 1), { status: Status.INVALID_PARAMETER, message: /^line 1: measured = 0\.16/ });
  assert.throws(() => estimateText("", 1), AsperityError);
  assert.throws(() => estimate(/** @type {any} */ (undefined), 1), TypeError);
});

test("surfaces come back from their text, bit for bit", () => {
  const height = Float64Array.from({ length: 256 }, (_, i) => i + Math.sin(i) / 3);
  const table = { table_height: height, table_density: height.map((z) => Math.exp(-(((z - 128) / 30) ** 2))) };
  const others = { paper: paper(), "a text": readText(STEEL), "a long table": { ...silicon, ...table } };
  for (const [name, params] of Object.entries({ ...surfaces, ...others })) {
    const { params: whole } = new Model(params);
    assert.deepEqual(readText(toText(whole)), whole, name);
  }
});

test("a text that is wrong is refused with the line and the key", () => {
  const status = Status.INVALID_PARAMETER;
  assert.throws(() => readText(STEEL.replace("whole", "hole")), { status, message: /^line 4: slip_onset = "hole": must be "partial" or "whole"/ });
  assert.throws(() => readText(STEEL.replace("Ra", "Rz")), { status, message: /^line 9: \[roughness\] Rz: no such key; a height from peak to valley/ });
  assert.throws(() => readText(STEEL.replace("steel/steel", "steal/steel")), { status, message: /^line 1: .*steel\/steel/ });
  assert.throws(() => readText("#".repeat(2 ** 20 + 1)), { status, message: /1048576|1 MiB/ });
  assert.ok(readText("#".repeat(2 ** 20)));
  assert.throws(() => readText(/** @type {any} */ (undefined)), TypeError);
});

test("summits that yield do not adhere", () => {
  const made = withElasticPlastic(silicon, 11e9);
  assert.deepEqual(made, { ...silicon, contact_law: "elastic-plastic", hardness: 11e9, work_of_adhesion: 0 });
  assert.ok(new Model(made).frictionAtLoad(1e-3) > 0);
  assert.throws(() => withElasticPlastic(silicon, 0), { status: Status.INVALID_PARAMETER, message: /^hardness = 0/ });
});

test("a measured point is that of the table of heights that is given with it", () => {
  const height = [-2, -1, 0, 1, 2];
  const params = { ...silicon, table_height: height, table_density: [0, 1, 2, 1, 0] };
  const named = new Model({ ...params, calibration_load: 1e-3, calibration_friction_coefficient: 0.2 });
  assert.ok(Math.abs(named.frictionAtLoad(1e-3) / 0.2 - 1) < 2e-9);
  assert.equal(new Model(calibrate(params, 1e-3, 0.2)).frictionAtLoad(1e-2), named.frictionAtLoad(1e-2));
});

test("measured points that no strength gives are refused with the numbers", () => {
  const status = Status.INVALID_PARAMETER;
  const slippery = { ...silicon, pressure_coefficient: 0.5 };
  assert.throws(() => calibrate(slippery, 1e-3, 0.1), { status, message: /0\.0001|1e-4/ });
  assert.throws(() => calibrate(silicon, NaN, 0.1), { status: Status.INVALID_LOAD });
  assert.throws(() => calibrate(silicon, 0, 0.1), { status, message: /^calibration_load = 0: .* calibrate with the friction force$/ });
  assert.throws(() => calibrate(silicon, 1e-3, 21), { status, message: /^calibration_friction_coefficient = 21: .*is it a force\?/ });
  assert.throws(() => calibrateForce(silicon, 1e-3, 0), { status, message: /^friction_force = 0/ });
  assert.throws(() => calibrate(silicon, 1e-3, /** @type {any} */ (undefined)), TypeError);
  assert.throws(() => new Model({ ...silicon, calibration_load: 1e-3 }), /^AsperityError: calibration_load: must be given together/);
});

test("without adhesion a pressure coefficient adds itself to friction", () => {
  const params = { ...silicon, work_of_adhesion: 0, attraction: false };
  const [plain, pressed] = [new Model(params), new Model({ ...params, pressure_coefficient: 0.1 })];
  for (const load of [1e-5, 1e-3, 1e-1]) {
    assert.ok(Math.abs(pressed.frictionAtLoad(load) / (plain.frictionAtLoad(load) + 0.1) - 1) < 1e-9);
    assert.ok(Math.abs(pressed.stateAtLoad(load).hertz_load / load - 1) < 1e-9);
    const { pressure_coefficient } = plain.sensitivitiesAtLoad(load);
    assert.ok(Math.abs(pressure_coefficient * plain.frictionAtLoad(load) - 1) < 1e-8);
  }
  const amontons = new Model({ ...params, pressure_coefficient: 0.1, slip_stress_1: 0, slip_stress_2: 0 });
  assert.ok(Math.abs(amontons.frictionAtLoad(1e-3) / 0.1 - 1) < 1e-9);
});

test("the tangential force starts with the stiffness and ends at the friction force", () => {
  const model = new Model(silicon);
  const start = model.tangentialAtLoad(1e-3, 1e-15);
  assert.ok(Math.abs(start.stiffness / model.tangentialStiffnessAtLoad(1e-3) - 1) < 1e-6);
  assert.ok(Math.abs(model.tangentialAtLoad(1e-3, 1e-3).force / model.frictionForceAtLoad(1e-3) - 1) < 1e-9);
});

test("the sum of contact radii is that of the exact state", () => {
  const model = new Model(silicon);
  assert.ok(Math.abs(model.contactRadiusSumAtLoad(1e-3) / model.stateAtLoad(1e-3).contact_radius_sum - 1) < 1e-8);
});

test("a model that was freed says so, and can be freed again", () => {
  const model = new Model(silicon);
  model.free();
  model.free();
  assert.throws(() => model.frictionAtLoad(1), { message: "model: has been freed; make another" });
});

test("memory does not grow when models are freed, or are no longer reachable", () => {
  const make = () => new Model(silicon);
  for (let i = 0; i < 10; i++) make().free();
  const before = memorySize();
  for (let i = 0; i < 30; i++) make().free();
  assert.equal(memorySize(), before);

  const script = `
    import { Model, contact, memorySize } from "asperity";
    const params = { ...contact("Si", "Si"), height_std: 5e-9, summit_radius: 1e-6, asperity_count: 1e5 };
    const batch = async () => { for (let i = 0; i < 20; i++) new Model(params); gc(); await new Promise((done) => setTimeout(done, 1)); };
    for (let i = 0; i < 2; i++) await batch();
    const before = memorySize();
    for (let i = 0; i < 3; i++) await batch();
    console.log(memorySize() - before);`;
  const words = ["--expose-gc", "--input-type=module", "-e", script];
  const grown = Number(execFileSync(process.execPath, words, { encoding: "utf8", cwd: new URL("..", import.meta.url) }));
  // 60 models of some 50 kB each would take 3 MB.
  assert.ok(grown < 1e6, `${grown} bytes more`);
});

test("the package has the version of the library", () => {
  const { version: ofPackage } = JSON.parse(readFileSync(new URL("../package.json", import.meta.url), "utf8"));
  assert.equal(version, ofPackage);
  assert.equal(CONSTANTS.VERSION, ofPackage);
});

test("constants of a model are read from its struct", () => {
  const summary = new Model(silicon).summary();
  assert.equal(summary.skew, 0);
  assert.equal(summary.kurtosis, 3);
  assert.ok(summary.pull_off_load < 0 && summary.table_error < 1e-8);
});

/** The numbers of a material, pair or interface in the order of C's struct; what is not known is 0 there. */
const inOrder = ({ name, first, second, conditions, source, reference, ...numbers }) =>
  Object.entries(numbers).flatMap(([key, value]) => (key.endsWith("_range") ? value ?? [0, 0] : [value ?? 0])).map(bits);

test("materials, pairs and interfaces are those of the native library", () => {
  for (const [what, ours] of Object.entries({ materials: MATERIALS, pairs: PAIRS, interfaces: INTERFACES })) {
    const native = entries(what);
    assert.ok(native.length > 20, what);
    assert.deepEqual(Object.keys(ours), native.map(({ name }) => name));
    for (const { name, reference, numbers } of native) {
      assert.equal(ours[name].name, name);
      assert.equal(ours[name].reference, reference);
      assert.deepEqual(inOrder(ours[name]), numbers, name);
    }
  }
});

test("what no source is known for is null", () => {
  assert.equal(material("PDMS").burgers_vector, null);
  assert.equal(material("mica").hardness, null);
  assert.equal(material("Al").young_range, null);
  assert.equal(pair("Si/Si3N4").work_of_adhesion_range, null);
  assert.equal(pair("Si/Si").slip_stress_1, null);
});

test("unknown names are refused in the library's words, with the nearest", () => {
  const status = Status.INVALID_PARAMETER;
  for (const name of ["steal", "", "x".repeat(200), "Žlezo"])
    assert.throws(() => material(name), { name: "AsperityError", message: entryOf("material", name).refused, status });
  assert.throws(() => pair("steel/steal"), { message: entryOf("pair", "steel/steal").refused, status });
  assert.throws(() => contact("Si", "steal"), /steel/);
  assert.throws(() => contact("SiC", "WC"), { message: "work_of_adhesion: none is known for SiC/WC: give that of your surfaces, 0 for none", status });
  assert.equal(contact("SiC", "WC", { work_of_adhesion: 0.05 }).burgers_vector, material("SiC").burgers_vector);
  assert.throws(() => material(/** @type {any} */ (1)), TypeError);
});

test("an interface by its name sets its strength, or tells the friction coefficient that is known", () => {
  const summits = { height_std: 5e-9, summit_radius: 1e-6, asperity_count: 1e5 };
  const film = interfaceOf("MoS2 film in dry air");
  assert.equal(film.source, "read");
  assert.match(film.conditions, /dry air/);
  const measured = withInterface({ ...contact("steel", "steel"), ...summits, work_of_adhesion: 0 }, film.name);
  const model = new Model(measured);
  const state = model.stateAtLoad(1e-3);
  const expected = film.shear_strength * state.real_area + film.pressure_coefficient * 1e-3;
  assert.ok(Math.abs(state.friction_force / expected - 1) < 1e-12);
  assert.ok(!warningsOf(state.warnings).some(({ name }) => name === "UNCALIBRATED"));
  model.free();
  const status = Status.INVALID_PARAMETER;
  assert.throws(() => interfaceOf("MoS2"), { message: entryOf("interface", "MoS2").refused, status });
  assert.throws(() => withInterface(measured, "steel/steel dry"), /only a friction coefficient of 0.57 at 12 N/);
  assert.throws(() => withInterface(summits, film.name), /effective_shear_modulus = NaN: must be in Pa/);
  assert.throws(() => withInterface(measured, /** @type {any} */ (1)), TypeError);
});

test("a contact has the parameters of the native library's pair, in either order", () => {
  const summits = { height_std: 5e-9, summit_radius: 1e-6, asperity_count: 1e5 };
  for (const { name, first, second } of Object.values(PAIRS)) {
    assert.deepEqual(pair(`${second}/${first}`), PAIRS[name]);
    const native = contactOf(name, ...Object.values(summits));
    if (native.refused) {
      assert.match(native.refused, /adhesion_range: must be set/);
      assert.throws(() => contact(first, second), /^AsperityError: burgers_vector: none is known of a body of PDMS\/PDMS: give one$/);
      assert.equal(contact(first, second, { burgers_vector: 1e-8 }).adhesion_range, 1e-8);
      continue;
    }
    const model = new Model({ ...contact(first, second), ...summits });
    for (const [key, value] of Object.entries(native)) assert.equal(bits(model.params[key]), value, `${name}: ${key}`);
    model.free();
  }
});

test("summits of McCool are those of the native library, and moments need no m4", () => {
  const moments = { m0: 25e-18, m2: 0.0032, m4: 0.72e12 };
  const made = mccoolSummits(moments, 1e-8);
  const native = mccoolOf(...Object.values(moments), 1e-8);
  for (const [key, value] of Object.entries(made)) assert.equal(bits(value), native[key], key);
  assert.equal(Object.keys(made).length, 9);
  const law = new Model({ ...contact("Si", "Si"), ...made });
  assert.ok(law.frictionAtLoad(1e-3) > 0);
  const { m4, ...two } = moments;
  const { params } = new Model({ ...contact("Si", "Si"), ...two, nominal_area: 1e-8 });
  assert.ok(params.radius_amplitude < 0 && params.bandwidth === 0 && params.rms_slope === 0.08);
  const known = new Model({ ...contact("Si", "Si"), ...two, bandwidth: (m4 * moments.m0) / moments.m2 ** 2, nominal_area: 1e-8 }).params;
  const same = new Model({ ...contact("Si", "Si"), ...moments, nominal_area: 1e-8 }).params;
  assert.ok(Math.abs(known.summit_radius / same.summit_radius - 1) < 1e-14 && known.bandwidth === 0);
  const narrow = { ...moments, m4: 0.5e12 };
  assert.throws(() => mccoolSummits(narrow, 1e-8), { message: mccoolOf(...Object.values(narrow), 1e-8).refused });
  assert.throws(() => mccoolSummits(moments, NaN), { message: mccoolOf(...Object.values(moments), NaN).refused });
});
