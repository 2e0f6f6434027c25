!> The cuts of a lines plan: those that a deck asks for, whole and with points as close as the eye
!> can tell; where it asks for few of a kind, round ones beside them.
module app_plan_cuts
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_panel, only: panel_type
    use cut_outline, only: cut_at, cut_type, has_outlines, keep_cuts
    use cut_panel, only: cut_skin
    use cut_plane, only: buttock_plane, cut_kind, plane_type, station_plane, waterline_plane
    use cut_request, only: cut_fact, cut_rule, request_type
    use export_body_lines, only: find_corners
    use export_body_sheet, only: round_step, round_steps
    implicit none (type, external)
    private

    public :: plan_cuts, closely, panel_set_type

    !> The panels of a body.
    type :: panel_set_type
        type(panel_type), allocatable :: panel(:)   !! any
    end type panel_set_type

    !> Where a deck asks for fewer cuts of a kind than this, round ones are drawn as well: about so
    !> many stations, butt lines and waterlines.
    integer, parameter :: few = 3, round_ones(3) = [10, 5, 5]
    !> A round one nearer to one asked for than this is not drawn: parts of the round step.
    real(dp), parameter :: too_near = 0.3_dp
    !> How far the eye can tell a curve from its chords: parts of the size of the body.
    real(dp), parameter :: eye = 1.0e-4_dp

contains

    !> The cuts of a lines plan. Planes that miss a body give none.
    pure function plan_cuts(bodies, asked, sets) result(cuts)
        type(body_type), intent(in) :: bodies(:)    !! finished
        type(cut_type), intent(in) :: asked(:)      !! the cuts of the deck, of any body
        type(panel_set_type), intent(in), optional :: sets(:) !! the panels of each body
        type(cut_type), allocatable :: cuts(:)
        type(plane_type), allocatable :: planes(:)
        type(error_type), allocatable :: error
        type(request_type) :: request
        type(panel_type) :: none(0)
        logical, allocatable :: is_drawn(:)
        real(dp) :: low(3), high(3)
        integer :: i, k, number

        allocate (cuts(0), planes(0))
        call find_corners(bodies, cuts, low, high)
        planes = planes_of(asked, low, high)
        deallocate (cuts)
        allocate (cuts(size(planes)*size(bodies)), is_drawn(size(planes)*size(bodies)))
        request = closely(request, maxval(high - low))
        number = 0
        do i = 1, size(planes)
            request%plane = planes(i)
            do k = 1, size(bodies)
                number = number + 1
                if (present(sets)) then
                    call cut_skin(bodies(k), sets(k)%panel, request, cuts(number), error)
                else
                    call cut_skin(bodies(k), none, request, cuts(number), error)
                end if
                is_drawn(number) = .false.
                if (.not. allocated(error)) is_drawn(number) = has_outlines(cuts(number))
            end do
        end do
        call keep_cuts(is_drawn, cuts)
    end function plan_cuts

    !> The same cut with points as close as the eye can tell, and no more of them than is drawn.
    pure type(request_type) function closely(request, size_of_body) result(close)
        type(request_type), intent(in) :: request   !! any
        real(dp), intent(in) :: size_of_body        !! deck units
        close = request
        close%rule = cut_rule%chord
        close%step = eye*size_of_body
        close%facts = merge(cut_fact%bevel, cut_fact%slope, request%skin > 0.0_dp)
    end function closely

    !> Where to cut: kind by kind.
    pure function planes_of(asked, low, high) result(planes)
        type(cut_type), intent(in) :: asked(:)  !! the cuts of the deck
        real(dp), intent(in) :: low(3)          !! least ordinates of the bodies, deck units
        real(dp), intent(in) :: high(3)         !! greatest, deck units
        type(plane_type), allocatable :: planes(:)
        real(dp), allocatable :: ordinates(:)
        integer :: kind, i

        allocate (planes(0), ordinates(0))
        do kind = cut_kind%station, cut_kind%waterline
            ordinates = ordinates_of(asked, kind, low(kind), high(kind))
            planes = [planes, (plane_at(kind, ordinates(i)), i=1, size(ordinates))]
        end do
    end function planes_of

    !> Where to cut for a kind: as asked, each ordinate once, and at round ones where these are few.
    pure function ordinates_of(asked, kind, low, high) result(ordinates)
        type(cut_type), intent(in) :: asked(:)  !! the cuts of the deck
        integer, intent(in) :: kind             !! which of them; also the number of their axis
        real(dp), intent(in) :: low             !! least ordinate of the bodies, deck units
        real(dp), intent(in) :: high            !! greatest, deck units
        real(dp), allocatable :: ordinates(:), more(:)
        real(dp) :: least
        integer :: i

        allocate (ordinates(0))
        ordinates = cut_at(asked, kind, kind)
        if (size(ordinates) >= few .or. .not. high > low) return
        allocate (more(0))
        more = round_steps(low, high, round_ones(kind))
        least = too_near*round_step(high - low, round_ones(kind))
        do i = 1, size(more)
            if (any(abs(ordinates - more(i)) < least)) cycle
            ordinates = [ordinates, more(i)]
        end do
    end function ordinates_of

    !> The plane of a kind at an ordinate.
    pure type(plane_type) function plane_at(kind, ordinate) result(plane)
        integer, intent(in) :: kind         !! station, buttock or waterline
        real(dp), intent(in) :: ordinate    !! deck units
        select case (kind)
        case (cut_kind%station)
            plane = station_plane(ordinate)
        case (cut_kind%buttock)
            plane = buttock_plane(ordinate)
        case default
            plane = waterline_plane(ordinate)
        end select
    end function plane_at

end module app_plan_cuts
