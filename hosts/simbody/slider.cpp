// Slider in Simbody: a block that brakes on two rough pads, its friction given by the law at the load of each pad.
// Four runs (two speeds, two loads) must follow the closed form of a sliding block, a fifth the load transfer of a
// block whose mass lies above the pads. In a sixth the block is pushed too weakly to slide: it must swing by what the law's
// stick stiffness says, and not creep. All quantities in SI units.
#include "Simbody.h"
#include "../surface.h"
#include "asperity.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <memory>
#include <stdexcept>
#include <utility>

using namespace SimTK;

namespace {

constexpr double limit = 1e-6;
constexpr double mass = 1.0, gravity = 9.81;
constexpr double half_base = 0.05;               // pads at x = -half_base and +half_base of the mass centre
constexpr double stiffness = 2e6, damping = 2e3; // of one pad, along the normal
constexpr double slip_scale = 1e-3;              // the sign of the slip rate v is tanh(v/slip_scale)
constexpr double pad_area = 1e-6;

// Hard carbon on hard carbon, one pad.
asperity::Model coated_pad() {
    asperity_params params;
    asperity::check(set_surface(&params, pad_area));
    return asperity::Model(asperity::Params(params));
}

// What a pad does with its load: the law, or Coulomb's constant coefficient for the comparison of cost.
class Friction {
public:
    explicit Friction(const asperity::Model &model) : model_(&model) {}
    explicit Friction(double coefficient) : coefficient_(coefficient) {}
    double force(double load) const {
        return model_ ? model_->friction_force_at_load(load) : coefficient_ * load;
    }

private:
    const asperity::Model *model_ = nullptr;
    double coefficient_ = 0;
};

// One pad against the floor y = 0. The load is that of the state the force is asked for: nothing is lagged.
class Pad : public Force::Custom::Implementation {
public:
    Pad(const MobilizedBody &body, const Vec3 &station, const Friction &friction)
        : body_(body), station_(station), friction_(friction) {}

    void calcForce(const State &state, Vector_<SpatialVec> &body_forces, Vector_<Vec3> &, Vector &) const override {
        const Vec3 position = body_.findStationLocationInGround(state, station_);
        const Vec3 velocity = body_.findStationVelocityInGround(state, station_);
        const double load = -stiffness * position[1] - damping * velocity[1];
        if (position[1] >= 0 || load <= 0) return;
        const double friction = friction_.force(load) * std::tanh(velocity[0] / slip_scale);
        body_.applyForceToBodyPoint(state, station_, Vec3(-friction, load, 0), body_forces);
    }

    Real calcPotentialEnergy(const State &state) const override {
        const double overlap = std::max(0.0, -body_.findStationLocationInGround(state, station_)[1]);
        return 0.5 * stiffness * overlap * overlap;
    }

private:
    MobilizedBody body_;
    Vec3 station_;
    Friction friction_;
};

// A pad that holds: its tangential force is a state variable, whose rate is the stick stiffness at the load times the speed.
class HoldingPad : public Force::Custom::Implementation {
public:
    HoldingPad(const GeneralForceSubsystem &forces, const MobilizedBody &body, const Vec3 &station,
               const asperity::Model &model)
        : forces_(forces), body_(body), station_(station), model_(model) {}

    void realizeTopology(State &state) const override {
        tangential_ = state.allocateZ(forces_.getMySubsystemIndex(), Vector(1, 0.0));
    }

    void calcForce(const State &state, Vector_<SpatialVec> &body_forces, Vector_<Vec3> &, Vector &) const override {
        const double tangential = state.getZ(forces_.getMySubsystemIndex())[tangential_], load = load_of(state);
        if (std::fabs(tangential) > model_.friction_force_at_load(load))
            throw std::runtime_error("a pad that should hold slips");
        body_.applyForceToBodyPoint(state, station_, Vec3(-tangential, load, 0), body_forces);
    }

    void realizeAcceleration(const State &state) const override {
        const double speed = body_.findStationVelocityInGround(state, station_)[0];
        state.updZDot(forces_.getMySubsystemIndex())[tangential_] =
            model_.tangential_stiffness_at_load(load_of(state)) * speed;
    }

    Real calcPotentialEnergy(const State &) const override { return 0; }

private:
    double load_of(const State &state) const {
        const double height = body_.findStationLocationInGround(state, station_)[1];
        const double rate = body_.findStationVelocityInGround(state, station_)[1];
        return std::max(0.0, -stiffness * height - damping * rate);
    }

