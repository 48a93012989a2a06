/* The part of Adams's slv_c_utils.h that a contact friction subroutine sees. Adams has the whole of it: build against that. */
#ifndef SOLVER_C_UTILS_H
#define SOLVER_C_UTILS_H

struct sAdamsContact {
    int ID, nIGEOM, nJGEOM;
    int *IGEOM, *JGEOM, *IFLIP_GEOM, *JFLIP_GEOM;
};

struct sAdamsContactFriction {
    struct sAdamsContact contact;
    int NPAR;
    const double *PAR;
};

typedef void adams_c_Cffsub(const struct sAdamsContactFriction *contact, double time, const double *loci,
                            const double *locj, const double *x, const double *xdot, double nforce, double area,
                            int dflag, int iflag, double *values);

void c_errmes(int errflg, const char *mesage, int id, const char *endflg);

void c_gtstrg(int id, char *string, int *nchars, int *istat);

#endif
