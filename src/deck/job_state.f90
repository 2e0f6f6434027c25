!> A job half read: what is finished, the body and the line that are open, and what holds for the
!> cuts to come.
module deck_job_state
    use base_decimal, only: decimal_type
    use base_fault, only: fault_list_type
    use deck_body_card, only: blame, card_type
    use deck_body_layout, only: body_layout
    use deck_job, only: body_type, job_type, name_length, piece_type, point_rule_type, range_type
    implicit none (type, external)
    private

    public :: state_type, standing_type, open_line_type, check_once, find_line, line_names, text_of

    !> What holds for the cuts and checks that follow, until a card says otherwise.
    type :: standing_type
        logical :: has_points = .false.         !! a POINTS card is in force
        type(point_rule_type) :: points         !! what it says
        type(range_type) :: limit(3)            !! along STA, BL, WL
        logical :: is_flange_forward = .false.  !! FLANGE FWD is in force
        type(decimal_type) :: skin              !! thickness of skin, deck units
        type(decimal_type) :: arcs              !! tolerance of circular arcs, deck units
    end type standing_type

    !> The line or outline whose data cards are being read.
    type :: open_line_type
        logical :: is_open = .false.                !! data cards may follow
        integer :: line = 0                         !! which line of the body; 0: its card was bad
        integer :: view = 0                         !! which view of it
        integer :: outline = 0                      !! or which outline of the body
        integer :: origin = 0                       !! where the view comes from
        logical :: is_sound = .true.                !! none of its cards was in error
        integer :: pieces = 0                       !! pieces so far
        type(piece_type), allocatable :: piece(:)   !! the pieces, with room for more
    end type open_line_type

    !> A job half read.
    type :: state_type
        type(job_type) :: job                       !! settings and finished bodies
        integer :: bodies = 0                       !! finished bodies
        type(body_type) :: body                     !! the open body, its lists with room for more
        logical :: has_body_card = .false.          !! the open body began with a BODY card
        integer :: lines = 0                        !! lines of the open body
        integer :: sections = 0                     !! its sections
        integer :: outlines = 0                     !! its faired outlines
        integer :: patches = 0                      !! its patches
        integer :: ducts = 0                        !! its ducts
        integer :: cuts = 0                         !! its cuts
        integer :: checks = 0                       !! its checks
        integer :: variables = 0                    !! variables of the sweep, with room for more
        integer :: targets = 0                      !! fields that vary
        integer :: wanted = 0                       !! measures that are looked at
        integer :: cards = 0                        !! cards of the job, with room for more
        type(card_type) :: before                   !! the last card that is no VARY card
        integer :: before_kind = 0                  !! one of `body_card%...`; 0: it was in error
        type(open_line_type) :: open                !! the open line
        type(standing_type) :: standing             !! what holds for cuts to come
        logical :: has_met(size(body_layout)) = .false. !! cards met that stand but once
    end type state_type

contains

    !> Says where a card that stands once in a deck, or once in a body, is met again.
    pure subroutine check_once(state, card, kind, owner, faults)
        type(state_type), intent(inout) :: state        !! the job so far
        type(card_type), intent(in) :: card             !! the card
        integer, intent(in) :: kind                     !! one of `body_card%...`
        character(*), intent(in) :: owner               !! deck or body
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        if (state%has_met(kind)) call blame(card, 1, 'a second '//trim(body_layout(kind)%word)// &
            ' card; a '//owner//' has one', faults)
        state%has_met(kind) = .true.
    end subroutine check_once

    !> Which line of the open body has a name; 0 where none has.
    pure integer function find_line(state, name)
        type(state_type), intent(in) :: state   !! the job so far
        character(*), intent(in) :: name        !! in capitals
        do find_line = state%lines, 1, -1
            if (state%body%line(find_line)%name == name) return
        end do
    end function find_line

    !> The names of the lines of the open body.
    pure function line_names(state) result(name)
        type(state_type), intent(in) :: state !! the job so far
        character(name_length) :: name(state%lines)
        integer :: i
        do i = 1, state%lines
            name(i) = state%body%line(i)%name
        end do
    end function line_names

    !> A text as a name.
    pure function text_of(text) result(name)
        character(*), intent(in) :: text !! at most as long as a name
        character(name_length) :: name
        name = text
    end function text_of

end module deck_job_state
