!> Cuts of a loaded deck as a user of the library has them: one list of points, each with the
!> outline it is on and the section it is of.
module api_cut
    use api_computed_body, only: computed_body_type
    use api_deck, only: deck_type
    use base_constants, only: largest_table
    use base_decimal, only: largest_power
    use base_error, only: cause, error_type, fail
    use base_exact, only: is_finite
    use base_kinds, only: dp
    use base_text, only: to_text
    use cut_faired, only: faired_cut, points_around
    use cut_outline, only: made_cut_type => cut_type, made_point_type => cut_point_type, &
        note_type, outline_type
    use cut_panel, only: cut_skin
    use cut_plane, only: buttock_plane, cut_kind, plane_through, station_plane, waterline_plane
    use cut_request, only: cut_rule, request_type
    use deck_job, only: name_length
    implicit none (type, external)
    private

    public :: asked_type, cut_type, point_type, cut_asked, cut_listed, find_body, is_coordinate

    !> A cut asked of a body.
    type :: asked_type
        integer :: body = 1                     !! which body of the deck, from 1
        integer :: kind = 0                     !! one of `cut_kind%...`, not oblique
        real(dp) :: point(3) = 0.0_dp           !! of the plane: STA, BL, WL, deck units; of a
                                                !! station, butt line or waterline its ordinate
        real(dp) :: normal(3) = 0.0_dp          !! of a plane of kind `cut_kind%plane`, any length
        integer :: rule = 2                     !! how points are spread: `cut_rule%number`,
                                                !! `%length` or `%chord`
        integer :: number = 25                  !! `cut_rule%number`: points on each arc
        real(dp) :: step = 0.0_dp               !! length of the others, deck units
        logical :: is_flange_forward = .false.  !! for the bevel
    end type asked_type

    !> A point of a cut. A value that does not exist is marked absent and is zero.
    type :: point_type
        integer :: outline = 0              !! which outline of the cut, from 1
        integer :: section = 0              !! place of its section's name in `sections` of the cut
        real(dp) :: at(3) = 0.0_dp          !! STA, BL, WL, deck units
        real(dp) :: uv(2) = 0.0_dp          !! true-shape coordinates in the plane, deck units
        logical :: has_slope = .false.      !! the slope exists
        logical :: is_vertical = .false.    !! the slope is infinite
        real(dp) :: slope = 0.0_dp          !! dv/du in the plane
        logical :: has_curvature = .false.  !! the curvature exists
        real(dp) :: curvature = 0.0_dp      !! 1/deck unit, positive where the outline turns left
        logical :: has_normal = .false.     !! normal and bevel exist
        real(dp) :: normal(3) = 0.0_dp      !! outward unit normal of the skin
        real(dp) :: bevel = 0.0_dp          !! of the flange, degrees, positive where open
    end type point_type

    !> A cut.
    type :: cut_type
        character(name_length) :: name = ''                     !! of its card, or blank
        integer :: kind = 0                                     !! one of `cut_kind%...`
        character(name_length), allocatable :: sections(:)      !! names of sections and patches
        logical, allocatable :: is_closed(:)                    !! of each outline
        type(point_type), allocatable :: points(:)              !! outline by outline, in order
        type(note_type), allocatable :: notes(:)                !! what the user will want to know
    end type cut_type

