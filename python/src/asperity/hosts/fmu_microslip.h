/* Microslip of a unit: what resists the displacement since the last accepted step. Part of asperity_unit.h.
 *
 * The state of the contact is that of the last accepted step: the end of initialization, fmi2CompletedIntegratorStep and its
 * namesake of FMI 3.0 in model exchange, a step of co-simulation. Outputs in between are those of one straight step from there
 * to the displacement and the load that are set, so that a solver may try what it likes. */

#if MICROSLIP
/* Of the contact at a load: an output, and where they are asked for its derivatives; after may be NULL. */
static fmiStatus step_to(unit *u, double load, double *after, asperity_microslip *out)
{
    const double increment[2] = { u->state.displacement - u->state.accepted, 0 };
    asperity_status status;
    if (make_model(u) != fmiOK)
        return fmiError;
    if (asperity_microslip_length(u->model) * sizeof(double) > sizeof u->state.summits)
        return failed(u, fmiError, "the library of the unit is of another version: it remembers more of a contact");
    out->struct_size = sizeof *out;
    status = asperity_microslip_step(u->model, load, increment, u->state.summits, after, out);
    /* An open contact resists nothing: no error. */
    if (status != ASPERITY_OK && status != ASPERITY_SEPARATED)
        return refused(u, fmiDiscard);
    tell_warnings(u, load);
    return fmiOK;
}

static fmiStatus resistance(unit *u, double load, unsigned output, double *value, double *by_load, double *by_displacement)
{
    asperity_microslip out;
    const fmiStatus status = step_to(u, load, NULL, &out);
    if (status != fmiOK)
        return status;
    *value = output == TANGENTIAL_FORCE ? out.force[0] : out.stiffness[0];
    if (by_load != NULL)
        *by_load = out.dforce_dload[0];
    if (by_displacement != NULL)
        *by_displacement = out.stiffness[0];
    return fmiOK;
}

/* d(tangential stiffness)/d(load): what sticks stiffens as the whole contact does. A difference of the tangential stiffness itself
 * would see parts begin to slip, at a state in which they are about to. */
static fmiStatus stiffening(unit *u, double *value)
{
    const double load = u->state.load, step = 1e-5 * (load < 0 ? -load : load);
    double now, all;
    const fmiStatus status = resistance(u, load, TANGENTIAL_STIFFNESS, &now, NULL, NULL);
    *value = 0;
    if (status != fmiOK || !(step > 0))
        return status;
    all = asperity_tangential_stiffness_at_load(u->model, load);
    if (all > 0)
        *value = now / all * (asperity_tangential_stiffness_at_load(u->model, load + step) -
                              asperity_tangential_stiffness_at_load(u->model, load - step)) / (2 * step);
    return fmiOK;
}
#endif

/* The contact is where it is now. */
static fmiStatus accept_step(unit *u)
{
#if MICROSLIP
    asperity_microslip out;
    const fmiStatus status = step_to(u, u->state.load, u->state.summits, &out);
    if (status != fmiOK)
        return status;
    u->state.accepted = u->state.displacement;
#endif
    (void)u;
    return fmiOK;
}
