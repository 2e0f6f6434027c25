!> Measures of bodies and sections for C; see `loft.h`.
module api_c_measure
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_int, &
        c_int32_t, c_loc, c_ptr, c_size_t
    use api_c_deck, only: deck_of
    use api_c_error, only: hand_over, refuse
    use api_c_text, only: copied
    use api_loft, only: body_measure_type, deck_type, error_type, measure_deck, measure_station, &
        section_measure_type
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: loft_deck_measure, loft_deck_measure_station

    !> Bytes for the reason why something is not there.
    integer, parameter :: why_length = 256

    !> Measures of a body: `loft_measure`.
    type, bind(c) :: c_measure_type
        real(c_double) :: range(2)                      !! stations, deck units
        real(c_double) :: volume                        !! deck units**3
        real(c_double) :: volume_error                  !! estimate of the quadrature
        real(c_double) :: centroid(3)                   !! of the volume: STA, BL, WL
        real(c_double) :: wetted_area                   !! deck units**2
        real(c_double) :: wetted_error                  !! estimate of the quadrature
        integer(c_int32_t) :: has_volume                !! 1: it exists
        integer(c_int32_t) :: has_wetted                !! 1: it exists
        character(kind=c_char) :: why(why_length)       !! where there is no volume: why not
    end type c_measure_type

    !> Measures of a section: `loft_section`.
    type, bind(c) :: c_section_type
        real(c_double) :: sta                           !! deck units
        real(c_double) :: girth                         !! deck units
        real(c_double) :: area                          !! deck units**2
        real(c_double) :: centroid(2)                   !! BL, WL
        real(c_double) :: inertia(3)                    !! of WL**2, BL**2, BL WL
        integer(c_int32_t) :: has_girth                 !! 1: it exists
        integer(c_int32_t) :: has_area                  !! 1: it exists
        character(kind=c_char) :: why(why_length)       !! where there is no area: why not
    end type c_section_type

contains

    !> Measures a body: 1, or 0 where that fails.
    integer(c_int) function loft_deck_measure(deck, body, measure, error) &
        bind(c, name='loft_deck_measure') result(is_done)
        type(c_ptr), value :: deck          !! a handle
        integer(c_int), value :: body       !! from 1
        type(c_ptr), value :: measure       !! `loft_measure`: gets what there is
        type(c_ptr), value :: error         !! gets why it fails, or null
        type(deck_type), pointer :: held
        type(body_measure_type) :: found
        type(c_measure_type), pointer :: place
        type(error_type), allocatable :: trouble

        held => deck_of(deck)
        if (associated(held) .and. c_associated(measure)) then
            call measure_deck(held, int(body), found, trouble)
        else
            call refuse('the deck or the measure', trouble)
        end if
        is_done = merge(0_c_int, 1_c_int, allocated(trouble))
        call hand_over(trouble, error)
        if (is_done == 0_c_int) return
        call c_f_pointer(measure, place)
        place%range = real([found%from, found%to], c_double)
        place%volume = real(found%volume, c_double)
        place%volume_error = real(found%volume_error, c_double)
        place%centroid = real(found%centroid, c_double)
        place%wetted_area = real(found%wetted_area, c_double)
        place%wetted_error = real(found%wetted_error, c_double)
        place%has_volume = merge(1_c_int32_t, 0_c_int32_t, found%has_volume)
        place%has_wetted = merge(1_c_int32_t, 0_c_int32_t, found%has_wetted)
        call say_why(found%why, place%why)
    end function loft_deck_measure

    !> Measures the section of a body at a station: 1, or 0 where that fails.
    integer(c_int) function loft_deck_measure_station(deck, body, sta, measure, error) &
        bind(c, name='loft_deck_measure_station') result(is_done)
        type(c_ptr), value :: deck          !! a handle
        integer(c_int), value :: body       !! from 1
        real(c_double), value :: sta        !! deck units
        type(c_ptr), value :: measure       !! `loft_section`: gets what there is
        type(c_ptr), value :: error         !! gets why it fails, or null
        type(deck_type), pointer :: held
        type(section_measure_type) :: found
        type(c_section_type), pointer :: place
        type(error_type), allocatable :: trouble

        held => deck_of(deck)
        if (associated(held) .and. c_associated(measure)) then
            call measure_station(held, int(body), real(sta, dp), found, trouble)
        else
            call refuse('the deck or the measure', trouble)
        end if
        is_done = merge(0_c_int, 1_c_int, allocated(trouble))
        call hand_over(trouble, error)
        if (is_done == 0_c_int) return
        call c_f_pointer(measure, place)
        place%sta = real(found%sta, c_double)
        place%girth = real(found%girth, c_double)
        place%area = real(found%area, c_double)
        place%centroid = real(found%centroid, c_double)
        place%inertia = real(found%inertia, c_double)
        place%has_girth = merge(1_c_int32_t, 0_c_int32_t, found%has_girth)
        place%has_area = merge(1_c_int32_t, 0_c_int32_t, found%has_area)
        call say_why(found%why, place%why)
    end function loft_deck_measure_station

    !> Copies a reason, or nothing.
    subroutine say_why(reason, why)
        character(:), allocatable, intent(in) :: reason             !! may be absent
        character(kind=c_char), target, intent(inout) :: why(:)     !! gets it, a null behind it
        character(:), allocatable :: text
        integer(c_size_t) :: ignored

        text = ''
        if (allocated(reason)) text = reason
        ignored = copied(text, c_loc(why), size(why, kind=c_size_t))
    end subroutine say_why

end module api_c_measure
