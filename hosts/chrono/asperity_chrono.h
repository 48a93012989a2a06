// Friction from contact physics in Chrono, with contacts of either kind (NSC, SMC): each pair of bodies that has a law has its coefficient at
// the load of the pair, over all its points. Header only.
#ifndef ASPERITY_CHRONO_H
#define ASPERITY_CHRONO_H

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "asperity.h"
#include "asperity_loads.h"
#include "chrono/collision/ChCollisionModel.h"
#include "chrono/physics/ChContactContainer.h"
#include "chrono/physics/ChContactMaterialNSC.h"
#include "chrono/physics/ChContactMaterialSMC.h"
#include "chrono/physics/ChSystem.h"

class AsperityFriction : public chrono::ChContactContainer::AddContactCallback,
                         public chrono::ChContactContainer::ReportContactCallback,
                         public std::enable_shared_from_this<AsperityFriction> {
public:
    // The law of two bodies, in whichever order; null: they keep the friction of their materials, as all do before their first load is known.
    using Laws = std::function<const asperity_model *(chrono::ChContactable *, chrono::ChContactable *)>;

    // time_constant: of asperity_loads.h; most_pairs: twice as many as touch at a time.
    static std::shared_ptr<AsperityFriction> attach(chrono::ChSystem &system, Laws laws, double time_constant = 0.05, std::size_t most_pairs = 4096) {
        std::shared_ptr<AsperityFriction> made(new AsperityFriction(system, std::move(laws), time_constant, most_pairs));
        system.GetContactContainer()->RegisterAddContactCallback(made);
        return made;
    }

    // In place of system.DoStepDynamics(step).
    void step(double step) {
        next_ = system_.GetChTime() + step;
        system_.DoStepDynamics(step);
        system_.GetContactContainer()->ReportAllContacts(shared_from_this());
        asperity_pairs_end_step(pairs_.data(), pairs_.size(), system_.GetChTime(), time_constant_);
    }

    void OnAddContact(const chrono::ChCollisionInfo &contact, chrono::ChContactMaterialComposite *const material) override {
        chrono::ChContactable *a = contact.modelA->GetContactable(), *b = contact.modelB->GetContactable();
        const asperity_model *law = laws_(a, b);
        const double load = law ? asperity_pairs_expected(pairs_.data(), pairs_.size(), number(a), number(b), next_) : 0;
        if (!(load > 0)) return;
        char text[4096];
        const double mu = asperity_friction_at_load(law, load);
        if (mu != mu) {    // the load is not one that the law knows
            asperity_last_error(text, sizeof text);
            throw std::runtime_error(text);
        }
        if (auto *smooth = dynamic_cast<chrono::ChContactMaterialCompositeSMC *>(material)) smooth->mu_eff = float(mu);
        if (auto *hard = dynamic_cast<chrono::ChContactMaterialCompositeNSC *>(material))
            hard->static_friction = hard->sliding_friction = float(mu);
        if (const uint64_t warnings = asperity_told_anew(&told_[law], law, load)) {
            asperity_warnings_text(warnings, text, sizeof text);
            std::cerr << "asperity: " << text << "\n";
        }
    }

    // Of Chrono 9 and of Chrono 10, of which the compiler takes the one that there is.
    bool OnReportContact(const chrono::ChVector3d &, const chrono::ChVector3d &, const chrono::ChMatrix33<> &, const double &, const double &,
                         const chrono::ChVector3d &force, const chrono::ChVector3d &, chrono::ChContactable *a, chrono::ChContactable *b) {
        if (!asperity_pairs_add(pairs_.data(), pairs_.size(), number(a), number(b), std::max(force.x(), 0.0)))
            throw std::runtime_error("asperity: more pairs touch than most_pairs");
        return true;
    }
    bool OnReportContact(const chrono::ChVector3d &at_a, const chrono::ChVector3d &at_b, const chrono::ChMatrix33<> &plane, double distance,
                         double radius, const chrono::ChVector3d &force, const chrono::ChVector3d &torque, chrono::ChContactable *a,
                         chrono::ChContactable *b, int) {
        return OnReportContact(at_a, at_b, plane, distance, radius, force, torque, a, b);
    }

private:
    AsperityFriction(chrono::ChSystem &system, Laws laws, double time_constant, std::size_t most_pairs)
        : system_(system), laws_(std::move(laws)), time_constant_(time_constant), pairs_(most_pairs) {}

    static uint64_t number(const chrono::ChContactable *body) { return reinterpret_cast<std::uintptr_t>(body); }

    chrono::ChSystem &system_;
    Laws laws_;
    double time_constant_, next_ = 0;
    std::vector<asperity_body_pair> pairs_;
    std::map<const asperity_model *, asperity_told> told_;
};

#endif
