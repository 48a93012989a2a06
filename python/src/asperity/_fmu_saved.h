/* Units that are saved and brought back, in memory or as bytes. Part of the functions of FMI 2.0 and 3.0.
 *
 * A saved unit is its unit_state: parameters, inputs, mode, time, and what the contact remembers. The bytes begin with the GUID;
 * they are for the same unit on the same platform. */

enum { SAVED_BYTES = sizeof GUID + sizeof(unit_state) };

static fmiStatus save(const unit *u, void **saved)
{
    unit_state *copy = *saved != NULL ? *saved : malloc(sizeof *copy);
    if (copy == NULL)
        return failed(u, fmiError, "there is no memory to save the unit");
    *copy = u->state;
    *saved = copy;
    return fmiOK;
}

static fmiStatus bring_back(unit *u, const void *saved)
{
    const asperity_params before = u->state.params;
    if (saved == NULL)
        return failed(u, fmiError, "no saved unit is given");
    memcpy(&u->state, saved, sizeof u->state);
    /* Tables of heights are the unit's own: saved in another process they were elsewhere. */
    u->state.params.table_height = before.table_height;
    u->state.params.table_density = before.table_density;
    if (memcmp(&u->state.params, &before, sizeof before) != 0)
        u->stale = 1;
    return fmiOK;
}

static fmiStatus free_saved(void **saved)
{
    if (saved != NULL) {
        free(*saved);
        *saved = NULL;
    }
    return fmiOK;
}

static fmiStatus write_saved(const unit *u, const void *saved, unsigned char bytes[], size_t size)
{
    if (saved == NULL || size < SAVED_BYTES)
        return failed(u, fmiError, "no saved unit is given, or too little room for its bytes");
    memcpy(bytes, GUID, sizeof GUID);
    memcpy(bytes + sizeof GUID, saved, sizeof(unit_state));
    return fmiOK;
}

static fmiStatus read_saved(const unit *u, const unsigned char bytes[], size_t size, void **saved)
{
    if (size != SAVED_BYTES || memcmp(bytes, GUID, sizeof GUID) != 0)
        return failed(u, fmiError, "the bytes are not those of a saved unit of this kind");
    *saved = malloc(sizeof(unit_state));
    if (*saved == NULL)
        return failed(u, fmiError, "there is no memory to bring back the unit");
    memcpy(*saved, bytes + sizeof GUID, sizeof(unit_state));
    return fmiOK;
}
