!> LOFT as a library for Fortran: load a deck, look at its faults, cut it, measure it, evaluate its
!> conics. This module is all that a program need use; `loft.h` is the same for C.
!>
!>     use api_loft, only: at_station, cut_deck, cut_type, deck_type, error_type, load_deck
!>     type(deck_type) :: deck
!>     type(cut_type) :: cut
!>     type(error_type), allocatable :: error
!>
!>     call load_deck('cards/nose.crd', deck, error)
!>     if (.not. allocated(error)) call cut_deck(deck, at_station(20.0d0), cut, error)
!>     if (allocated(error)) error stop error%message
!>     print *, cut%points(1)%at
!>
!> A deck is plain data and owns all it holds: it is copied by assignment, freed when it goes out of
!> scope, and does not change once it is loaded. Nothing is kept between calls; nothing prints or
!> stops. Any number of threads may call these procedures at once, on decks of their own or on one
!> that they share, and none waits for another.
module api_loft
    use api_cut, only: asked_type, cut_asked, cut_listed, cut_type, find_body, is_coordinate, &
        point_type
    use api_deck, only: conic_type, deck_type, read_deck
    use api_deck_file, only: deck_file_type
    use base_constants, only: version
    use base_error, only: cause, error_type, fail
    use base_fault, only: fault_list_type, fault_type, severity
    use base_kinds, only: dp
    use base_text, only: compact, to_text
    use body_card_tables, only: card_table_type, tables_of_card
    use cut_duct, only: duct_measure_type, duct_section_type, outlines_of_duct => measure_duct, &
        measure_duct_at
    use cut_measure, only: measure_section, section_measure_type
    use cut_measure_body, only: body_measure_type, measure_body
    use cut_plane, only: cut_kind
    use cut_request, only: cut_rule
    use deck_source, only: source_type
    use geom_contour, only: row_type => contour_point_type
    implicit none (type, external)
    private

    public :: deck_type, load_deck, parse_deck, has_errors
    public :: asked_type, at_station, at_buttock, at_waterline, at_plane, cut_kind, cut_rule
    public :: cut_type, point_type, cut_deck, listed_cut
    public :: body_measure_type, section_measure_type, measure_deck, measure_station
    public :: duct_measure_type, duct_section_type, measure_duct, measure_duct_station
    public :: row_type, conic_table
    public :: error_type, cause, fault_type, severity, loft_version

