/* ABI 1: every constant, type, field and function of asperity.h. After a field stand its offset and its size [bytes] on systems of 64
 * bits, after a struct its size. `make abi` writes this file, on purpose; once a version is released only additions are allowed: fields
 * at the end of a struct, constants and functions (packaging/release.py). */

#ifndef ASPERITY_H
#define ASPERITY_H

#include <stddef.h>
#include <stdint.h>

#define ASPERITY_ABI_VERSION 1
#define ASPERITY_OK 0
#define ASPERITY_NULL_POINTER 1
#define ASPERITY_INVALID_PARAMETER 2
#define ASPERITY_INVALID_LOAD 3
#define ASPERITY_SEPARATED 4
#define ASPERITY_OUT_OF_RANGE 5
#define ASPERITY_NOT_CONVERGED 6
#define ASPERITY_INTERNAL 255
#define ASPERITY_STRENGTH_DEFAULT 0
#define ASPERITY_STRENGTH_TABLE 1
#define ASPERITY_STRENGTH_GIVEN 2
#define ASPERITY_STRENGTH_MEASURED 3
#define ASPERITY_SPECIMEN_MANY_CONTACTS 0
#define ASPERITY_SPECIMEN_ANY 1
#define ASPERITY_SPECIMEN_MEASURED 2
#define ASPERITY_HEIGHTS_GAUSSIAN 0
#define ASPERITY_HEIGHTS_WEIBULL 1
#define ASPERITY_HEIGHTS_JOHNSON 2
#define ASPERITY_HEIGHTS_TABULATED 3
#define ASPERITY_HEIGHTS_AT_SCORES 4
#define ASPERITY_CONTACT_MAUGIS 0
#define ASPERITY_CONTACT_ELASTIC_PLASTIC 1
#define ASPERITY_SLIP_PARTIAL 0
#define ASPERITY_SLIP_WHOLE 1
#define ASPERITY_WAVINESS_UNKNOWN 0
#define ASPERITY_WAVINESS_RIDGES 1
#define ASPERITY_WAVINESS_HILLS 2
#define ASPERITY_NAMES_PARAMETERS 0
#define ASPERITY_NAMES_MATERIALS 1
#define ASPERITY_NAMES_PAIRS 2
#define ASPERITY_NAMES_INTERFACES 3
#define ASPERITY_NAMES_WARNINGS 4
#define ASPERITY_NAMES_STATUSES 5
#define ASPERITY_SPREAD_MEAN 0
#define ASPERITY_SPREAD_DEVIATION 1
#define ASPERITY_SPREAD_LOW 2
#define ASPERITY_SPREAD_MEDIAN 3
#define ASPERITY_SPREAD_HIGH 4
#define ASPERITY_WARNING_PLASTIC 1
#define ASPERITY_WARNING_CROWDED 2
#define ASPERITY_WARNING_STEEP 4
#define ASPERITY_WARNING_ATOMIC 8
#define ASPERITY_WARNING_FEW 16
#define ASPERITY_WARNING_ADHESIVE 32
#define ASPERITY_WARNING_UNCALIBRATED 64
#define ASPERITY_WARNING_BROAD 128
#define ASPERITY_WARNING_STRONG 256
#define ASPERITY_WARNING_FEW_WAVES 512
#define ASPERITY_WARNING_FLAT_TOP 1024
#define ASPERITY_WARNING_NOT_GAUSSIAN 2048
#define ASPERITY_TABLE_LAYOUT 1
#define ASPERITY_TABLE_FRICTION 0
#define ASPERITY_TABLE_LOAD_AT_GAP 1
typedef struct asperity_model asperity_model;
typedef int32_t asperity_status;

