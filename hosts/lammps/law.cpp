// Words of an input script, or of a surface file, made into the law of a contact.
#include "law.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace asperity_lammps {

namespace {

const double pi = 3.14159265358979323846;

[[noreturn]] void refuse(const std::string &message) { throw std::invalid_argument(message); }

std::string last_error() {
    char message[512];
    asperity_last_error(message, sizeof message);
    return message;
}

void demand(asperity_status status) {
    if (status != ASPERITY_OK) refuse(last_error());
}

// How many letters to insert, remove or replace to make one word of another.
std::size_t edits(const std::string &from, const std::string &to) {
    std::vector<std::size_t> row(to.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 0; i < from.size(); i++) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t k = 0; k < to.size(); k++) {
            const std::size_t replaced = diagonal + (from[i] != to[k]);
            diagonal = row[k + 1];
            row[k + 1] = std::min({replaced, diagonal + 1, row[k] + 1});
        }
    }
    return row[to.size()];
}

// The library says which of its names is nearest to one that it does not know; a word of the styles may be nearer.
void demand_known(const std::string &name) {
    asperity_params params;
    double value;
    demand(asperity_params_init(&params, sizeof params));
    if (asperity_params_get_value(&params, name.c_str(), &value) == ASPERITY_OK) return;
    std::string message = last_error();
    if (message.find(": no parameter has this name") == std::string::npos) return;    // known, and not kept
    const std::string says = "; the nearest is ";
    const std::size_t place = message.find(says), instead = message.find("; ");
    std::size_t fewest = 3;    // more letters are no slip
    if (place != std::string::npos) fewest = edits(name, message.substr(place + says.size()));
    for (const char *word : {"modulus", "real_modulus", "poisson", "restitution", "mu", "microslip", "pull_off", "surface", "shear"})
        if (const std::size_t wrong = edits(name, word); wrong < fewest && 2 * wrong < name.size()) {
            fewest = wrong;
            message = message.substr(0, instead) + says + word;
        }
    refuse(message);
}

// Roughness as it is measured, and the spectral moment of which it is the root: of an area, and of a profile.
struct Root {
    const char *name, *moment;
    double share;
};
const Root roots[] = {{"Sq", "m0", 1}, {"Rq", "m0", 1}, {"Sdq", "m2", 0.5}, {"Rdq", "m2", 1}};

double number(const std::string &name, const std::string &text) {
    char *end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0') refuse(name + ": '" + text + "' is not a number");
    return value;
}