contains

    !> Loads a deck from a file. Faults of its cards are in `deck%faults%item(:deck%faults%count)`;
    !> what is sound is there.
    !>
    !> Fails with `cause%file_trouble` and the system's words where the file can't be read.
    subroutine load_deck(path, deck, error)
        character(*), intent(in) :: path                    !! as it is: trim it where it is padded
        type(deck_type), intent(out) :: deck                !! the deck
        type(error_type), allocatable, intent(out) :: error !! see above
        type(deck_file_type) :: file
        type(source_type) :: source
        character(:), allocatable :: name

        name = path
        if (name == '-') name = './-'
        call file%open(name, source, error)
        if (allocated(error)) return
        call read_deck(source, deck, error)
        call file%close()
        if (allocated(error)) error%message = path//': '//error%message
    end subroutine load_deck

    !> Loads a deck from a text in memory, lines with line feeds between them.
    subroutine parse_deck(text, deck)
        character(*), intent(in) :: text        !! the deck
        type(deck_type), intent(out) :: deck    !! the same, read
        type(source_type) :: source
        type(error_type), allocatable :: none

        call source%from_text(text)
        call read_deck(source, deck, none)
    end subroutine parse_deck

    !> True where a card of a deck is in error, not merely warned of.
    pure logical function has_errors(deck)
        type(deck_type), intent(in) :: deck !! loaded
        has_errors = deck%faults%has_errors(0)
    end function has_errors

    !> The cut at a station. Body and spread of points may be set in what is asked, as in all of
    !> these.
    pure type(asked_type) function at_station(sta) result(asked)
        real(dp), intent(in) :: sta !! deck units
        asked%kind = cut_kind%station
        asked%point(1) = sta
    end function at_station

    !> The cut along a butt line.
    pure type(asked_type) function at_buttock(bl) result(asked)
        real(dp), intent(in) :: bl !! deck units, positive to starboard
        asked%kind = cut_kind%buttock
        asked%point(2) = bl
    end function at_buttock

    !> The cut along a waterline.
    pure type(asked_type) function at_waterline(wl) result(asked)
        real(dp), intent(in) :: wl !! deck units
        asked%kind = cut_kind%waterline
        asked%point(3) = wl
    end function at_waterline

    !> The cut by any plane.
    pure type(asked_type) function at_plane(point, normal) result(asked)
        real(dp), intent(in) :: point(3)    !! STA, BL, WL of a point of it, deck units
        real(dp), intent(in) :: normal(3)   !! across it, any length
        asked%kind = cut_kind%plane
        asked%point = point
        asked%normal = normal
    end function at_plane

    !> Cuts a body of a deck. Of a symmetric body the starboard half is cut, unless the plane cuts
    !> the halves differently: then the whole is. A plane that misses the body gives no points.
    !>
    !> Fails with `cause%usage` where the deck has no such body or a number can't be,
    !> `cause%points_coincide` where the normal is zero, `cause%beyond_lines` where the body's lines
    !> are not there, and `cause%too_many` points.
    subroutine cut_deck(deck, asked, cut, error)
        type(deck_type), intent(in) :: deck                 !! loaded
        type(asked_type), intent(in) :: asked               !! where, and how points are spread
        type(cut_type), intent(out) :: cut                  !! the points
        type(error_type), allocatable, intent(out) :: error !! see above

        call cut_asked(deck, asked, cut, error)
    end subroutine cut_deck

    !> A cut that the deck itself asks for: one of `deck%cuts`, as `loft run --format csv` counts.
    !>
    !> Fails with `cause%usage` where there is no such cut.
    subroutine listed_cut(deck, number, cut, error)
        type(deck_type), intent(in) :: deck                 !! loaded
        integer, intent(in) :: number                       !! from 1
        type(cut_type), intent(out) :: cut                  !! the points
        type(error_type), allocatable, intent(out) :: error !! see above

        call cut_listed(deck, number, cut, error)
    end subroutine listed_cut

    !> Volume, centroid and wetted area of a body, of both halves where it is symmetric.
    !>
    !> Fails with `cause%usage` where the deck has no such body.
    subroutine measure_deck(deck, body, measure, error)
        type(deck_type), intent(in) :: deck                 !! loaded
        integer, intent(in) :: body                         !! which body, from 1
        type(body_measure_type), intent(out) :: measure     !! what does not exist is marked absent
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp), allocatable :: stations(:)

        allocate (stations(0))
        call find_body(deck, body, error)
        if (.not. allocated(error)) &
            call measure_body(deck%bodies(body)%body, stations, measure)
    end subroutine measure_deck

    !> Girth, area, centroid and second moments of the section of a body at a station.
    !>
    !> Fails with `cause%usage` where the deck has no such body, or the station is no number.
    subroutine measure_station(deck, body, sta, measure, error)
        type(deck_type), intent(in) :: deck                 !! loaded
        integer, intent(in) :: body                         !! which body, from 1
        real(dp), intent(in) :: sta                         !! deck units
        type(section_measure_type), intent(out) :: measure  !! what does not exist is marked absent
        type(error_type), allocatable, intent(out) :: error !! see above

        call find_body(deck, body, error)
        if (.not. is_coordinate(sta)) call fail(error, cause%usage, &
            'the station is infinite, no number, or beyond those of a deck')
        if (.not. allocated(error)) &
            call measure_section(deck%bodies(body)%body, sta, measure)
    end subroutine measure_station

    !> Volume of a duct, and its sections that are outlines. All of it is meant; not its mirror
    !> image, where it has one.
    !>
    !> Fails with `cause%usage` where the deck has no such body, or the body no such duct.
    subroutine measure_duct(deck, body, duct, measure, error)
        type(deck_type), intent(in) :: deck                 !! loaded
        integer, intent(in) :: body                         !! which body, from 1
        integer, intent(in) :: duct                         !! which of its ducts, from 1
        type(duct_measure_type), intent(out) :: measure     !! STA rising
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp), allocatable :: stations(:)

        allocate (stations(0))
        call find_duct(deck, body, duct, error)
        if (.not. allocated(error)) &
            measure = outlines_of_duct(deck%bodies(body)%ducts(duct), stations)
    end subroutine measure_duct

    !> Area, perimeter and centroid of the section of a duct at a station: its area curve.
    !>
    !> Fails as `measure_duct`, with `cause%usage` where the station is no number, and with
    !> `cause%beyond_lines` where it is not from the first outline of the duct to its last.
    subroutine measure_duct_station(deck, body, duct, sta, section, error)
        type(deck_type), intent(in) :: deck                 !! loaded
        integer, intent(in) :: body                         !! which body, from 1
        integer, intent(in) :: duct                         !! which of its ducts, from 1
        real(dp), intent(in) :: sta                         !! deck units
        type(duct_section_type), intent(out) :: section     !! what it measures
        type(error_type), allocatable, intent(out) :: error !! see above

        call find_duct(deck, body, duct, error)
        if (.not. is_coordinate(sta)) call fail(error, cause%usage, &
            'the station is infinite, no number, or beyond those of a deck')
        if (allocated(error)) return
        associate (outlines => deck%bodies(body)%ducts(duct)%outline)
            if (sta < outlines(1)%sta .or. sta > outlines(size(outlines))%sta) then
                call fail(error, cause%beyond_lines, 'the duct goes from station '// &
                    compact(outlines(1)%sta)//' to '//compact(outlines(size(outlines))%sta)// &
                    ', not to '//compact(sta))
                return
            end if
        end associate
        call measure_duct_at(deck%bodies(body)%ducts(duct), sta, section)
    end subroutine measure_duct_station

    !> Fails with `cause%usage` where a deck has no such body, or the body no such duct.
    pure subroutine find_duct(deck, body, duct, error)
        type(deck_type), intent(in) :: deck                 !! loaded
        integer, intent(in) :: body                         !! which body, from 1
        integer, intent(in) :: duct                         !! which of its ducts, from 1
        type(error_type), allocatable, intent(out) :: error !! see above

        call find_body(deck, body, error)
        if (allocated(error)) return
        if (duct < 1 .or. duct > size(deck%bodies(body)%ducts)) call fail(error, cause%usage, &
            'the body has no duct '//to_text(duct)//'; it has '// &
            to_text(size(deck%bodies(body)%ducts)))
    end subroutine find_duct

    !> The table of a conic card of a 1970 deck by steps of an axis, from point 1 to point 3. No
    !> rows where the card asks for none, or has no arc: why is among the faults of the deck.
    !>
    !> Fails with `cause%usage` where the deck has no such card.
    subroutine conic_table(deck, card, axis, rows, error)
        type(deck_type), intent(in) :: deck                     !! loaded
        integer, intent(in) :: card                             !! which conic card, from 1
        integer, intent(in) :: axis                             !! 1: by steps of X, 2: of Y
        type(row_type), allocatable, intent(out) :: rows(:)     !! x, y, slope, curvature
        type(error_type), allocatable, intent(out) :: error     !! see above

        allocate (rows(0))
        if (card < 1 .or. card > size(deck%conics)) then
            call fail(error, cause%usage, 'the deck has no conic card '//to_text(card)// &
                '; it has '//to_text(size(deck%conics)))
        else if (deck%conics(card)%has_arc .and. deck%conics(card)%card%is_whole) then
            call make_table(deck%conics(card), axis, rows)
        end if
    end subroutine conic_table

    !> The table of a conic by steps of an axis; no rows where its card asks for none.
    subroutine make_table(conic, axis, rows)
        type(conic_type), intent(in) :: conic                   !! has its arc
        integer, intent(in) :: axis                             !! 1: by steps of X, 2: of Y
        type(row_type), allocatable, intent(inout) :: rows(:)   !! gets them
        type(card_table_type), allocatable :: tables(:)
        type(fault_list_type) :: known
        integer :: i

        allocate (tables(0))
        call tables_of_card(conic%card, conic%arc, tables, known)
        do i = 1, size(tables)
            if (tables(i)%axis == axis) rows = tables(i)%row
        end do
    end subroutine make_table

    !> The version of the library, as `loft --version` has it.
    pure function loft_version() result(text)
        character(len(version)) :: text
        text = version
    end function loft_version

end module api_loft
