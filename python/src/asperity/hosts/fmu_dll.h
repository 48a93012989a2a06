/* Windows looks for asperity.dll in the folder of the program, not in that of the unit, and takes one of that name that another
 * unit has loaded. So the unit loads the one beside itself, by its path. Calls below this file go through pointers. */
#include <windows.h>

#define FUNCTIONS(F)                                                                                                   \
    F(asperity_params_init)                                                                                            \
    F(asperity_params_set_text)                                                                                        \
    F(asperity_params_get_value)                                                                                       \
    F(asperity_params_set_values)                                                                                      \
    F(asperity_create)                                                                                                 \
    F(asperity_set_params)                                                                                             \
    F(asperity_state_at_load)                                                                                          \
    F(asperity_warnings_text)                                                                                          \
    F(asperity_friction_at_loads)                                                                                      \
    F(asperity_friction_force_at_loads)                                                                                \
    F(asperity_microslip_length)                                                                                       \
    F(asperity_microslip_step)                                                                                         \
    F(asperity_tangential_stiffness_at_load)                                                                           \
    F(asperity_last_error)                                                                                             \
    F(asperity_free)

#define POINTER(name) static __typeof__(&name) dll_##name;
FUNCTIONS(POINTER)

/* 1 if the library is there. Whoever comes second finds the same addresses: units of several threads may be made at once. */
static int load_asperity(void)
{
    static const wchar_t file[] = L"asperity.dll";
    enum { LONGEST = 32768 }; /* of paths in Windows */
    wchar_t *path = malloc(LONGEST * sizeof *path), *name;
    HMODULE self, library = NULL;
    if (path != NULL &&
        GetModuleHandleExW(GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT,
                           (LPCWSTR)(void *)load_asperity, &self)) {
        DWORD length = GetModuleFileNameW(self, path, LONGEST - (DWORD)(sizeof file / sizeof *file));
        path[length] = 0;
        name = wcsrchr(path, L'\\');
        if (name != NULL) {
            wcscpy(name + 1, file);
            library = LoadLibraryW(path);
        }
    }
    free(path);
    if (library == NULL)
        return 0;
    __typeof__(&asperity_abi_version) abi_version = (void *)GetProcAddress(library, "asperity_abi_version");
    if (abi_version == NULL || abi_version() != ASPERITY_ABI_VERSION)
        return 0;
#define FIND(name)                                                                                                     \
    if ((dll_##name = (void *)GetProcAddress(library, #name)) == NULL)                                                 \
        return 0;
    FUNCTIONS(FIND)
    return 1;
}

#define asperity_params_init dll_asperity_params_init
#define asperity_params_set_text dll_asperity_params_set_text
#define asperity_params_get_value dll_asperity_params_get_value
#define asperity_params_set_values dll_asperity_params_set_values
#define asperity_create dll_asperity_create
#define asperity_set_params dll_asperity_set_params
#define asperity_state_at_load dll_asperity_state_at_load
#define asperity_warnings_text dll_asperity_warnings_text
#define asperity_friction_at_loads dll_asperity_friction_at_loads
#define asperity_friction_force_at_loads dll_asperity_friction_force_at_loads
#define asperity_microslip_length dll_asperity_microslip_length
#define asperity_microslip_step dll_asperity_microslip_step
#define asperity_tangential_stiffness_at_load dll_asperity_tangential_stiffness_at_load
#define asperity_last_error dll_asperity_last_error
#define asperity_free dll_asperity_free
