// The declarations as a user meets them; compiled, not run.
import { AsperityError, Model, PAIRS, Status, calibrate, calibrateForce, contact, estimate, estimateText, material, momentsOfMap, paper, readText, toText, warningsText, withInterface, type Material, type Params, type Warning } from "asperity";
import { instantiate } from "asperity/instantiate";

const params: Params = { ...contact("Si", "Si"), height_std: 5e-9, summit_radius: 1e-6, asperity_count: 1e5 };
const model = new Model(params);

const one: number = model.frictionAtLoad(1e-3);
const many: Float64Array = model.frictionAtLoad([1e-3, 1e-2]);
const both: { value: Float64Array; slope: Float64Array } = model.frictionForceAndSlopeAtLoad(many);
const warnings: Warning[] = model.checkLoads(1e-4, 0.1);
const told: string = warningsText(16);
const radius: number = model.stateAtLoad(1e-3).mean_contact_radius;
const status: number = Status.SEPARATED;
const reference: string = PAIRS["Si/Si"].reference;
const steel: Material = material("steel");
// @ts-expect-error: a hardness may not be known
const hardness: number = steel.hardness;
const measured: Params = calibrate({ ...params, pressure_coefficient: 0.1, bandwidth: 4, calibration_error: 0.1 }, 1e-3, 0.3);
const kept: number | undefined = calibrateForce(paper(), 0, 3e-4).calibrated?.calibration_friction_force;
const named: Params = { ...params, calibration_load: 1e-3, calibration_friction_coefficient: 0.3, Ra: 1e-8 };
const conductance: number = model.tangentialStiffnessAtLoad(1e-3) / model.summary().stiffness_per_radius;
const written: string = toText(readText("skew = 0.1", params));
const filmed: Params = withInterface(params, "MoS2 film in dry air");
const estimated: number = estimate("pair = 'Si/Si'", 1).low + estimate("pair = 'Si/Si'", [1])[0].error_growth;
const taken: Params = readText("pair = 'Si/Si'");
const said: string = estimateText("pair = 'Si/Si'", [1]);
const moments = momentsOfMap(new Float64Array(9), 3, 1e-8);

// @ts-expect-error: a load is a number or numbers
model.frictionAtLoad("1e-3");
// @ts-expect-error: no such parameter
const unknown: Params = { heigth_std: 1 };
// @ts-expect-error: a measured point has a coefficient
calibrate(params, 1e-3);
// @ts-expect-error: no such contact law
const law: Params = { contact_law: "hertz" };
// @ts-expect-error: one number gives one number
const wrong: Float64Array = model.frictionAtLoad(1e-3);
// @ts-expect-error: no such field of a state
model.stateAtLoad(1).friction;

const other = new (await instantiate(new Uint8Array())).Model({ ...params, height_distribution: "johnson" });
other.setParams(model.params);
export { AsperityError, both, conductance, estimated, filmed, hardness, kept, law, measured, moments, named, one, radius, reference, said, status, taken, told, unknown, warnings, written, wrong };
