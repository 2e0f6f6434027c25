!> What a deck of printed tables says: figures as text, for their characters matter, and what is
!> known besides.
module deck_audit
    use base_kinds, only: dp, i64
    implicit none (type, external)
    private

    public :: audit_deck_type, audit_table_type, audit_entry_type, add_entry, add_table

    !> What a table is of, in the order of the words of the AUDIT card.
    type, public :: audit_view_list
        integer :: side = 1         !! a control line: WL over STA
        integer :: plan = 2         !! a control line: BL over STA
        integer :: station = 3      !! a section: WL over BL
        integer :: buttock = 4      !! a butt line: WL over STA
        integer :: waterline = 5    !! a waterline: BL over STA
    end type audit_view_list
    !> The views by name: `audit_view%side`.
    type(audit_view_list), parameter, public :: audit_view = audit_view_list()

    !> What an entry is.
    type, public :: entry_kind_list
        integer :: row = 1      !! a figure of the table
        integer :: exact = 2    !! a number known as it was punched
        integer :: about = 3    !! a number known to its decimals
        integer :: between = 4  !! a number known to lie between two
    end type entry_kind_list
    !> The kinds by name: `entry_kind%row`.
    type(entry_kind_list), parameter, public :: entry_kind = entry_kind_list()

    !> What can be known of a line besides its table, in the order of the words of the cards.
    type, public :: known_list
        integer :: x1 = 1, y1 = 2, s1 = 3, x2 = 4, y2 = 5, x3 = 6, y3 = 7, s3 = 8
        integer :: a = 9, e = 13, xi = 14, yi = 15
    end type known_list
    !> The same by name: `known%s3`.
    type(known_list), parameter, public :: known = known_list()

    !> Characters of the longest figure of a deck.
    integer, parameter, public :: entry_length = 24

    !> One figure.
    type :: audit_entry_type
        integer :: kind = 1                     !! one of `entry_kind%...`
        integer :: what = 0                     !! one of `known%...`; of a row 0
        logical :: is_along_y = .false.         !! of a row: the figure is an X
        integer :: column = 1                   !! of a row: which column of the page
        real(dp) :: along = 0.0_dp              !! of a row: X, or Y where it is along Y
        character(entry_length) :: along_text = ''  !! the same as it is on the card
        character(entry_length) :: text = ''    !! the figure as printed
        real(dp) :: low = 0.0_dp                !! of `between`
        real(dp) :: high = 0.0_dp               !! of `between`
        integer(i64) :: line = 0                !! line of the file
    end type audit_entry_type

    !> A printed table.
    type :: audit_table_type
        character(8) :: name = ''               !! of its line or section
        integer :: view = 1                     !! one of `audit_view%...`
        real(dp) :: at = 0.0_dp                 !! the station, butt line or waterline
        character(entry_length) :: at_text = '' !! the same as it is on the card
        character(8) :: control(3) = ''         !! of a station: lines of its points
        integer :: printing = 0                 !! how it was printed: place of the word, from 0
        logical :: is_fie = .false.             !! figures are feet-inches-eighths
        integer :: decimals = -1                !! of its figures; -1: those that most have
        integer :: conics = 1                   !! joined end to end
        real(dp) :: shift = 100.0_dp            !! added before coefficients were worked
        integer(i64) :: line = 0                !! where its AUDIT card stands
        integer :: count = 0                    !! entries
        type(audit_entry_type), allocatable :: entry(:) !! `entry(:count)`, in deck order
    end type audit_table_type

    !> A deck of printed tables.
    type :: audit_deck_type
        character(:), allocatable :: title      !! text of the TITLE card, or nothing
        character(:), allocatable :: units      !! INCHES, MM or FEET
        integer :: count = 0                    !! tables
        type(audit_table_type), allocatable :: table(:) !! `table(:count)`, in deck order
    end type audit_deck_type

contains

    !> Puts an entry behind the others of a table.
    pure subroutine add_entry(table, entry)
        type(audit_table_type), intent(inout) :: table  !! the table
        type(audit_entry_type), intent(in) :: entry     !! one more
        type(audit_entry_type), allocatable :: longer(:)

        if (.not. allocated(table%entry)) allocate (table%entry(16))
        if (table%count == size(table%entry)) then
            allocate (longer(2*table%count))
            longer(:table%count) = table%entry
            call move_alloc(longer, table%entry)
        end if
        table%count = table%count + 1
        table%entry(table%count) = entry
    end subroutine add_entry

    !> Puts a table behind the others of a deck.
    pure subroutine add_table(deck, table)
        type(audit_deck_type), intent(inout) :: deck    !! the deck
        type(audit_table_type), intent(in) :: table     !! one more
        type(audit_table_type), allocatable :: longer(:)

        if (.not. allocated(deck%table)) allocate (deck%table(4))
        if (deck%count == size(deck%table)) then
            allocate (longer(2*deck%count))
            longer(:deck%count) = deck%table
            call move_alloc(longer, deck%table)
        end if
        deck%count = deck%count + 1
        deck%table(deck%count) = table
    end subroutine add_table

end module deck_audit
