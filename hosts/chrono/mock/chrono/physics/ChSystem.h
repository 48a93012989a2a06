// Not Chrono: what hosts/chrono/asperity_chrono.h uses of the public headers of Chrono 9 and 10, so that it can be run where Chrono is not.
// A step gives each contact the material of its container, asks the callback, and slides.
#ifndef MOCK_CHRONO_H
#define MOCK_CHRONO_H

#include <memory>
#include <vector>

namespace chrono {

struct ChVector3d {
    double values[3];
    double x() const { return values[0]; }
};
template <class Real = double>
struct ChMatrix33 {};
struct ChContactable {};
struct ChCollisionModel {
    ChContactable *contactable;
    ChContactable *GetContactable() { return contactable; }
};
struct ChCollisionInfo {
    ChCollisionModel *modelA, *modelB;
};
struct ChContactMaterialComposite {
    virtual ~ChContactMaterialComposite() {}
};
struct ChContactMaterialCompositeNSC : ChContactMaterialComposite {
    float static_friction = 0.6f, sliding_friction = 0.6f;
};
struct ChContactMaterialCompositeSMC : ChContactMaterialComposite {
    float mu_eff = 0.6f;
};

class ChContactContainer {
public:
    struct AddContactCallback {
        virtual ~AddContactCallback() {}
        virtual void OnAddContact(const ChCollisionInfo &, ChContactMaterialComposite *const) = 0;
    };
    struct ReportContactCallback {
        virtual ~ReportContactCallback() {}
        virtual bool OnReportContact(const ChVector3d &, const ChVector3d &, const ChMatrix33<> &,
#if MOCK_VERSION == 9
                                     const double &, const double &, const ChVector3d &, const ChVector3d &, ChContactable *, ChContactable *) = 0;
#else
                                     double, double, const ChVector3d &, const ChVector3d &, ChContactable *, ChContactable *, int) = 0;
#endif
    };
    struct Contact {
        ChCollisionModel *a, *b;
        double load, friction;
    };
    std::vector<Contact> contacts;
    std::shared_ptr<AddContactCallback> callback;

    void RegisterAddContactCallback(std::shared_ptr<AddContactCallback> given) { callback = given; }
    void ReportAllContacts(std::shared_ptr<ReportContactCallback> report) {
        const ChVector3d none{};
        for (const Contact &contact : contacts) {
            const ChVector3d force{{contact.load, contact.friction * contact.load, 0}};
#if MOCK_VERSION == 9
            report->OnReportContact(none, none, {}, 0, 0, force, none, contact.a->contactable, contact.b->contactable);
#else
            report->OnReportContact(none, none, {}, 0, 0, force, none, contact.a->contactable, contact.b->contactable, 0);
#endif
        }
    }
};

class ChSystem {
public:
    bool smooth = false;
    double time = 0;
    std::shared_ptr<ChContactContainer> container = std::make_shared<ChContactContainer>();

    std::shared_ptr<ChContactContainer> GetContactContainer() const { return container; }
    double GetChTime() const { return time; }
    int DoStepDynamics(double step) {
        for (auto &contact : container->contacts) {
            ChContactMaterialCompositeNSC hard;
            ChContactMaterialCompositeSMC soft;
            container->callback->OnAddContact({contact.a, contact.b}, smooth ? static_cast<ChContactMaterialComposite *>(&soft) : &hard);
            contact.friction = smooth ? soft.mu_eff : hard.static_friction == hard.sliding_friction ? hard.sliding_friction : -1;
        }
        time += step;
        return 1;
    }
};

}    // namespace chrono

#endif
