// `model asperity` of LIGGGHTS' granular pair style and walls: the whole contact, of the law that the plugin of LAMMPS has. It includes
// LIGGGHTS' headers, whose licence is the GPL.
#ifdef NORMAL_MODEL
NORMAL_MODEL(ASPERITY, asperity, 40)
#else
#ifndef NORMAL_MODEL_ASPERITY_H_
#define NORMAL_MODEL_ASPERITY_H_

#include <algorithm>
#include <iterator>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "global_properties.h"
#include "input.h"
#include "law.h"
#include "normal_model_base.h"
#include "update.h"
#include "variable.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class NormalModel<ASPERITY> : public NormalModelBase {
    typedef asperity_lammps::Law Law;

public:
    NormalModel(LAMMPS *lmp, IContactHistorySetup *setup, ContactModelBase *) : NormalModelBase(lmp, setup, nullptr) {
        for (const char *axis : {"x", "y", "z"})    // asperity_lammps::SPRING, which the other body has turned round
            history_ = std::min(history_, setup->add_history_value(std::string("spring_") + axis, "1"));
        setup->add_history_value("stiffness", "0");
    }

    // Moduli and restitution are properties as of `model hertz`; the rest is words of the plugin of LAMMPS, in a variable.
    void connectToProperties(PropertyRegistry &registry) {
        double **modulus, **shear, **restitution;
        registry.registerProperty("Yeff", &MODEL_PARAMS::createYeff, "model asperity");
        registry.registerProperty("Geff", &MODEL_PARAMS::createGeff, "model asperity");
        registry.registerProperty("coeffRest", &MODEL_PARAMS::createCoeffRest, "model asperity");
        registry.connect("Yeff", modulus, "model asperity");
        registry.connect("Geff", shear, "model asperity");
        registry.connect("coeffRest", restitution, "model asperity");
        neighbor->register_contact_dist_factor(1.01);    // so that surfacesClose is called
        types_ = atom->ntypes + 1;
        std::vector<std::shared_ptr<const Law>> laws(types_ * types_);
        for (int i = 1; i < types_; i++)
            for (int j = i; j < types_; j++) {
                const double ratio = 4 * shear[i][j] / modulus[i][j];    // Mindlin's stiffness over that of Hertz
                const Law::Words grains = {"modulus", text(modulus[i][j]), "poisson", text((2 - 2 * ratio) / (2 - ratio)),
                                           "restitution", text(restitution[i][j])};
                try {
                    Law::Words style = words("asperity");
                    style.insert(style.begin(), grains.begin(), grains.end());
                    const std::string own = "asperity_" + std::to_string(i) + "_" + std::to_string(j);
                    laws[i * types_ + j] = laws[j * types_ + i] = Law::of(update->unit_style, style, words(own), laws);
                    if (laws[i * types_ + j]->history() != 4) throw std::invalid_argument("microslip: is LAMMPS' plugin's alone");
                } catch (const std::invalid_argument &wrong) {
                    error->all(FLERR, (std::string("model asperity: ") + wrong.what()).c_str());
                }
            }
        laws_ = laws;
    }

    void surfacesIntersect(SurfacesIntersectData &s, ForceData &on_i, ForceData &on_j) {
        if (s.contact_flags) *s.contact_flags |= CONTACT_NORMAL_MODEL | CONTACT_TANGENTIAL_MODEL;
        const double dt = s.computeflag && s.shearupdate ? update->dt : 0, slip[] = {s.vtr1, s.vtr2, s.vtr3};
        asperity_lammps::Contact c;
        asperity_lammps::Forces r;
        c.history = s.contact_history + history_;
        c.radius = s.is_wall ? s.radi : s.radi * s.radj / (s.radi + s.radj);
        c.mass = s.meff;
        c.overlap = s.deltan;
        for (int a = 0; a < 3; a++) c.normal[a] = s.en[a], c.velocity[a] = s.vn * s.en[a] + slip[a];
        const Law &law = *laws_[s.itype * types_ + s.jtype];
        law.forces(1, &c, dt, &r);
        law.add(c, r, dt, s.is_wall || s.j < atom->nlocal ? 1 : 0.5, true, sums_);
        s.Fn = r.load;    // for a model of rolling friction
        s.kn = r.elastic / c.overlap;
        s.kt = r.stiffness;
        s.gamman = s.gammat = 0;
        if (s.is_wall) say();    // which has no endPass
        double twist[3];
        asperity_lammps::cross(c.normal, r.friction, twist);
        for (int a = 0; a < 3; a++) {
            const double force = r.load * c.normal[a] + r.friction[a];
            on_i.delta_F[a] += force;
            on_i.delta_torque[a] -= s.cri * twist[a];
            if (s.is_wall) continue;
            on_j.delta_F[a] -= force;
            on_j.delta_torque[a] -= s.crj * twist[a];
        }
    }

    void surfacesClose(SurfacesCloseData &s, ForceData &, ForceData &) {
        if (s.contact_flags) *s.contact_flags &= ~(CONTACT_NORMAL_MODEL | CONTACT_TANGENTIAL_MODEL);
        if (s.contact_history) std::fill_n(s.contact_history + history_, 4, 0.0);
    }

    void beginPass(SurfacesIntersectData &, ForceData &, ForceData &) { sums_.begin_step(); }

    void endPass(SurfacesIntersectData &, ForceData &, ForceData &) { say(); }

    void registerSettings(Settings &) {}
    void postSettings(IContactHistorySetup *, ContactModelBase *) {}
    double stressStrainExponent() { return 1.5; }

private:
    static std::string text(double value) {
        std::ostringstream out;
        out.precision(17);
        out << value;
        return out.str();
    }

    Law::Words words(std::string variable) const {
        if (input->variable->find(&variable[0]) < 0) return {};
        std::istringstream in(input->variable->retrieve(&variable[0]));
        return {std::istream_iterator<std::string>(in), {}};
    }

    // What is so for more than a hundredth of the load, once.
    void say() {
        const std::uint64_t all = sums_.told | (sums_.held < 0.99 * sums_.load ? sums_.warnings : 0), fresh = all & ~said_;
        said_ |= all;
        for (std::uint64_t bit = 1; bit <= fresh; bit *= 2) {
            char text[512];
            if (!(fresh & bit)) continue;
            asperity_warnings_text(bit, text, sizeof text);
            error->warning(FLERR, (std::string("model asperity: ") + text).c_str());
        }
    }

    int history_ = 1 << 20, types_ = 0;    // where the numbers of a contact are
    std::vector<std::shared_ptr<const Law>> laws_;
    asperity_lammps::Sums sums_;
    std::uint64_t said_ = 0;
};

}    // namespace ContactModels
}    // namespace LIGGGHTS

#endif
#endif