contains

    !> Cuts a body of a deck as asked.
    !>
    !> Fails with `cause%usage` where the deck has no such body or a number is out of its range,
    !> with `cause%points_coincide` where a normal is zero, and as `cut_skin`.
    pure subroutine cut_asked(deck, asked, cut, error)
        type(deck_type), intent(in) :: deck                 !! loaded
        type(asked_type), intent(in) :: asked               !! what is asked
        type(cut_type), intent(out) :: cut                  !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(request_type) :: request
        type(made_cut_type) :: made

        call find_body(deck, asked%body, error)
        if (.not. allocated(error)) call read_request(asked, request, error)
        if (allocated(error)) return
        associate (body => deck%bodies(asked%body))
            call cut_skin(body%body, body%panels, request, made, error)
            if (.not. allocated(error)) call take_cut(made, body%sections, cut)
        end associate
    end subroutine cut_asked

    !> A cut that the deck asks for, by its number in the list of the deck.
    !>
    !> Fails with `cause%usage` where there is no such cut, and as `faired_cut`.
    pure subroutine cut_listed(deck, number, cut, error)
        type(deck_type), intent(in) :: deck                 !! loaded
        integer, intent(in) :: number                       !! from 1
        type(cut_type), intent(out) :: cut                  !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(made_cut_type) :: made

        if (number < 1 .or. number > size(deck%cuts)) then
            call fail(error, cause%usage, 'the deck has no cut '//to_text(number)// &
                '; it has '//to_text(size(deck%cuts)))
            return
        end if
        associate (entry => deck%cuts(number), body => deck%bodies(deck%cuts(number)%body))
            if (entry%is_outline) then
                call faired_cut(body%outlines(entry%place), points_around, made, error)
                if (.not. allocated(error)) call take_cut(made, [entry%name], cut)
            else
                call take_cut(body%cuts(entry%place), body%sections, cut)
            end if
            cut%name = entry%name
        end associate
    end subroutine cut_listed

    !> Fails with `cause%usage` where a deck has no such body, or it has no section to cut.
    pure subroutine find_body(deck, number, error)
        type(deck_type), intent(in) :: deck                 !! loaded
        integer, intent(in) :: number                       !! from 1
        type(error_type), allocatable, intent(out) :: error !! see above

        if (number < 1 .or. number > size(deck%bodies)) then
            call fail(error, cause%usage, 'the deck has no body '//to_text(number)//'; it has '// &
                to_text(size(deck%bodies)))
        else if (size(deck%bodies(number)%sections) == 0) then
            call fail(error, cause%usage, 'the body has no section')
        end if
    end subroutine find_body

    !> What is asked, in the terms of the cut layer.
    !>
    !> Fails with `cause%usage`, `cause%too_many` and `cause%points_coincide`.
    pure subroutine read_request(asked, request, error)
        type(asked_type), intent(in) :: asked               !! what is asked
        type(request_type), intent(out) :: request          !! the same
        type(error_type), allocatable, intent(out) :: error !! see above

        call check_numbers(asked, error)
        if (allocated(error)) return
        request%rule = asked%rule
        request%number = asked%number
        request%step = asked%step
        request%is_flange_forward = asked%is_flange_forward
        select case (asked%kind)
        case (cut_kind%station)
            request%plane = station_plane(asked%point(1))
        case (cut_kind%buttock)
            request%plane = buttock_plane(asked%point(2))
        case (cut_kind%waterline)
            request%plane = waterline_plane(asked%point(3))
        case (cut_kind%plane)
            call plane_through(asked%point, asked%normal, request%plane, error)
        case default
            call fail(error, cause%usage, 'a cut is a station, buttock, waterline or plane')
        end select
    end subroutine read_request

    !> Looks at the numbers of what is asked.
    !>
    !> Fails with `cause%usage` and `cause%too_many`.
    pure subroutine check_numbers(asked, error)
        type(asked_type), intent(in) :: asked               !! what is asked
        type(error_type), allocatable, intent(out) :: error !! see above

        if (.not. all(is_coordinate([asked%point, asked%normal, asked%step]))) then
            call fail(error, cause%usage, 'a number of the cut is infinite, no number, or '// &
                'beyond those of a deck')
        else if (asked%rule < cut_rule%number .or. asked%rule > cut_rule%chord) then
            call fail(error, cause%usage, 'points are spread by number, length or chord')
        else if (asked%rule == cut_rule%number .and. asked%number < 2) then
            call fail(error, cause%usage, 'an arc has 2 points or more')
        else if (asked%rule == cut_rule%number .and. asked%number > largest_table) then
            call fail(error, cause%too_many, 'an arc has '//to_text(largest_table)// &
                ' points at most')
        else if (asked%rule /= cut_rule%number .and. .not. asked%step > 0.0_dp) then
            call fail(error, cause%usage, 'the step of points is above zero')
        end if
    end subroutine check_numbers

    !> True for a number that a deck may have: finite, and so large at most that no product of
    !> three overflows.
    elemental logical function is_coordinate(x)
        real(dp), intent(in) :: x !! any number
        is_coordinate = is_finite(x)
        if (is_coordinate) is_coordinate = abs(x) <= 10.0_dp**largest_power
    end function is_coordinate

    !> A cut as it was made, as a list of points.
    pure subroutine take_cut(made, sections, cut)
        type(made_cut_type), intent(in) :: made         !! as the cut layer makes it
        character(*), intent(in) :: sections(:)         !! names of sections and patches
        type(cut_type), intent(inout) :: cut            !! the same for a user

        cut%name = made%name
        cut%kind = made%plane%kind
        cut%sections = sections
        allocate (cut%is_closed(0), cut%points(0), cut%notes(0))
        if (allocated(made%notes)) cut%notes = made%notes
        call take_outlines(made%outlines, cut)
        if (allocated(made%patched)) call take_outlines(made%patched, cut)
    end subroutine take_cut

    !> Adds outlines to a cut.
    pure subroutine take_outlines(outlines, cut)
        type(outline_type), intent(in) :: outlines(:)   !! in order
        type(cut_type), intent(inout) :: cut            !! gets them
        type(point_type), allocatable :: points(:)
        integer :: i, k, count

        do i = 1, size(outlines)
            count = size(cut%is_closed) + 1
            allocate (points(size(outlines(i)%points)))
            do k = 1, size(points)
                points(k) = point_of(outlines(i)%points(k), count)
            end do
            cut%is_closed = [cut%is_closed, outlines(i)%is_closed]
            cut%points = [cut%points, points]
            deallocate (points)
        end do
    end subroutine take_outlines

    !> A point for a user.
    pure type(point_type) function point_of(made, outline) result(point)
        type(made_point_type), intent(in) :: made   !! as the cut layer makes it
        integer, intent(in) :: outline              !! which outline it is on
        point%outline = outline
        point%section = made%section
        point%at = made%at
        point%uv = made%uv
        point%has_slope = made%has_slope
        point%is_vertical = made%has_slope .and. made%slope%is_vertical
        if (made%has_slope) point%slope = made%slope%value
        point%has_curvature = made%has_curvature
        if (made%has_curvature) point%curvature = made%curvature
        point%has_normal = made%has_normal
        if (.not. made%has_normal) return
        point%normal = made%normal
        point%bevel = made%bevel
    end function point_of

end module api_cut
