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

/* Bytes may be damaged or forged. The library checks numbers and choices when it makes a model; it believes lengths, and the
 * functions of FMI believe the mode. */
static int fits(const unit *u, const unit_state *found)
{
    const int mode = found->mode, running = u->exchange ? EVENT | CONTINUOUS_TIME : STEP;
    return found->params.struct_size == u->state.params.struct_size &&
           found->params.table_length == u->state.params.table_length && mode > 0 && (mode & (mode - 1)) == 0 &&
           (mode & (INSTANTIATED | INITIALIZATION | running | TERMINATED));
}

static fmiStatus read_saved(const unit *u, const unsigned char bytes[], size_t size, void **saved)
{
    unit_state found;
    if (size != SAVED_BYTES || memcmp(bytes, GUID, sizeof GUID) != 0)
        return failed(u, fmiError, "the bytes are not those of a saved unit of this kind");
    memcpy(&found, bytes + sizeof GUID, sizeof found);
    if (!fits(u, &found))
        return failed(u, fmiError, "the bytes of the saved unit are damaged: a length or the mode in them is none of this unit");
    *saved = malloc(sizeof found);
    if (*saved == NULL)
        return failed(u, fmiError, "there is no memory to bring back the unit");
    memcpy(*saved, &found, sizeof found);
    return fmiOK;
}
