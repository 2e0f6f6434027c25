!> Tests of units. Oracles: the inch is 25.4 mm, a foot 12 inches; $INSUNITS as in Autodesk's "DXF
!> Reference": 1 inches, 2 feet, 4 millimetres, 6 metres.
program test_units
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use export_units, only: find_unit, unit_type
    use support_tap, only: tap_type
    implicit none (type, external)
    type(tap_type) :: tap

    call check_unit('INCHES', 1.0_dp, 1, .false.)
    call check_unit('FEET', 1.0_dp/12.0_dp, 2, .false.)
    call check_unit('MM', 25.4_dp, 4, .true.)
    call check_unit('M', 0.0254_dp, 6, .true.)
    call check_unknown()
    call tap%finish()

contains

    subroutine check_unit(name, inch, dxf, is_metric)
        character(*), intent(in) :: name    !! of the unit
        real(dp), intent(in) :: inch        !! how many an inch has
        integer, intent(in) :: dxf          !! of $INSUNITS
        logical, intent(in) :: is_metric    !! mm or m
        type(unit_type) :: unit
        type(error_type), allocatable :: error

        call find_unit(name, unit, error)
        call tap%ok(.not. allocated(error), name//' is a unit')
        call tap%near(unit%inch, inch, 1.0e-17_dp, name//': as many make an inch')
        call tap%ok(unit%dxf == dxf, name//': number for DXF')
        call tap%ok(unit%is_metric .eqv. is_metric, name//': metric or not')
        call tap%same(trim(unit%name), name, name//': keeps its name')
    end subroutine check_unit

    subroutine check_unknown()
        type(unit_type) :: unit
        type(error_type), allocatable :: error
        call find_unit('CUBITS', unit, error)
        call tap%ok(allocated(error), 'what is no unit is refused')
        if (.not. allocated(error)) return
        call tap%ok(error%cause == cause%usage, 'as a matter of usage')
        call tap%has(error%message, 'CUBITS', 'by its name')
    end subroutine check_unknown

end program test_units
