! The surfaces of the analysis, stated by the user: edit this file, and no other.
module asperity_surfaces
  use, intrinsic :: iso_c_binding, only: c_double
  implicit none
  private

  ! Surface files: the first property of *FRICTION is the number of one in this list. Give whole paths, since Abaqus runs in a
  ! folder of its own. Each has a nominal_area, on which its asperity_count summits lie; the mesh plays no part.
  character(*), parameter, public :: SURFACES(*) = [character(80) :: 'hosts/surface.toml', 'hosts/abaqus/smooth.toml']

  ! The units of length and force of the model, in m and N. Here mm and N, so that stresses are in MPa.
  real(c_double), parameter, public :: UNIT_OF_LENGTH = 1e-3_c_double, UNIT_OF_FORCE = 1

  ! The least and the greatest pressure that each surface is to meet, in the units of the model: where the law does not hold
  ! between them, the analysis warns at its start.
  real(c_double), parameter, public :: PRESSURES(2, size(SURFACES)) = reshape([0.01_c_double, 50.0_c_double, 0.3_c_double, &
                                                                               0.8_c_double], [2, size(SURFACES)])

  ! Near zero pressure F/p has no bound; the host multiplies by p again.
  real(c_double), parameter, public :: MOST_FRICTION = 100

end module asperity_surfaces