    const GeneralForceSubsystem &forces_;
    MobilizedBody body_;
    Vec3 station_;
    const asperity::Model &model_;
    mutable ZIndex tangential_; // set when the system is built
};

struct Case {
    double speed, dead_load; // at the start; pressing on the block, beside its weight
    double height;           // of the mass centre above the pads
    double push = 0;         // along the floor, on pads that hold
};

// The block on its pads; the pitch and the height at the start are those of steady sliding.
class Block {
public:
    // With a model of their own the pads hold.
    Block(const Case &c, const Friction &friction, double front_load, double rear_load,
          const asperity::Model *holding = nullptr)
        : matter_(system_), forces_(system_), gravity_(forces_, matter_, Vec3(0, -gravity, 0)),
          body_(matter_.Ground(), Transform(),
                 Body::Rigid(MassProperties(mass, Vec3(0), UnitInertia::brick(half_base, 0.02, 0.02))),
                 Transform()) {
        for (const double x : {half_base, -half_base}) {
            const Vec3 station(x, -c.height, 0);
            if (holding) Force::Custom(forces_, new HoldingPad(forces_, body_, station, *holding));
            else Force::Custom(forces_, new Pad(body_, station, friction));
        }
        Force::ConstantForce(forces_, body_, Vec3(0), Vec3(c.push, -c.dead_load, 0));
        system_.realizeTopology();
        state_ = system_.getDefaultState();
        set_start(c, front_load, rear_load);
    }

    // Advances to `time` and gives position and velocity along x. Displacements of nanometres are below the integrator's
    // accuracy and need a longest step.
    std::pair<double, double> at(double time, double longest_step = 0) {
        if (!integrator_) {
            integrator_ = std::make_unique<RungeKuttaMersonIntegrator>(system_);
            integrator_->setAccuracy(1e-9);
            if (longest_step > 0) integrator_->setMaximumStepSize(longest_step);
            stepper_ = std::make_unique<TimeStepper>(system_, *integrator_);
            stepper_->initialize(state_);
        }
        stepper_->stepTo(time);
        const State &state = stepper_->getState();
        return {body_.getOneQ(state, 1), body_.getOneU(state, 1)};
    }

private:
    // Overlaps load/stiffness under both pads fix height and pitch of the body.
    void set_start(const Case &c, double front_load, double rear_load) {
        const double pitch = std::asin((rear_load - front_load) / stiffness / (2 * half_base));
        const double mean_overlap = 0.5 * (front_load + rear_load) / stiffness;
        body_.setOneQ(state_, 0, pitch);
        body_.setOneQ(state_, 1, 0);
        body_.setOneQ(state_, 2, c.height * std::cos(pitch) - mean_overlap);
        body_.setOneU(state_, 1, c.speed);
    }