typedef struct asperity_estimate {
  uint64_t struct_size; /* 0, 8 */
  double load; /* 8, 8 */
  double friction_coefficient; /* 16, 8 */
  double low; /* 24, 8 */
  double high; /* 32, 8 */
  double friction_force; /* 40, 8 */
  double friction_force_low; /* 48, 8 */
  double friction_force_high; /* 56, 8 */
  double curve_coefficient; /* 64, 8 */
  double constant_odds; /* 72, 8 */
  double contacts; /* 80, 8 */
  double another_force; /* 88, 8 */
  double another_force_low; /* 96, 8 */
  double another_force_high; /* 104, 8 */
  double strength_share; /* 112, 8 */
  double size_share; /* 120, 8 */
  double pressure_share; /* 128, 8 */
  double adhesion_share; /* 136, 8 */
  double hardness_share; /* 144, 8 */
  double slope_share; /* 152, 8 */
  double measurement_share; /* 160, 8 */
  double model_share; /* 168, 8 */
  double specimen_share; /* 176, 8 */
  double tangential_stiffness; /* 184, 8 */
  double tangential_stiffness_low; /* 192, 8 */
  double tangential_stiffness_high; /* 200, 8 */
  double normal_stiffness; /* 208, 8 */
  double normal_stiffness_low; /* 216, 8 */
  double normal_stiffness_high; /* 224, 8 */
  double contact_radius_sum; /* 232, 8 */
  double contact_radius_sum_low; /* 240, 8 */
  double contact_radius_sum_high; /* 248, 8 */
  double unloading_stiffness; /* 256, 8 */
  double unloading_stiffness_low; /* 264, 8 */
  double unloading_stiffness_high; /* 272, 8 */
  double gap; /* 280, 8 */
  double gap_low; /* 288, 8 */
  double gap_high; /* 296, 8 */
  double pull_off_force; /* 304, 8 */
  double pull_off_force_low; /* 312, 8 */
  double pull_off_force_high; /* 320, 8 */
  double error_growth; /* 328, 8 */
  uint64_t warnings; /* 336, 8 */
  int32_t strength_source; /* 344, 4 */
  int32_t is_of_pressures; /* 348, 4 */
  int32_t specimen; /* 352, 4 */
  int32_t measured_specimens; /* 356, 4 */
} asperity_estimate; /* 360 */

typedef struct asperity_params {
  uint64_t struct_size; /* 0, 8 */
  double composite_modulus; /* 8, 8 */
  double effective_shear_modulus; /* 16, 8 */
  double work_of_adhesion; /* 24, 8 */
  double adhesion_range; /* 32, 8 */
  double burgers_vector; /* 40, 8 */
  double height_std; /* 48, 8 */
  double summit_radius; /* 56, 8 */
  double asperity_count; /* 64, 8 */
  int32_t height_distribution; /* 72, 4 */
  int32_t attraction; /* 76, 4 */
  double weibull_shape; /* 80, 8 */
  double radius_amplitude; /* 88, 8 */
  double radius_rate; /* 96, 8 */
  double slip_radius_1; /* 104, 8 */
  double slip_stress_1; /* 112, 8 */
  double slip_radius_2; /* 120, 8 */
  double slip_stress_2; /* 128, 8 */
  double max_friction_coefficient; /* 136, 8 */
  double skew; /* 144, 8 */
  double kurtosis; /* 152, 8 */
  double hardness; /* 160, 8 */
  const double *table_height; /* 168, 8 */
  const double *table_density; /* 176, 8 */
  uint64_t table_length; /* 184, 8 */
  double tangential_modulus; /* 192, 8 */
  double nominal_area; /* 200, 8 */
  int32_t contact_law; /* 208, 4 */
  int32_t slip_onset; /* 212, 4 */
  double pressure_coefficient; /* 216, 8 */
  double bandwidth; /* 224, 8 */
  double calibration_load; /* 232, 8 */
  double calibration_friction_force; /* 240, 8 */
  double calibration_error; /* 248, 8 */
  double summit_mean_height; /* 256, 8 */
  double rms_slope; /* 264, 8 */
  double waviness_height; /* 272, 8 */
  double waviness_width; /* 280, 8 */
  int32_t waviness_shape; /* 288, 4 */
  int32_t taken_as_gaussian; /* 292, 4 */
  double length_unit; /* 296, 8 */
  double force_unit; /* 304, 8 */
} asperity_params; /* 312 */

