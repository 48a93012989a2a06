! The surfaces of the analysis, stated by the user: edit this file, and no other.
!
! Abaqus hands over a contact pressure, not a force. So each surface states a nominal area too, that of the piece of
! surface on which asperity_count summits were counted. Only summits per area matter; the mesh plays no part.
!
! Units are those of the Abaqus model. Here mm, N, MPa: a work of adhesion of 1 J/m^2 is 1e-3 N/mm.
module asperity_surfaces
  use, intrinsic :: iso_c_binding, only: c_double
  use asperity, only: asperity_check, asperity_params, asperity_params_init, asperity_params_set_materials, &
    asperity_params_set_spectral_moments
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
    call asperity_check(asperity_params_init(params))  ! what is forgotten below stops the analysis, by name
    select case (number)
    case (1)
      call hard_carbon(params, nominal_area)
    case (2)
      call hard_carbon(params, nominal_area)
      params%height_std = 0.6e-6_c_double  ! [mm]: the same, but so smooth that it adheres without load
    end select
  end subroutine state_surface

  ! Hard carbon on hard carbon, ta-C: docs/hosts-reference.md has the sources of these numbers.
  subroutine hard_carbon(params, nominal_area)
    type(asperity_params), intent(inout) :: params
    real(c_double), intent(out) :: nominal_area
    real(c_double), parameter :: E = 493e3_c_double, NU = 0.25_c_double  ! [MPa], [-]
    real(c_double), parameter :: M0 = 9.8e-6_c_double**2                 ! variance of the heights [mm^2]
    real(c_double), parameter :: M2 = 0.06_c_double**2 / 2               ! of the slopes of profiles [-]
    real(c_double), parameter :: M4 = 10 * M2**2 / M0                    ! of their curvatures [1/mm^2]
    nominal_area = 1                            ! [mm^2]: six million summits
    call asperity_check(asperity_params_set_materials(params, E, NU, E, NU))
    call asperity_check(asperity_params_set_spectral_moments(params, M0, M2, M4, nominal_area))
    params%work_of_adhesion = 6e-5_c_double     ! [N/mm]
    params%adhesion_range = 0.25e-6_c_double    ! [mm]
    params%burgers_vector = 0.25e-6_c_double    ! [mm]
    params%hardness = 51e3_c_double             ! [MPa]
    params%max_friction_coefficient = 100       ! near zero pressure F/p has no bound; the host multiplies by p again
  end subroutine hard_carbon

end module asperity_surfaces