    MultibodySystem system_;
    SimbodyMatterSubsystem matter_;
    GeneralForceSubsystem forces_;
    Force::UniformGravity gravity_;
    MobilizedBody::Planar body_;
    State state_;
    std::unique_ptr<RungeKuttaMersonIntegrator> integrator_;
    std::unique_ptr<TimeStepper> stepper_;
};

// Friction force from the integrals themselves, not from the compiled law that the block uses.
double exact_force(const asperity::Model &model, double load) { return model.state_at_load(load).friction_force; }

// m dv/dt = -F tanh(v/w) has the solution sinh(v/w) = sinh(v0/w) exp(-F t/(m w)); without overflow for large v0/w.
double sliding_speed(double speed, double force, double time) {
    const double x = (speed - force * time / mass) / slip_scale;
    const double log_sinh = x + std::log1p(-std::exp(-2 * speed / slip_scale)); // log(2 sinh)
    return slip_scale * (log_sinh > 20 ? log_sinh : std::asinh(0.5 * std::exp(log_sinh)));
}

// Integral of v dt over that motion: m/F times the integral of v/tanh(v/w) dv from 0 to v0, for v0 >> w.
double stopping_distance(double speed, double force) {
    return mass / force * (0.5 * speed * speed + Pi * Pi / 12 * slip_scale * slip_scale);
}

// What the pads of a run carry: the least and the greatest load.
struct Loads {
    double least, greatest;
};

// Largest deviation of v(t) and of the stopping distance from the closed form, relative to v0 and to the distance.
double braking_error(const asperity::Model &model, const Case &c, Loads &loads) {
    const double weight = mass * gravity + c.dead_load;
    const double force = 2 * exact_force(model, weight / 2);
    loads.least = std::min(loads.least, weight / 2);
    loads.greatest = std::max(loads.greatest, weight / 2);
    const double stop = mass * c.speed / force;
    Block block(c, Friction(model), weight / 2, weight / 2);
    double speed_error = 0;
    for (int i = 1; i <= 40; ++i) {
        const double time = i * stop * 1.02 / 40;
        speed_error = worse(speed_error, std::fabs(block.at(time).second - sliding_speed(c.speed, force, time)));
    }
    const double distance = block.at(stop + 60 * slip_scale * mass / force).first;
    const double expected = stopping_distance(c.speed, force);
    const double distance_error = std::fabs(distance / expected - 1);
    std::printf("  v0 = %.1f m/s, load %6.2f N: mu = %.5f, dv = %.1e v0, stops in %.6f m (closed form %.6f, %.1e)\n",
                c.speed, weight, force / weight, speed_error / c.speed, distance, expected, distance_error);
    return worse(speed_error / c.speed, distance_error);
}

struct Transfer {
    double front, rear, force;
};

// Steady sliding with the mass centre at height h: the moments about it vanish, F = F(N1) + F(N2), N1 + N2 = W. The
// pitch, (N2 - N1)/(2 k half_base), is small, but moves the pads by more than the limit allows to forget.
Transfer load_transfer(const asperity::Model &model, double weight, double height) {
    Transfer t{weight / 2, weight / 2, 0};
    for (int i = 0; i < 60; ++i) { // contracts by |F'(N1) - F'(N2)| h/(2 half_base), far below 1
        const double front_force = exact_force(model, t.front), rear_force = exact_force(model, t.rear);
        const double pitch = std::asin((t.rear - t.front) / (2 * stiffness * half_base));
        t.force = front_force + rear_force;
        const double difference = height / half_base * (t.force - weight * std::tan(pitch)) -
                                  std::tan(pitch) * (front_force - rear_force);
        t.front = 0.5 * (weight + difference);
        t.rear = weight - t.front;
    }
    return t;
}

double transfer_error(const asperity::Model &model, const Case &c, Loads &loads) {
    const double weight = mass * gravity + c.dead_load;
    const Transfer t = load_transfer(model, weight, c.height);
    loads.least = std::min(loads.least, t.rear);
    loads.greatest = std::max(loads.greatest, t.front);
    Block block(c, Friction(model), t.front, t.rear);
    const double time = 0.5 * mass * c.speed / t.force;
    const double slowed = c.speed - block.at(time).second;
    const double error = std::fabs(slowed / (t.force / mass * time) - 1);
    const double even = 2 * exact_force(model, weight / 2);
    std::printf("  mass centre %.0f mm up: pads carry %.2f and %.2f N, F = %.5f N (even loads %.5f), slows by %.6f m/s "
                "(%.1e)\n", 1e3 * c.height, t.front, t.rear, t.force, even, slowed, error);
    return error;
}

// Pushed with a third of its friction, a block at rest moves by push/K (1 - cos(t (K/m)^(1/2))); K is that of both pads.
double holding_error(const asperity::Model &model, Loads &loads) {
    const double half = mass * gravity / 2;
    const double push = 2 * exact_force(model, half) / 3, spring = 2 * model.state_at_load(half).tangential_stiffness;
    const double angular = std::sqrt(spring / mass), period = 2 * Pi / angular;
    loads.least = std::min(loads.least, half);
    Block block({0, 0, 0, push}, Friction(model), half, half, &model);
    double error = 0;
    for (int i = 1; i <= 40; ++i) {
        const double time = i * period / 8, expected = push / spring * (1 - std::cos(angular * time));
        error = worse(error, std::fabs(block.at(time, period / 200).first - expected) / (push / spring));
    }
    std::printf("  pushed with %.3f N the block swings by %.3f nm at %.1f kHz and does not creep (%.1e)\n", push,
                2e9 * push / spring, 1e-3 / period, error);
    return error;
}

// Processor time of twenty brakings, to the same stop.
double seconds(const Case &c, const Friction &friction, double stop) {
    const double half = (mass * gravity + c.dead_load) / 2;
    const std::clock_t start = std::clock();
    for (int i = 0; i < 20; ++i) Block(c, friction, half, half).at(stop);
    return double(std::clock() - start) / CLOCKS_PER_SEC;
}

void report_cost(const asperity::Model &model, const Case &c) {
    const double weight = mass * gravity + c.dead_load;
    const double mu = 2 * exact_force(model, weight / 2) / weight;
    const double stop = c.speed / (mu * weight / mass);
    double constant = 1e9, law = 1e9;
    for (int i = 0; i < 3; ++i) {
        constant = std::min(constant, seconds(c, Friction(mu), stop));
        law = std::min(law, seconds(c, Friction(model), stop));
    }
    std::printf("simbody  cost  constant mu %.3f s; the law x %.2f\n", constant, law / constant);
}

} // namespace

int main() try {
    const auto start = std::chrono::steady_clock::now();
    const asperity::Model model = coated_pad();
    double error = 0;
    Loads loads{1e9, 0};
    for (const double speed : {0.5, 2.0})
        for (const double dead_load : {0.0, 60.0}) error = worse(error, braking_error(model, {speed, dead_load, 0}, loads));
    error = worse(error, transfer_error(model, {2.0, 0.0, 0.1}, loads));
    error = worse(error, holding_error(model, loads));
    if (!surface_holds(model.c(), loads.least, loads.greatest))
        throw std::runtime_error("the model does not hold for the surface at these loads");
    report_cost(model, {2.0, 0.0, 0});
    const bool pass = error <= limit; // false for NaN
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("simbody  %s  max error of speed, stopping distance, deceleration, swing = %.1e  (limit %.0e)  %.1f s\n",
                pass ? "PASS" : "FAIL", error, limit, wall);
    return pass ? 0 : 1;
} catch (const std::exception &error) {
    std::printf("simbody  FAIL  %s\n", error.what());
    return 1;
}
