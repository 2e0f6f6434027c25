!> Measures of bodies, ducts and their sections for C; see `loft.h`.
module api_c_measure
    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int, c_int32_t, c_ptr, c_size_t
    use api_c_deck, only: find_deck
    use api_c_error, only: refuse, succeeded
    use api_c_text, only: copied
    use api_loft, only: body_measure_type, deck_type, duct_measure_type, duct_section_type, &
        error_type, measure_deck, measure_duct, measure_duct_station, measure_station, &
        section_measure_type
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: loft_deck_measure, loft_deck_measure_station
    public :: loft_deck_measure_duct, loft_deck_measure_duct_station

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

    !> Measures of a duct: `loft_duct`.
    type, bind(c) :: c_duct_type
        real(c_double) :: range(2)      !! stations, deck units
        real(c_double) :: volume        !! deck units**3
    end type c_duct_type

    !> Measures of a section of a duct: `loft_duct_section`.
    type, bind(c) :: c_duct_section_type
        real(c_double) :: sta               !! deck units
        real(c_double) :: area              !! deck units**2
        real(c_double) :: perimeter         !! deck units
        real(c_double) :: centroid(2)       !! BL, WL
        integer(c_int32_t) :: has_perimeter !! 1: it exists
        integer(c_int32_t) :: spare         !! 0
    end type c_duct_section_type

contains

    !> Measures a body: 1, or 0 where that fails.
    integer(c_int) function loft_deck_measure(deck, body, measure, error) &
        bind(c, name='loft_deck_measure') result(is_done)
        type(c_ptr), value :: deck                                  !! a handle
        integer(c_int), value :: body                               !! from 1
        type(c_measure_type), intent(inout), optional :: measure    !! gets what there is
        type(c_ptr), intent(out), optional :: error                 !! gets why it fails
        type(deck_type), pointer :: held
        type(body_measure_type) :: found
        type(error_type), allocatable :: trouble

        call find_for(deck, present(measure), held, trouble)
        if (.not. allocated(trouble)) call measure_deck(held, int(body), found, trouble)
        is_done = succeeded(trouble, error)
        if (allocated(trouble)) return
        measure%range = real([found%from, found%to], c_double)
        measure%volume = real(found%volume, c_double)
        measure%volume_error = real(found%volume_error, c_double)
        measure%centroid = real(found%centroid, c_double)
        measure%wetted_area = real(found%wetted_area, c_double)
        measure%wetted_error = real(found%wetted_error, c_double)
        measure%has_volume = merge(1_c_int32_t, 0_c_int32_t, found%has_volume)
        measure%has_wetted = merge(1_c_int32_t, 0_c_int32_t, found%has_wetted)
        call say_why(found%why, measure%why)
    end function loft_deck_measure

    !> Measures the section of a body at a station: 1, or 0 where that fails.
    integer(c_int) function loft_deck_measure_station(deck, body, sta, measure, error) &
        bind(c, name='loft_deck_measure_station') result(is_done)
        type(c_ptr), value :: deck                                  !! a handle
        integer(c_int), value :: body                               !! from 1
        real(c_double), value :: sta                                !! deck units
        type(c_section_type), intent(inout), optional :: measure    !! gets what there is
        type(c_ptr), intent(out), optional :: error                 !! gets why it fails
        type(deck_type), pointer :: held
        type(section_measure_type) :: found
        type(error_type), allocatable :: trouble

        call find_for(deck, present(measure), held, trouble)
        if (.not. allocated(trouble)) &
            call measure_station(held, int(body), real(sta, dp), found, trouble)
        is_done = succeeded(trouble, error)
        if (allocated(trouble)) return
        measure%sta = real(found%sta, c_double)
        measure%girth = real(found%girth, c_double)
        measure%area = real(found%area, c_double)
        measure%centroid = real(found%centroid, c_double)
        measure%inertia = real(found%inertia, c_double)
        measure%has_girth = merge(1_c_int32_t, 0_c_int32_t, found%has_girth)
        measure%has_area = merge(1_c_int32_t, 0_c_int32_t, found%has_area)
        call say_why(found%why, measure%why)
    end function loft_deck_measure_station

    !> Measures a duct: 1, or 0 where that fails.
    integer(c_int) function loft_deck_measure_duct(deck, body, duct, measure, error) &
        bind(c, name='loft_deck_measure_duct') result(is_done)
        type(c_ptr), value :: deck                              !! a handle
        integer(c_int), value :: body                           !! from 1
        integer(c_int), value :: duct                           !! of the body, from 1
        type(c_duct_type), intent(inout), optional :: measure   !! gets what it measures
        type(c_ptr), intent(out), optional :: error             !! gets why it fails
        type(deck_type), pointer :: held
        type(duct_measure_type) :: found
        type(error_type), allocatable :: trouble

        call find_for(deck, present(measure), held, trouble)
        if (.not. allocated(trouble)) &
            call measure_duct(held, int(body), int(duct), found, trouble)
        is_done = succeeded(trouble, error)
        if (allocated(trouble)) return
        measure%range = real(found%section([1, size(found%section)])%sta, c_double)
        measure%volume = real(found%volume, c_double)
    end function loft_deck_measure_duct

    !> Measures the section of a duct at a station: 1, or 0 where that fails.
    integer(c_int) function loft_deck_measure_duct_station(deck, body, duct, sta, measure, error) &
        bind(c, name='loft_deck_measure_duct_station') result(is_done)
        type(c_ptr), value :: deck                                      !! a handle
        integer(c_int), value :: body                                   !! from 1
        integer(c_int), value :: duct                                   !! of the body, from 1
        real(c_double), value :: sta                                    !! deck units
        type(c_duct_section_type), intent(inout), optional :: measure   !! gets what it measures
        type(c_ptr), intent(out), optional :: error                     !! gets why it fails
        type(deck_type), pointer :: held
        type(duct_section_type) :: found
        type(error_type), allocatable :: trouble

        call find_for(deck, present(measure), held, trouble)
        if (.not. allocated(trouble)) call measure_duct_station(held, int(body), int(duct), &
            real(sta, dp), found, trouble)
        is_done = succeeded(trouble, error)
        if (allocated(trouble)) return
        measure%sta = real(found%sta, c_double)
        measure%area = real(found%area, c_double)
        measure%perimeter = real(found%perimeter, c_double)
        measure%centroid = real(found%centroid, c_double)
        measure%has_perimeter = merge(1_c_int32_t, 0_c_int32_t, found%has_perimeter)
        measure%spare = 0_c_int32_t
    end function loft_deck_measure_duct_station

    !> Finds the deck behind a handle. Fails with `cause%usage` where it, or the place for the
    !> measures, is null.
    subroutine find_for(handle, has_place, deck, error)
        type(c_ptr), intent(in) :: handle                   !! of C
        logical, intent(in) :: has_place                    !! the caller has room for the measures
        type(deck_type), pointer, intent(out) :: deck       !! behind the handle
        type(error_type), allocatable, intent(out) :: error !! see above
        call find_deck(handle, deck, error)
        if (.not. (allocated(error) .or. has_place)) call refuse('the measure', error)
    end subroutine find_for

    !> Copies a reason, or nothing.
    subroutine say_why(reason, why)
        character(:), allocatable, intent(in) :: reason         !! may be absent
        character(kind=c_char), intent(inout) :: why(:)         !! gets it, a null behind it
        character(:), allocatable :: text
        integer(c_size_t) :: ignored

        text = ''
        if (allocated(reason)) text = reason
        ignored = copied(text, why, size(why, kind=c_size_t))
    end subroutine say_why

end module api_c_measure
