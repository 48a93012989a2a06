! The surfaces of the analysis, stated by the user: edit this file, and no other.
!
! Abaqus hands over a contact pressure, not a force. So state asperity_count as summits per unit of nominal area: the
! law's loads, forces and areas are then per unit of nominal area, and its load is the pressure.
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
  subroutine state_surface(number, params)
    integer, intent(in) :: number
    type(asperity_params), intent(out) :: params
    call asperity_check(asperity_params_init(params))
    select case (number)
    case (1)
      call polysilicon(params)
    case (2)
      call polysilicon(params)
      params%work_of_adhesion = 0       ! the same surfaces, coated so that nothing adheres
    end select
  end subroutine state_surface

  ! The sources of these numbers are in c_examples/friction_curve.c.
  subroutine polysilicon(params)
    type(asperity_params), intent(inout) :: params
    real(c_double), parameter :: E = 160e3_c_double, NU = 0.22_c_double  ! [MPa], [-]
    call asperity_check(asperity_params_set_materials(params, E, NU, E, NU))
    params%work_of_adhesion = 6.3e-5_c_double   ! [N/mm]
    params%adhesion_range = 0.384e-6_c_double   ! [mm]
    params%burgers_vector = 0.384e-6_c_double   ! [mm]
    params%height_std = 5e-6_c_double           ! [mm]
    params%summit_radius = 1e-3_c_double        ! [mm]
    params%asperity_count = 1e7_c_double        ! [1/mm^2]: ten summits per square micrometre
    params%max_friction_coefficient = 100       ! near zero pressure F/p has no bound; the host multiplies by p again
  end subroutine polysilicon

end module asperity_surfaces
