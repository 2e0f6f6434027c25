!> Cuts as handles of C: making and freeing them; see `loft.h`.
module api_c_cut
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_int32_t, &
        c_loc, c_null_ptr, c_ptr
    use api_c_deck, only: find_deck
    use api_c_error, only: hand_over, refuse
    use api_loft, only: asked_type, at_buttock, at_plane, at_station, at_waterline, cut_deck, &
        cut_type, deck_type, error_type, listed_cut
    use base_kinds, only: dp
    implicit none (type, external)
    private

    public :: cut_of, loft_deck_cut, loft_cut_station, loft_cut_buttock, loft_cut_waterline
    public :: loft_cut_plane, loft_cut_free

    !> How points are spread, and the flange: `loft_spread`.
    type, bind(c) :: spread_type
        real(c_double) :: step                  !! deck units
        integer(c_int32_t) :: rule              !! one of `cut_rule%...`, or 0
        integer(c_int32_t) :: number            !! of points
        integer(c_int32_t) :: flange_forward    !! not 0: FLANGE FWD
        integer(c_int32_t) :: spare             !! not looked at
    end type spread_type

contains

    !> The cut behind a handle; not associated where the handle is null.
    function cut_of(handle) result(cut)
        type(c_ptr), intent(in) :: handle !! of C
        type(cut_type), pointer :: cut
        cut => null()
        if (c_associated(handle)) call c_f_pointer(handle, cut)
    end function cut_of

    !> A cut that the deck asks for; null where that fails.
    type(c_ptr) function loft_deck_cut(deck, number, error) bind(c, name='loft_deck_cut') &
        result(handle)
        type(c_ptr), value :: deck                          !! a handle
        integer(c_int), value :: number                     !! of the cut, from 1
        type(c_ptr), intent(out), optional :: error         !! gets why it fails
        type(deck_type), pointer :: held
        type(error_type), allocatable :: trouble
        type(cut_type), pointer :: cut

        allocate (cut)
        call find_deck(deck, held, trouble)
        if (.not. allocated(trouble)) call listed_cut(held, int(number), cut, trouble)
        call give(cut, trouble, handle, error)
    end function loft_deck_cut

    !> The cut at a station; null where that fails.
    type(c_ptr) function loft_cut_station(deck, body, sta, spread, error) &
        bind(c, name='loft_cut_station') result(handle)
        type(c_ptr), value :: deck                          !! a handle
        integer(c_int), value :: body                       !! from 1
        real(c_double), value :: sta                        !! deck units
        type(spread_type), intent(in), optional :: spread   !! the defaults where absent
        type(c_ptr), intent(out), optional :: error         !! gets why it fails
        handle = cut_as(deck, body, at_station(real(sta, dp)), spread, error)
    end function loft_cut_station

    !> The cut along a butt line; null where that fails.
    type(c_ptr) function loft_cut_buttock(deck, body, bl, spread, error) &
        bind(c, name='loft_cut_buttock') result(handle)
        type(c_ptr), value :: deck                          !! a handle
        integer(c_int), value :: body                       !! from 1
        real(c_double), value :: bl                         !! deck units
        type(spread_type), intent(in), optional :: spread   !! the defaults where absent
        type(c_ptr), intent(out), optional :: error         !! gets why it fails
        handle = cut_as(deck, body, at_buttock(real(bl, dp)), spread, error)
    end function loft_cut_buttock

    !> The cut along a waterline; null where that fails.
    type(c_ptr) function loft_cut_waterline(deck, body, wl, spread, error) &
        bind(c, name='loft_cut_waterline') result(handle)
        type(c_ptr), value :: deck                          !! a handle
        integer(c_int), value :: body                       !! from 1
        real(c_double), value :: wl                         !! deck units
        type(spread_type), intent(in), optional :: spread   !! the defaults where absent
        type(c_ptr), intent(out), optional :: error         !! gets why it fails
        handle = cut_as(deck, body, at_waterline(real(wl, dp)), spread, error)
    end function loft_cut_waterline

    !> The cut by any plane; null where that fails.
    type(c_ptr) function loft_cut_plane(deck, body, point, normal, spread, error) &
        bind(c, name='loft_cut_plane') result(handle)
        type(c_ptr), value :: deck                          !! a handle
        integer(c_int), value :: body                       !! from 1
        real(c_double), intent(in), optional :: point(3)    !! STA, BL, WL, deck units
        real(c_double), intent(in), optional :: normal(3)   !! across the plane, any length
        type(spread_type), intent(in), optional :: spread   !! the defaults where absent
        type(c_ptr), intent(out), optional :: error         !! gets why it fails
        type(error_type), allocatable :: trouble

        if (present(point) .and. present(normal)) then
            handle = cut_as(deck, body, at_plane(real(point, dp), real(normal, dp)), spread, error)
        else
            handle = c_null_ptr
            call refuse('the point or the normal', trouble)
            call hand_over(trouble, error)
        end if
    end function loft_cut_plane

    !> Frees a cut.
    subroutine loft_cut_free(handle) bind(c, name='loft_cut_free')
        type(c_ptr), intent(inout), optional :: handle !! becomes NULL
        type(cut_type), pointer :: cut

        if (.not. present(handle)) return
        cut => cut_of(handle)
        if (associated(cut)) deallocate (cut)
        handle = c_null_ptr
    end subroutine loft_cut_free

    !> Makes a cut; null where that fails.
    type(c_ptr) function cut_as(deck, body, plane, spread, error) result(handle)
        type(c_ptr), intent(in) :: deck                     !! a handle, or null
        integer(c_int), intent(in) :: body                  !! from 1
        type(asked_type), intent(in) :: plane               !! where to cut
        type(spread_type), intent(in), optional :: spread   !! the defaults where absent
        type(c_ptr), intent(out), optional :: error         !! gets why it fails
        type(deck_type), pointer :: held
        type(error_type), allocatable :: trouble
        type(asked_type) :: asked
        type(cut_type), pointer :: cut

        allocate (cut)
        asked = plane
        asked%body = int(body)
        if (present(spread)) call take_spread(spread, asked)
        call find_deck(deck, held, trouble)
        if (.not. allocated(trouble)) call cut_deck(held, asked, cut, trouble)
        call give(cut, trouble, handle, error)
    end function cut_as

    !> Takes the spread of points that is asked.
    subroutine take_spread(spread, asked)
        type(spread_type), intent(in) :: spread     !! of C
        type(asked_type), intent(inout) :: asked    !! gets it; as it is: the defaults

        asked%is_flange_forward = spread%flange_forward /= 0_c_int32_t
        if (spread%rule == 0_c_int32_t) return
        asked%rule = int(spread%rule)
        asked%number = int(spread%number)
        asked%step = real(spread%step, dp)
    end subroutine take_spread

    !> Gives a cut to the caller, or frees it and says why there is none.
    subroutine give(cut, trouble, handle, error)
        type(cut_type), pointer, intent(inout) :: cut           !! made, or not
        type(error_type), allocatable, intent(in) :: trouble    !! why not
        type(c_ptr), intent(out) :: handle                      !! of the cut, or null
        type(c_ptr), intent(out), optional :: error             !! gets why it fails

        handle = c_null_ptr
        if (allocated(trouble)) then
            deallocate (cut)
        else
            handle = c_loc(cut)
        end if
        call hand_over(trouble, error)
    end subroutine give

end module api_c_cut
