!> The layouts of LOFT's cards, as data: which columns hold which field, how it is read, what it
!> means. Reading, echo, carets under a fault and the printed card reference all come from here.
module deck_layout
    implicit none (type, external)
    private

    public :: field_layout_type, conic_field_list

    !> Columns of a card.
    integer, parameter, public :: card_columns = 80
    !> Columns 79 and 80 of a conic card are free for a sequence number.
    integer, parameter, public :: last_read_column = 78

    !> One field of a card.
    type :: field_layout_type
        character(5) :: name            !! as the card reference and the faults call it
        integer :: first                !! first column
        integer :: last                 !! last column
        character :: form               !! F decimal number, I whole number, A text
        integer :: decimals             !! decimals of an F field without a point
        character(9) :: unit            !! unit: deck units, a slope, or none
        character(64) :: meaning        !! one line for the card reference
    end type field_layout_type

    !> The fields of a conic card by name: `conic_fields(conic%x2)`.
    type :: conic_field_list
        integer :: x1 = 1, y1 = 2, s1 = 3, x2 = 4, y2 = 5, x3 = 6, y3 = 7, s3 = 8
        integer :: xi = 9, yi = 10, ityp = 11
    end type conic_field_list

    !> Which field of a conic card is which.
    type(conic_field_list), parameter, public :: conic = conic_field_list()

    !> The conic card (SAE 700202, appendix A, FORMAT 9): one card is one conic.
    type(field_layout_type), parameter, public :: conic_fields(11) = [ &
        field_layout_type('X1   ', 1, 8, 'F', 3, 'deck unit', &
        'first point; 999.99 or more ends the deck                       '), &
        field_layout_type('Y1   ', 9, 16, 'F', 3, 'deck unit', &
        'first point                                                     '), &
        field_layout_type('S1   ', 17, 24, 'F', 5, 'dy/dx    ', &
        'slope at the first point; vertical from a size of 999.99 on     '), &
        field_layout_type('X2   ', 25, 32, 'F', 3, 'deck unit', &
        'shoulder point, on the curve between the ends                   '), &
        field_layout_type('Y2   ', 33, 40, 'F', 3, 'deck unit', &
        'shoulder point                                                  '), &
        field_layout_type('X3   ', 41, 48, 'F', 3, 'deck unit', &
        'last point                                                      '), &
        field_layout_type('Y3   ', 49, 56, 'F', 3, 'deck unit', &
        'last point                                                      '), &
        field_layout_type('S3   ', 57, 64, 'F', 5, 'dy/dx    ', &
        'slope at the last point; vertical from a size of 999.99 on      '), &
        field_layout_type('XI   ', 65, 70, 'F', 3, 'deck unit', &
        'increment of X for the X table, with the sign of X3 - X1        '), &
        field_layout_type('YI   ', 71, 76, 'F', 3, 'deck unit', &
        'increment of Y for the Y table, with the sign of Y3 - Y1        '), &
        field_layout_type('ITYP ', 77, 78, 'I', 0, 'none     ', &
        'not zero: a Y table is wanted                                   ')]

    !> The TITLE card: a heading for every page of the listing.
    type(field_layout_type), parameter, public :: title_fields(2) = [ &
        field_layout_type('CARD ', 1, 8, 'A', 0, 'none     ', &
        'the word TITLE                                                  '), &
        field_layout_type('TEXT ', 9, 80, 'A', 0, 'none     ', &
        'the heading, as it is to be printed                             ')]

    !> The UNITS card: the unit of the deck's numbers. Nothing is converted by it.
    type(field_layout_type), parameter, public :: units_fields(2) = [ &
        field_layout_type('CARD ', 1, 8, 'A', 0, 'none     ', &
        'the word UNITS                                                  '), &
        field_layout_type('UNIT ', 9, 16, 'A', 0, 'none     ', &
        'INCHES (the default), MM or FEET                                ')]

end module deck_layout
