!> The units of lengths that files are written in: what each is called, and what other programs
!> call it.
module export_units
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: unit_type, find_unit

    !> A unit of length.
    type :: unit_type
        character(6) :: name = ''           !! as drawings have it
        character(2) :: short = ''          !! behind a number
        real(dp) :: inch = 1.0_dp           !! how many of them an inch has
        integer :: dxf = 0                  !! of DXF's $INSUNITS
        logical :: is_metric = .false.      !! millimetres or metres
    end type unit_type

    !> The units there are. The inch has 25.4 mm exactly (ISO 31-1:1992, annex A).
    type(unit_type), parameter :: units(4) = [ &
        unit_type('INCHES', 'IN', 1.0_dp, 1, .false.), &
        unit_type('FEET', 'FT', 1.0_dp/12.0_dp, 2, .false.), &
        unit_type('MM', 'MM', 25.4_dp, 4, .true.), &
        unit_type('M', 'M', 0.0254_dp, 6, .true.)]

contains

    !> Finds a unit by its name. Fails with `cause%usage` where there is none of this name.
    pure subroutine find_unit(name, unit, error)
        character(*), intent(in) :: name                    !! INCHES, FEET, MM or M
        type(unit_type), intent(out) :: unit                !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: which

        which = findloc(units%name, name, dim=1)
        if (which == 0) then
            call fail(error, cause%usage, &
                'a drawing in '//name//'; units are INCHES, FEET, MM or M')
            return
        end if
        unit = units(which)
    end subroutine find_unit

end module export_units