typedef struct asperity_microslip {
  uint64_t struct_size; /* 0, 8 */
  double force[2]; /* 8, 16 */
  double stiffness[4]; /* 24, 32 */
  double dforce_dload[2]; /* 56, 16 */
  double dissipated; /* 72, 8 */
  double slipping; /* 80, 8 */
} asperity_microslip; /* 88 */

typedef struct asperity_state {
  uint64_t struct_size; /* 0, 8 */
  double load; /* 8, 8 */
  double gap; /* 16, 8 */
  double friction_force; /* 24, 8 */
  double friction_coefficient; /* 32, 8 */
  double dforce_dload; /* 40, 8 */
  double dmu_dload; /* 48, 8 */
  double dload_dgap; /* 56, 8 */
  double real_area; /* 64, 8 */
  double contacting; /* 72, 8 */
  double attracted; /* 80, 8 */
  double attraction_load; /* 88, 8 */
  double mean_contact_radius; /* 96, 8 */
  double max_contact_radius; /* 104, 8 */
  double fraction_below_slip_radius_1; /* 112, 8 */
  double fraction_between_slip_radii; /* 120, 8 */
  double fraction_above_slip_radius_2; /* 128, 8 */
  double fraction_in_contact; /* 136, 8 */
  double mean_asperity_pressure; /* 144, 8 */
  double plasticity_index; /* 152, 8 */
  uint64_t warnings; /* 160, 8 */
  double tangential_stiffness; /* 168, 8 */
  double fraction_elastic; /* 176, 8 */
  double fraction_flowing; /* 184, 8 */
  double contact_radius_sum; /* 192, 8 */
  double hertz_load; /* 200, 8 */
  double unloading_stiffness; /* 208, 8 */
} asperity_state; /* 216 */

typedef struct asperity_summary {
  uint64_t struct_size; /* 0, 8 */
  double alpha; /* 8, 8 */
  double beta; /* 16, 8 */
  double gamma; /* 24, 8 */
  double lambda; /* 32, 8 */
  double skew; /* 40, 8 */
  double kurtosis; /* 48, 8 */
  double pull_off_load; /* 56, 8 */
  double pull_off_friction_force; /* 64, 8 */
  double zero_load_friction_force; /* 72, 8 */
  double stiffness_per_radius; /* 80, 8 */
  double min_table_load; /* 88, 8 */
  double max_table_load; /* 96, 8 */
  double table_error; /* 104, 8 */
  double largest_load; /* 112, 8 */
} asperity_summary; /* 120 */

typedef struct asperity_specimens {
  uint64_t struct_size; /* 0, 8 */
  double load; /* 8, 8 */
  double apart; /* 16, 8 */
  double friction_force[5]; /* 24, 40 */
  double tangential_stiffness[5]; /* 64, 40 */
  double normal_stiffness[5]; /* 104, 40 */
  double gap[5]; /* 144, 40 */
  double contacts[5]; /* 184, 40 */
  double pull_off_force[5]; /* 224, 40 */
} asperity_specimens; /* 264 */

typedef struct asperity_table {
  uint64_t struct_size; /* 0, 8 */
  const double *rows; /* 8, 8 */
  uint64_t row_count; /* 16, 8 */
  uint64_t base; /* 24, 8 */
  uint32_t shift; /* 32, 4 */
  uint32_t layout_version; /* 36, 4 */
  double pull_off_load; /* 40, 8 */
  double max_friction_coefficient; /* 48, 8 */
  double inverse_cap; /* 56, 8 */
  uint64_t total_count; /* 64, 8 */
  double pull_off_force; /* 72, 8 */
  double light_slope; /* 80, 8 */
  double zero_force; /* 88, 8 */
  double zero_slope; /* 96, 8 */
  double separated_slope; /* 104, 8 */
  double heavy_force; /* 112, 8 */
} asperity_table; /* 120 */