bool contains(const std::vector<std::string> &names, const char *name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

double positive(const std::string &name, const std::string &text) {
    const double value = number(name, text);
    if (!(value > 0) || !std::isfinite(value)) refuse(name + " = " + text + ": must be positive");
    return value;
}

// The restitution of Hertz' contact with the damping force ratio * sqrt(stiffness mass) * speed, which ends where the force would
// pull. In the overlap to the power 5/4 it is that of a linear spring (Schwager and Poeschel 2007), at every speed.
double restitution_of(double ratio) {
    const double critical = std::sqrt(0.3) * ratio, off = critical * critical - 1;    // over critical damping
    if (std::abs(off) < 1e-9) return std::exp(-2);
    return std::exp(-2 * critical / std::sqrt(std::abs(off)) * (off < 0 ? std::acos(critical) : std::acosh(critical)));
}

double damping_of(double restitution) {
    if (restitution == 1) return 0;
    double low = 0, high = 2 / std::sqrt(restitution);
    for (int halving = 0; halving < 60; halving++) {
        const double middle = 0.5 * (low + high);
        (restitution_of(middle) > restitution ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

// The units of LAMMPS in which stress is force by area, in m and N.
struct Units {
    const char *name;
    double length, force;
};
const Units consistent[] = {{"si", 1, 1}, {"cgs", 1e-2, 1e-5}, {"micro", 1e-6, 1e-9}, {"nano", 1e-9, 1e-12}};

// A surface file is in SI; the grains are in the units of the script.
void read_file(asperity_params &params, const std::string &path, const std::string &units) {
    const Units *const end = std::end(consistent);
    const Units *const unit = std::find_if(consistent, end, [&](const Units &known) { return units == known.name; });
    if (unit == end) refuse("surface " + path + ": is in SI units, so 'units " + units + "' must be si, cgs, micro or nano");
    demand(asperity_params_read(&params, path.c_str()));
    if (!(params.nominal_area > 0)) refuse("surface " + path + ": nominal_area must be given: its asperities lie on this area");
    demand(asperity_params_set_units(&params, unit->length, unit->force));
}

// The cube root of a positive number, to 1e-13. A third of the upper half of the bits is within 4 %, and Halley's step cubes the error.
// Written so that compilers make vectors of it in a loop.
double cube_root(double x) {
    std::uint64_t bits;
    double y;
    std::memcpy(&bits, &x, sizeof bits);
    bits = (((bits >> 32) * 0xAAAAAAAB >> 33) + 0x2A9F7893) << 32;    // 2/3 of the exponent of 1, less what balances the error
    std::memcpy(&y, &bits, sizeof y);
    for (int step = 0; step < 2; step++) {
        const double cube = y * y * y;
        y *= (cube + 2 * x) / (2 * cube + x);
    }
    return y;
}

}    // namespace

void Law::Surface::take(const std::string &name, const std::string &text) {
    if (name == "surface") {
        if (changed) refuse("surface " + text + ": must stand before the words that change it");
        file = text;
        names.clear();
        values.clear();
    } else {
        const Root *const end = std::end(roots), *const root = std::find_if(roots, end, [&](const Root &r) { return name == r.name; });
        if (root == end) demand_known(name);
        const double value = number(name, text);
        if (root != end && !(value >= 0)) refuse(name + " = " + text + ": must not be negative");
        names.push_back(root == end ? name : root->moment);
        values.push_back(root == end ? value : value * value * root->share);
        changed = true;
    }
    given = true;
}

std::shared_ptr<const Law> Law::of(const std::string &units, const Words &style, const Words &own,
                                   const std::vector<std::shared_ptr<const Law>> &known) {
    Law law;
    law.read(units, style, own);
    return law.made(known);
}

std::shared_ptr<const Law> Law::of_made(const std::string &made_of, const std::vector<std::shared_ptr<const Law>> &known) {
    double numbers[NUMBERS];
    if (made_of.size() < sizeof numbers) refuse("the restart file does not have its law");
    std::memcpy(numbers, made_of.data(), sizeof numbers);
    Law law;
    law.made_of_ = made_of;
    law.mu_ = numbers[0];
    law.modulus_ = numbers[1];
    law.tangential_ratio_ = numbers[2];
    law.damping_ = numbers[3];
    law.softening_ = numbers[4];
    law.area_ = numbers[5];
    law.microslip_ = numbers[6] != 0;
    law.pull_off_ = numbers[7] != 0;
    demand(asperity_params_init(&law.params_, sizeof law.params_));
    if (law.mu_ < 0)
        demand(asperity_params_set_text(&law.params_, made_of.data() + sizeof numbers, std::strlen(made_of.c_str() + sizeof numbers)));
    return law.made(known);
}

std::shared_ptr<const Law> Law::made(const std::vector<std::shared_ptr<const Law>> &known) {
    for (const auto &other : known)
        if (other && other->made_of_ == made_of_) return other;
    if (mu_ < 0) make_model();
    return std::make_shared<const Law>(std::move(*this));
}

void Law::read(const std::string &units, const Words &style, const Words &own) {
    double real_modulus = -1, poisson = 0.3, restitution = 1;
    Surface surface;
    for (const Words *command : {&style, &own}) {
        double mu = -1;
        surface.given = surface.changed = false;
        for (std::size_t i = 0; i < command->size(); i += 2) {
            const std::string &name = (*command)[i];
            if (i + 1 == command->size()) refuse(name + ": its value is missing");
            const std::string &text = (*command)[i + 1];
            if (name == "modulus") modulus_ = positive(name, text);
            else if (name == "real_modulus") real_modulus = positive(name, text);
            else if (name == "poisson") poisson = number(name, text);
            else if (name == "restitution") restitution = positive(name, text);
            else if (name == "mu") {
                mu = number(name, text);
                if (!(mu >= 0) || !std::isfinite(mu)) refuse("mu = " + text + ": must be 0 or more");
            } else if (name == "microslip" || name == "pull_off") {
                if (text != "yes" && text != "no") refuse(name + ": must be yes or no");
                (name == "microslip" ? microslip_ : pull_off_) = text == "yes";
            } else surface.take(name, text);
        }
        // What a later command says of friction replaces what an earlier one said.
        if (mu >= 0 && surface.given) refuse("mu: stands in place of a surface");
        if (mu >= 0) surface = Surface();
        if (mu >= 0 && !contains(*command, "microslip")) microslip_ = false;
        if (mu >= 0 && !contains(*command, "pull_off")) pull_off_ = false;
        if (mu >= 0 || surface.given) mu_ = mu;
    }
    if (modulus_ < 0) refuse("modulus: must be set, E* that the grains are computed with");
    if (real_modulus < 0) real_modulus = modulus_;
    if (real_modulus < modulus_) refuse("real_modulus: must not be below modulus; grains are made softer, not harder");
    if (!(poisson > -1 && poisson <= 0.5)) refuse("poisson: must be above -1, at most 0.5");
    if (!(restitution <= 1)) refuse("restitution: must be above 0, at most 1");
    tangential_ratio_ = 2 * (1 - poisson) / (2 - poisson);
    damping_ = damping_of(restitution);
    softening_ = std::pow(modulus_ / real_modulus, 2.0 / 3);
    area_ = pi * std::pow(0.75 / real_modulus, 2.0 / 3);
    if (microslip_ && mu_ >= 0) refuse("microslip: needs a surface, not mu");
    if (pull_off_ && mu_ >= 0) refuse("pull_off: needs a surface, not mu");
    const double numbers[NUMBERS] = {mu_, modulus_, tangential_ratio_, damping_, softening_, area_, double(microslip_), double(pull_off_)};
    made_of_.assign(reinterpret_cast<const char *>(numbers), sizeof numbers);
    if (mu_ < 0) read_surface(surface, units);
}

void Law::read_surface(const Surface &surface, const std::string &units) {
    std::vector<const char *> names;
    for (const std::string &name : surface.names) names.push_back(name.c_str());
    demand(asperity_params_init(&params_, sizeof params_));
    if (surface.file.empty()) params_.nominal_area = 1;
    else read_file(params_, surface.file, units);
    demand(asperity_params_set_values(&params_, names.size(), names.data(), surface.values.data()));
    const bool has_area = !surface.file.empty() || contains(surface.names, "nominal_area");
    if (params_.calibration_friction_force > 0 && !has_area)
        refuse("nominal_area: must be given with calibration_load, which was measured on this area");
    if (params_.nominal_area > 0)
        for (double *total : {&params_.asperity_count, &params_.calibration_load, &params_.calibration_friction_force})
            *total /= params_.nominal_area;
    params_.nominal_area = 1;
    std::string text(asperity_params_text(&params_, nullptr, 0) + 1, '\0');
    if (asperity_params_text(&params_, &text[0], text.size()) == 0) refuse(last_error());
    made_of_ += text;
}

void Law::make_model() {
    asperity_model *model = nullptr;
    demand(asperity_create(&params_, &model));
    model_.reset(model, asperity_free);
    if (pull_off_) {
        if (!(params_.work_of_adhesion > 0)) refuse("pull_off: needs a surface with a work_of_adhesion above 0");
        beads();
    }
    find_where_it_holds(params_.composite_modulus);
    rough_area_ = 1.5 * pi * params_.height_std / 0.92;    // docs/start.md; summits vary by 0.92 of the surface's heights
    if (params_.rms_slope > 0) {
        const double side = fewest_waves * 2 * pi * params_.height_std / params_.rms_slope;
        least_area_ = side * side;
    }
    const std::size_t remembered = asperity_microslip_length(model);
    if (microslip_ && remembered > MOST_REMEMBERED)
        refuse("microslip: this library keeps " + std::to_string(remembered) + " numbers of a contact, the plugin " +
               std::to_string(+MOST_REMEMBERED) + " at most");
    remembered_ = static_cast<int>(remembered);
}

// Warnings and number of contacts against pressure, from a billionth of E*, at which hardly a summit touches, to E* itself. An
// interval has the warnings of its two ends.
void Law::find_where_it_holds(double composite_modulus) {
    first_interval_ = half_binade(1e-9 * composite_modulus);
    for (std::int64_t k = first_interval_; k <= half_binade(composite_modulus) + 1; k++) {
        asperity_state state;
        state.struct_size = sizeof state;
        // A pressure that cannot be evaluated is one at which all summits are flat.
        const bool flat = asperity_state_at_load(model_.get(), pressure_of(k), &state) != ASPERITY_OK;
        const std::uint64_t all = flat ? ASPERITY_WARNING_CROWDED : state.warnings;
        // These are of the interface and the surface, at whatever load: finish() says them once.
        const std::uint64_t told = all & (ASPERITY_WARNING_UNCALIBRATED | ASPERITY_WARNING_BROAD);
        // Few of a unit of area: contacts are smaller, and have the friction of single ones.
        const std::uint64_t warnings = all & ~(told | ASPERITY_WARNING_FEW | ASPERITY_WARNING_FEW_WAVES);
        if (!intervals_.empty()) intervals_.back().warnings |= warnings, intervals_.back().told |= told;
        intervals_.push_back({flat ? 0 : state.contacting, warnings, told});
    }
    intervals_.pop_back();
}

// Linear between the intervals, and below them, as without adhesion.
double Law::touching(double pressure) const {
    const std::int64_t last = std::int64_t(intervals_.size()) - 1;
    const std::int64_t k = std::clamp<std::int64_t>(half_binade(pressure) - first_interval_, 0, last);
    const double first = pressure_of(first_interval_ + k), touch = intervals_[k].touching;
    if (pressure < first) return touch * pressure / first;
    if (k == last) return touch;
    return touch + (intervals_[k + 1].touching - touch) * (pressure / first - 1) / (pressure_of(first_interval_ + k + 1) / first - 1);
}

const Beads &Law::beads() const {
    if (!beads_) beads_ = std::make_shared<const Beads>(params_, pull_off_);
    return *beads_;
}

void Law::forces(int count, const Contact *contact, double dt, Forces *result) const {
    for (int k = 0; k < count; k++) normal(contact[k], result[k]);
    Bodies bodies;
    if (model_) {
        limits(count, contact, bodies, result);
    } else {
        for (int k = 0; k < count; k++) result[k].limit = mu_ * result[k].load, result[k].pressure = 0;
    }
    if (microslip_) microslip(count, contact, dt, bodies, result);
    for (int k = 0; k < count; k++) {
        if (!microslip_) spring(contact[k], dt, result[k]);
        damp(contact[k], dt, result[k]);
    }
}

// Also the stick stiffness of smooth grains, after Mindlin.
void Law::normal(const Contact &c, Forces &r) const {
    const double stiffness = 2 * modulus_ * std::sqrt(c.radius * c.overlap);
    r.elastic = 2.0 / 3 * stiffness * c.overlap;
    r.approach = -dot(c.velocity, c.normal);
    r.load = r.elastic + damping_ * std::sqrt(stiffness * c.mass) * r.approach;
    if (!(r.load > 0)) r.load = 0;
    r.pull = pull_off_ ? beads().pull_off(c.radius) : 0;
    r.load -= r.pull;
    r.summits = r.scatter = 0;
    r.stiffness = tangential_ratio_ * stiffness;
}

// The greatest friction, and the stick stiffness of summits and grains one behind the other.
void Law::limits(int count, const Contact *contact, Bodies &bodies, Forces *r) const {
    double pressure[BATCH] = {}, limit[BATCH], summits[BATCH], *area = bodies.area;
    // Summits that stick rub under no load, and under a pull as under none.
    const double least = params_.work_of_adhesion > 0 ? pressure_of(first_interval_) : 0;
    for (int k = 0; k < count; k++) {
        const double radius = contact[k].radius, moment = (r[k].load + r[k].pull) * radius;
        const double root = cube_root(moment > 1e-200 ? moment : 1e-200);
        area[k] = area_ * root * root + rough_area_ * radius;
        pressure[k] = std::max(r[k].load / area[k], least);
    }
    // They fail for a load that is not finite only, and then give NaN, as the positions of the grains are.
    asperity_friction_force_at_loads(model_.get(), count, pressure, limit, nullptr);
    asperity_tangential_stiffness_at_loads(model_.get(), count, pressure, summits);
    for (int k = 0; k < count; k++) {
        r[k].summits = touching(pressure[k]) * area[k];
        r[k].pressure = pressure[k];
        bodies.softening[k] = softening_;
        if (r[k].summits > 0 && r[k].summits < Beads::MANY) {    // the mean of single contacts, as if the area were larger or smaller
            const Single single = beads().single(r[k].summits, params_.asperity_count * area[k]);
            r[k].scatter = single.scatter;
            area[k] *= single.friction;
            bodies.softening[k] *= single.stiffness / single.friction;
        }
        const double bulk = r[k].stiffness, both = bodies.softening[k] * area[k] * summits[k];
        r[k].limit = area[k] * limit[k];
        r[k].stiffness = bulk * both / (bulk + both);
        bodies.grain[k] = bulk;
        bodies.summits[k] = both;
    }
}

void Law::spring(const Contact &c, double dt, Forces &r) const {
    double *history = c.history;
    double slip[3], *spring = r.spring;
    for (int a = 0; a < 3; a++) slip[a] = c.velocity[a] + r.approach * c.normal[a];
    const double off = dot(history, c.normal);    // the tangent plane has turned
    // A contact that is unloaded loses the stiffness of the part that opens, and the force of that part: nothing else
    // keeps the spring from giving back more than was put in. One that is loaded gains stiffness without force.
    const double had = std::abs(history[STIFFNESS]), kept = r.stiffness < had ? r.stiffness / had : 1;
    for (int a = 0; a < 3; a++)
        spring[a] = kept * (history[a] - off * c.normal[a]) - r.stiffness * dt * slip[a];
    const double size = dot(spring, spring);
    const bool beyond = size > r.limit * r.limit;
    r.slips = beyond || slipped_before(history, dt);
    if (beyond) {
        const double scale = r.limit / std::sqrt(size);
        for (int a = 0; a < 3; a++) spring[a] *= scale;
    }
    r.friction_work = 0;
    for (int a = 0; a < 3; a++) r.friction_work -= 0.5 * (history[a] + spring[a]) * slip[a] * dt;
    if (dt > 0) {
        for (int a = 0; a < 3; a++) history[a] = spring[a];
        history[STIFFNESS] = r.slips ? -r.stiffness : r.stiffness;
    }
}

// The spring of a contact that sticks is damped as the normal one is; the whole stays below the limit.
void Law::damp(const Contact &c, double dt, Forces &r) const {
    for (int a = 0; a < 3; a++) r.friction[a] = r.spring[a];
    if (r.slips || damping_ == 0) return;
    double slip[3];
    for (int a = 0; a < 3; a++) slip[a] = c.velocity[a] + r.approach * c.normal[a];
    const double viscous = damping_ * std::sqrt(r.stiffness * c.mass);
    for (int a = 0; a < 3; a++) r.friction[a] -= viscous * slip[a];
    const double size = dot(r.friction, r.friction);
    if (size > r.limit * r.limit) {
        const double scale = r.limit / std::sqrt(size);
        for (int a = 0; a < 3; a++) r.friction[a] *= scale;
    }
    for (int a = 0; a < 3; a++) r.friction_work -= (r.friction[a] - r.spring[a]) * slip[a] * dt;
}

}    // namespace asperity_lammps
