// What `plugin load` calls: names the styles of this plugin to LAMMPS.
#include "fix_asperity_history.h"
#include "fix_wall_asperity_hertz.h"
#include "lammps.h"
#include "pair_asperity_hertz.h"

using namespace LAMMPS_NS;

namespace {

// What LAMMPS expects of a plugin, after its documentation ("Writing plugins"); lammpsplugin.h is not installed with it.
struct Plugin {
    const char *version, *style, *name, *info, *author;
    union {
        void *(*of_instance)(void *);
        void *(*of_words)(void *, int, char **);
    } creator;
    void *handle;
};
using Register = void (*)(Plugin *, void *);

void *new_pair(void *lammps) { return new PairAsperityHertz(static_cast<LAMMPS *>(lammps)); }

template <class AnyFix> void *new_fix(void *lammps, int narg, char **arg) {
    return new AnyFix(static_cast<LAMMPS *>(lammps), narg, arg);
}

}    // namespace

extern "C" __attribute__((visibility("default"))) void lammpsplugin_init(void *lammps, void *handle, void *function) {
    const auto announce = reinterpret_cast<Register>(function);
    // LAMMPS_BUILT_FOR is the version whose headers this was compiled with; LAMMPS says so if it is another one.
    Plugin plugin = {LAMMPS_BUILT_FOR, "pair", PairAsperityHertz::style, "asperity: friction of rough grains",
                     "the asperity project", {}, handle};
    plugin.creator.of_instance = new_pair;
    announce(&plugin, lammps);
    plugin.style = "fix";
    plugin.name = FixWallAsperityHertz::style_name;
    plugin.info = "asperity: friction of rough grains at walls";
    plugin.creator.of_words = new_fix<FixWallAsperityHertz>;
    announce(&plugin, lammps);
    plugin.name = FixAsperityHistory::style_name;
    plugin.info = "asperity: what contacts remember";
    plugin.creator.of_words = new_fix<FixAsperityHistory>;
    announce(&plugin, lammps);
}