uint32_t asperity_abi_version(void);
asperity_status asperity_check_loads(const struct asperity_model *, double, double, uint64_t *);
asperity_status asperity_create(const struct asperity_params *, struct asperity_model **);
size_t asperity_describe(int32_t, const char *, char *, size_t);
asperity_status asperity_each_specimen_at_loads(const struct asperity_model *, double, uint64_t, size_t, uint64_t, size_t, const double *, double *, double *, double *, double *, double *, double *);
asperity_status asperity_estimate_at_loads(const char *, size_t, size_t, const double *, struct asperity_estimate *);
size_t asperity_estimate_text(const char *, size_t, size_t, const double *, char *, size_t);
void asperity_free(struct asperity_model *);
double asperity_friction_and_slope_at_load(const struct asperity_model *, double, double *);
double asperity_friction_at_load(const struct asperity_model *, double);
asperity_status asperity_friction_at_loads(const struct asperity_model *, size_t, const double *, double *, double *);
double asperity_friction_force_and_slope_at_load(const struct asperity_model *, double, double *);
double asperity_friction_force_at_load(const struct asperity_model *, double);
asperity_status asperity_friction_force_at_loads(const struct asperity_model *, size_t, const double *, double *, double *);
asperity_status asperity_friction_force_at_loads_of(const struct asperity_model *const *, size_t, size_t, const uint32_t *, const double *, double *, double *);
asperity_status asperity_get_params(const struct asperity_model *, struct asperity_params *);
size_t asperity_last_error(char *, size_t);
double asperity_load_and_slope_at_gap(const struct asperity_model *, double, double *);
asperity_status asperity_loads_at_gaps(const struct asperity_model *, size_t, const double *, double *, double *);
size_t asperity_microslip_length(const struct asperity_model *);
asperity_status asperity_microslip_step(const struct asperity_model *, double, const double *, const double *, double *, struct asperity_microslip *);
asperity_status asperity_microslip_steps(const struct asperity_model *, size_t, const double *, const double *, const double *, double *, double *, double *);
asperity_status asperity_microslip_turn(double *, double, double);
const char *asperity_name(int32_t, size_t);
asperity_status asperity_params_calibrate(struct asperity_params *, double, double);
asperity_status asperity_params_calibrate_force(struct asperity_params *, double, double);
asperity_status asperity_params_get_value(const struct asperity_params *, const char *, double *);
asperity_status asperity_params_init(struct asperity_params *, size_t);
asperity_status asperity_params_read(struct asperity_params *, const char *);
asperity_status asperity_params_set_dimensionless(struct asperity_params *, double, double, double, double, double);
asperity_status asperity_params_set_materials(struct asperity_params *, double, double, double, double);
asperity_status asperity_params_set_pair(struct asperity_params *, const char *);
asperity_status asperity_params_set_spectral_moments(struct asperity_params *, double, double, double, double);
asperity_status asperity_params_set_text(struct asperity_params *, const char *, size_t);
asperity_status asperity_params_set_units(struct asperity_params *, double, double);
asperity_status asperity_params_set_values(struct asperity_params *, size_t, const char *const *, const double *);
size_t asperity_params_text(const struct asperity_params *, char *, size_t);
asperity_status asperity_set_params(struct asperity_model *, const struct asperity_params *);
asperity_status asperity_specimens_at_loads(const struct asperity_model *, size_t, uint64_t, size_t, const double *, struct asperity_specimens *);
asperity_status asperity_state_at_gap(const struct asperity_model *, double, struct asperity_state *);
asperity_status asperity_state_at_load(const struct asperity_model *, double, struct asperity_state *);
const char *asperity_status_string(asperity_status);
asperity_status asperity_summary_of(const struct asperity_model *, struct asperity_summary *);
asperity_status asperity_table_of(const struct asperity_model *, int32_t, struct asperity_table *);
asperity_status asperity_tangential_at_load(const struct asperity_model *, double, double, double *, double *);
double asperity_tangential_stiffness_at_load(const struct asperity_model *, double);
asperity_status asperity_tangential_stiffness_at_loads(const struct asperity_model *, size_t, const double *, double *);
asperity_status asperity_unloaded(const struct asperity_model *, double, struct asperity_model **);
const char *asperity_version(void);
size_t asperity_warnings_text(uint64_t, char *, size_t);

#endif
