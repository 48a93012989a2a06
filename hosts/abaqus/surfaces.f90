! The surfaces of the analysis, stated by the user: edit this file, and no other.
!
! Abaqus hands over a contact pressure, not a force. So each surface states a nominal area too, that of the piece of
! surface on which asperity_count summits were counted. Only summits per area matter; the mesh plays no part.
!
! Units are those of the Abaqus model. Here mm, N, MPa: a work of adhesion of 1 J/m^2 is 1e-3 N/mm.
module asperity_surfaces
  use, intrinsic :: iso_c_binding, only: c_double
  use asperity, only: asperity_check, asperity_params, asperity_params_init, asperity_params_set_materials
  implicit none
  private

  integer, parameter, public :: NUMBER_OF_SURFACES = 2
  public :: state_surface

contains

  ! The first property of *FRICTION is `number`.
  subroutine state_surface(number, params, nominal_area)
    integer, intent(in) :: number
    type(asperity_params), intent(out) :: params
    real(c_double), intent(out) :: nominal_area  ! [length^2]
    call asperity_check(asperity_params_init(params))
    select case (number)
    case (1)
      call polysilicon(params, nominal_area)
    case (2)
      call polysilicon(params, nominal_area)
      params%work_of_adhesion = 0       ! the same surfaces, coated so that nothing adheres
    end select
  end subroutine state_surface

  ! The sources of these numbers are in c_examples/friction_curve.c.
  subroutine polysilicon(params, nominal_area)
    type(asperity_params), intent(inout) :: params
    real(c_double), intent(out) :: nominal_area
    real(c_double), parameter :: E = 160e3_c_double, NU = 0.22_c_double  ! [MPa], [-]
    call asperity_check(asperity_params_set_materials(params, E, NU, E, NU))
    params%work_of_adhesion = 6.3e-5_c_double   ! [N/mm]
    params%adhesion_range = 0.384e-6_c_double   ! [mm]
    params%burgers_vector = 0.384e-6_c_double   ! [mm]
    params%height_std = 5e-6_c_double           ! [mm]
    params%summit_radius = 1e-3_c_double        ! [mm]
    nominal_area = 0.01_c_double                ! [mm^2]: 100 um by 100 um
    params%asperity_count = 1e5_c_double        ! on it: ten summits per square micrometre
    params%max_friction_coefficient = 100       ! near zero pressure F/p has no bound; the host multiplies by p again
  end subroutine polysilicon

end module asperity_surfaces
