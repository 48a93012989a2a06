// Adds `model asperity` to a LIGGGHTS that starts with this library: LD_PRELOAD=libasperity_liggghts.so liggghts -in grains.in
#include "fix_insert_stream.h"    // which a header of the next one lacks
#include "granular_styles.h"

namespace {

using namespace LIGGGHTS;
using namespace LIGGGHTS::ContactModels;

template <class Base, class Made, class Parent>
Base *make(LAMMPS *lmp, Parent *parent, int64_t hash) {
    return new Made(lmp, parent, hash);
}

template <int ROLLING>
void add() {
    typedef GranStyle<ASPERITY, TANGENTIAL_OFF, COHESION_OFF, ROLLING, SURFACE_DEFAULT> Style;
    typedef ContactModel<Style> Model;
    const int64_t hash = Style::HASHCODE;    // addStyle takes a reference
    PairStyles::Factory::instance().addStyle("gran", hash, make<PairStyles::IGranularPairStyle, PairStyles::Granular<Model>, PairGran>);
    Walls::Factory::instance().addStyle("gran", hash, make<Walls::IGranularWall, Walls::Granular<Model>, FixWallGran>);
}

const bool added = [] {
    ContactModels::Factory::instance().addNormalModel("asperity", ASPERITY);
    add<ROLLING_OFF>();
    add<ROLLING_CDT>();
    add<ROLLING_EPSD2>();
    return true;
}();

}    // namespace
