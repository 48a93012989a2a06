// A block on an incline in Simbody: a custom force on its foot, with the law's friction at the load of the state that the integrator
// asks for. SI units.
#include <cmath>
#include <algorithm>

#include "Simbody.h"

#define HOST "simbody"
#include "../incline.h"

using namespace SimTK;

namespace {

constexpr double stiffness = 1e5, damping = 300; // of the foot, along the normal
constexpr double slip_scale = 1e-3;              // the sign of the slip rate v is tanh(v/slip_scale)

class Foot : public Force::Custom::Implementation {
public:
    Foot(const MobilizedBody &body, const asperity_model *model) : body_(body), model_(model) {}

    void calcForce(const State &state, Vector_<SpatialVec> &body_forces, Vector_<Vec3> &, Vector &) const override {
        const Vec3 position = body_.getBodyOriginLocation(state), velocity = body_.getBodyOriginVelocity(state);
        const double load = -stiffness * position[2] - damping * velocity[2];
        if (position[2] >= 0 || load <= 0) return; // adhesion would give friction at zero load, but a gap has none
        const double friction = asperity_friction_force_at_load(model_, load) * std::tanh(velocity[0] / slip_scale);
        body_.applyForceToBodyPoint(state, Vec3(0), Vec3(-friction, 0, load), body_forces);
    }

    Real calcPotentialEnergy(const State &state) const override {
        const double overlap = std::max(0.0, -body_.getBodyOriginLocation(state)[2]);
        return 0.5 * stiffness * overlap * overlap;
    }

private:
    MobilizedBody body_;
    const asperity_model *model_;
};

double slide(const asperity_model *model) {
    MultibodySystem system;
    SimbodyMatterSubsystem matter(system);
    GeneralForceSubsystem forces(system);
    Force::UniformGravity gravity(forces, matter, Vec3(downhill, 0, -normal));
    MobilizedBody::Translation block(matter.Ground(), Transform(), Body::Rigid(MassProperties(box_mass, Vec3(0), Inertia(1))), Transform());
    Force::Custom foot(forces, new Foot(block, model)); // Simbody deletes it
    State state = system.realizeTopology();
    block.setOneQ(state, 2, -box_mass * normal / stiffness);
    RungeKuttaMersonIntegrator integrator(system);
    integrator.setAccuracy(share * 1e-9);
    TimeStepper stepper(system, integrator);
    stepper.initialize(state);
    stepper.stepTo(0.1);
    const double begin = block.getOneU(stepper.getState(), 0);
    stepper.stepTo(0.6);
    return (block.getOneU(stepper.getState(), 0) - begin) / 0.5;
}

} // namespace

int main() { return judge_incline(slide, 1e-6); }
