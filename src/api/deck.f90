!> A deck held whole: read, its bodies built, cut and judged, its faults found, as plain data.
module api_deck
    use api_computed_body, only: computed_body_type, judge_body
    use base_error, only: cause, error_type, fail
    use base_fault, only: fault_list_type
    use body_card_arc, only: arc_of_card
    use body_card_tables, only: card_table_type, tables_of_card
    use deck_conic_card, only: conic_card_type
    use deck_conic_deck, only: conic_deck_type, found
    use deck_job, only: job_type, name_length
    use deck_job_reader, only: read_job
    use deck_kind, only: deck_kind_of, opening_type, read_opening
    use deck_source, only: source_type
    use geom_arc, only: arc_type
    implicit none (type, external)
    private

    public :: deck_type, conic_type, cut_entry_type, read_deck, judge_conic

    !> A conic card of a 1970 deck.
    type :: conic_type
        type(conic_card_type) :: card   !! as punched
        logical :: has_arc = .false.    !! its points and slopes have an arc
        type(arc_type) :: arc           !! that arc
    end type conic_type

    !> A cut that a body deck asks for: where it is among those computed.
    type :: cut_entry_type
        character(name_length) :: name = '' !! of its card, or blank
        integer :: body = 0                 !! the body it is of, from 1
        integer :: place = 0                !! among the cuts, or the faired outlines, of the body
        logical :: is_outline = .false.     !! a faired outline
    end type cut_entry_type

    !> A deck. Of a 1970 deck there are conics, of a body deck bodies and cuts.
    type :: deck_type
        logical :: is_body_deck = .false.                   !! a word decided, not a number
        character(:), allocatable :: title                  !! of the TITLE card, or nothing
        character(:), allocatable :: units                  !! INCHES, MM or FEET
        type(fault_list_type) :: faults                     !! all that `loft check` says
        type(conic_type), allocatable :: conics(:)          !! card by card
        type(job_type) :: job                               !! what a body deck asks for
        type(computed_body_type), allocatable :: bodies(:)  !! its bodies
        type(cut_entry_type), allocatable :: cuts(:)        !! as `loft run` counts them
    end type deck_type

contains

    !> Reads a deck. Faults of its cards are in its list; what is sound is there.
    !>
    !> Fails with `cause%file_trouble` where the source can't be read, and with `cause%usage` where
    !> it is a deck of printed tables.
    subroutine read_deck(source, deck, error)
        type(source_type), intent(inout) :: source          !! where its lines come from
        type(deck_type), intent(out) :: deck                !! the deck
        type(error_type), allocatable, intent(out) :: error !! see above
        type(opening_type) :: opening

        allocate (deck%conics(0), deck%bodies(0), deck%cuts(0))
        deck%title = ''
        deck%units = 'INCHES'
        call read_opening(source, opening, deck%faults, error)
        if (allocated(error)) return
        if (opening%kind >= deck_kind_of%audit) then
            call fail(error, cause%usage, 'a deck of printed tables, which loft audit reads')
            return
        end if
        deck%is_body_deck = opening%kind == deck_kind_of%body
        if (deck%is_body_deck) then
            call read_bodies(source, opening, deck, error)
        else
            call read_conics(source, opening, deck, error)
        end if
    end subroutine read_deck

    !> Reads a body deck whose beginning has been read, builds its bodies and makes its cuts.
    !>
    !> Fails with `cause%file_trouble` where the source can't be read.
    subroutine read_bodies(source, opening, deck, error)
        type(source_type), intent(inout) :: source          !! at the first card
        type(opening_type), intent(in) :: opening           !! how the deck begins
        type(deck_type), intent(inout) :: deck              !! gets job, bodies and cuts
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: i

        call read_job(source, opening%heading, deck%job, deck%faults, error)
        if (allocated(error)) return
        if (allocated(deck%job%title)) deck%title = deck%job%title
        deck%units = trim(deck%job%units)
        deallocate (deck%bodies)
        allocate (deck%bodies(size(deck%job%body)))
        do i = 1, size(deck%bodies)
            call judge_body(deck%job, i, deck%bodies(i), deck%faults)
            call list_cuts(i, deck%bodies(i), deck%cuts)
        end do
    end subroutine read_bodies

    !> Adds the cuts and faired outlines of a body to the list, in the order of `loft run`.
    pure subroutine list_cuts(number, body, cuts)
        integer, intent(in) :: number                               !! of the body, from 1
        type(computed_body_type), intent(in) :: body                !! the body
        type(cut_entry_type), allocatable, intent(inout) :: cuts(:) !! gets them
        type(cut_entry_type), allocatable :: more(:)
        integer :: i, count

        count = size(body%cuts)
        allocate (more(count + size(body%outlines)))
        do i = 1, count
            more(i) = cut_entry_type(body%cuts(i)%name, number, i, .false.)
        end do
        do i = 1, size(body%outlines)
            more(count + i) = cut_entry_type(body%outlines(i)%name, number, i, .true.)
        end do
        cuts = [cuts, more]
    end subroutine list_cuts

    !> Reads a 1970 deck whose beginning has been read.
    !>
    !> Fails with `cause%file_trouble` where the source can't be read.
    subroutine read_conics(source, opening, deck, error)
        type(source_type), intent(inout) :: source          !! at the first card
        type(opening_type), intent(in) :: opening           !! how the deck begins
        type(deck_type), intent(inout) :: deck              !! gets the conics
        type(error_type), allocatable, intent(out) :: error !! see above
        type(conic_deck_type) :: cards
        type(conic_type) :: conic
        type(conic_type), allocatable :: grown(:)
        integer :: outcome, count

        count = 0
        cards%heading = opening%heading
        do
            call cards%next(source, conic%card, outcome, deck%faults, error)
            if (allocated(error)) return
            if (outcome == found%finished) exit
            call judge_conic(conic%card, conic%arc, conic%has_arc, deck%faults)
            if (count == size(deck%conics)) then
                allocate (grown(2*count + 8))
                grown(:count) = deck%conics
                call move_alloc(grown, deck%conics)
            end if
            count = count + 1
            deck%conics(count) = conic
        end do
        deck%conics = deck%conics(:count)
        if (allocated(cards%heading%title)) deck%title = cards%heading%title
        if (allocated(cards%heading%units)) deck%units = trim(cards%heading%units)
    end subroutine read_conics

    !> Looks whether a card would run, and finds its arc.
    subroutine judge_conic(card, arc, has_arc, faults)
        type(conic_card_type), intent(in) :: card       !! the card, sound or not
        type(arc_type), intent(out) :: arc              !! its arc, where there is one
        logical, intent(out) :: has_arc                 !! there is one
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(card_table_type), allocatable :: tables(:)

        has_arc = .false.
        if (.not. card%is_readable .or. card%has_coinciding_points()) return
        call arc_of_card(card, arc, has_arc, faults)
        if (has_arc) call tables_of_card(card, arc, tables, faults)
    end subroutine judge_conic

end module api_deck
