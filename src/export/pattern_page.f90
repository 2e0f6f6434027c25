!> A page of a pattern: lines, curves and words at full size, in inches from its lower left corner,
!> as plain data. SVG and PDF files are written from it.
module export_pattern_page
    use base_kinds, only: dp
    use export_pattern_letters, only: text_width
    use export_pattern_style, only: layer_of, layers
    implicit none (type, external)
    private

    public :: label_type, item_type, group_type, page_type, label_corners, bounds_of
    public :: drawing_order, is_straight

    !> What an item is.
    type, public :: item_list
        integer :: lines = 1    !! straight from point to point
        integer :: curves = 2   !! cubic Bezier arcs end to end: point, control, control, point, ...
        integer :: words = 3    !! a label
    end type item_list

    !> The kinds by name.
    type(item_list), parameter, public :: item_kind = item_list()

    !> Which point of its base line a label is placed by.
    type, public :: side_list
        integer :: right = 0    !! its start: it stands to the right of the point
        integer :: middle = 1   !! its middle
        integer :: left = 2     !! its end
    end type side_list

    !> The sides by name.
    type(side_list), parameter, public :: side = side_list()

    !> The side of the largest page of a PDF, in: so long may any page be.
    real(dp), parameter, public :: largest_page = 200.0_dp

    !> Words.
    type :: label_type
        character(:), allocatable :: text           !! any bytes, meant to be UTF-8
        real(dp) :: height = 0.12_dp                !! of the type (its em), in
        integer :: side = 0                         !! one of `side%...`
        logical :: is_bold = .false.                !! heavy type
        real(dp) :: along(2) = [1.0_dp, 0.0_dp]     !! direction of the base line, unit vector
    end type label_type

    !> Something drawn.
    type :: item_type
        integer :: kind = 0                     !! one of `item_kind%...`
        integer :: style = 0                    !! one of `style%...`
        integer :: group = 0                    !! place in the page's groups; 0: the sheet
        logical :: is_closed = .false.          !! the last point joins the first
        real(dp), allocatable :: at(:, :)       !! points by columns, in; of a label one
        type(label_type) :: label               !! the words
    end type item_type

    !> A part on the page.
    type :: group_type
        character(:), allocatable :: name       !! letters, figures, - _ .
        character(:), allocatable :: title      !! any bytes
    end type group_type

    !> A page.
    type :: page_type
        character(:), allocatable :: name           !! for a file name: letters, figures, - _ .
        character(:), allocatable :: title          !! of the file: deck and title, any bytes
        character(:), allocatable :: label          !! of the page: `STATION 20 A1`, any bytes
        real(dp) :: size(2) = 0.0_dp                !! width and height, in
        logical :: is_clipped = .false.             !! parts are seen within the window only
        real(dp) :: window(4) = 0.0_dp              !! left, bottom, right, top, in
        type(group_type), allocatable :: groups(:)  !! the parts, `groups(1:group_count)`
        integer :: group_count = 0                  !! how many there are
        type(item_type), allocatable :: items(:)    !! in the order of drawing, `items(1:count)`
        integer :: count = 0                        !! how many there are
        integer :: group = 0                        !! that items are put to
    contains
        procedure :: draw
        procedure :: draw_curves
        procedure :: write => write_label
        procedure :: add
        procedure :: open_group
        procedure :: close_group
        procedure :: place
    end type page_type

contains

    !> Draws straight lines from point to point.
    pure subroutine draw(page, kind, points, is_closed)
        class(page_type), intent(inout) :: page     !! gets them
        integer, intent(in) :: kind                 !! one of `style%...`
        real(dp), intent(in) :: points(:, :)        !! by columns, in
        logical, intent(in), optional :: is_closed  !! the last point joins the first
        type(item_type) :: item

        item%kind = item_kind%lines
        item%style = kind
        item%group = page%group
        item%at = points
        if (present(is_closed)) item%is_closed = is_closed
        call page%add(item)
    end subroutine draw

    !> Draws cubic Bezier arcs end to end.
    pure subroutine draw_curves(page, kind, control, is_closed)
        class(page_type), intent(inout) :: page     !! gets them
        integer, intent(in) :: kind                 !! one of `style%...`
        real(dp), intent(in) :: control(:, :)       !! 3n + 1 points by columns, in
        logical, intent(in) :: is_closed            !! they come back to their first point
        type(item_type) :: item

        item%kind = item_kind%curves
        item%style = kind
        item%group = page%group
        item%at = control
        item%is_closed = is_closed
        call page%add(item)
    end subroutine draw_curves

    !> Writes words.
    pure subroutine write_label(page, kind, at, label)
        class(page_type), intent(inout) :: page     !! gets them
        integer, intent(in) :: kind                 !! one of `style%...`
        real(dp), intent(in) :: at(2)               !! where, in
        type(label_type), intent(in) :: label       !! what
        type(item_type) :: item

        item%kind = item_kind%words
        item%style = kind
        item%group = page%group
        item%at = reshape(at, [2, 1])
        item%label = label
        call page%add(item)
    end subroutine write_label

    !> Adds an item as it is.
    pure subroutine add(page, item)
        class(page_type), intent(inout) :: page     !! gets it
        type(item_type), intent(in) :: item         !! the item
        type(item_type), allocatable :: grown(:)

        if (.not. allocated(page%items)) allocate (page%items(16))
        if (page%count == size(page%items)) then
            allocate (grown(2*page%count))
            grown(:page%count) = page%items
            call move_alloc(grown, page%items)
        end if
        page%count = page%count + 1
        page%items(page%count) = item
    end subroutine add

    !> Begins a part: what follows belongs to it.
    pure subroutine open_group(page, name, title)
        class(page_type), intent(inout) :: page     !! gets it
        character(*), intent(in) :: name            !! letters, figures, - _ .
        character(*), intent(in) :: title           !! any bytes
        type(group_type), allocatable :: grown(:)

        if (.not. allocated(page%groups)) allocate (page%groups(4))
        if (page%group_count == size(page%groups)) then
            allocate (grown(2*page%group_count))
            grown(:page%group_count) = page%groups
            call move_alloc(grown, page%groups)
        end if
        page%group_count = page%group_count + 1
        page%group = page%group_count
        page%groups(page%group)%name = name
        page%groups(page%group)%title = title
    end subroutine open_group

    !> Ends a part: what follows belongs to the sheet.
    pure subroutine close_group(page)
        class(page_type), intent(inout) :: page     !! the page
        page%group = 0
    end subroutine close_group

    !> Places all of another page on a page, turned left by a quarter or as it is. Its parts become
    !> parts of the page.
    pure subroutine place(page, other, at, is_turned)
        class(page_type), intent(inout) :: page     !! gets it
        type(page_type), intent(in) :: other        !! what
        real(dp), intent(in) :: at(2)               !! where its lower left corner goes, in
        logical, intent(in) :: is_turned            !! by a quarter, to the left
        type(item_type) :: item
        integer :: first, i

        first = page%group_count
        do i = 1, other%group_count
            call page%open_group(other%groups(i)%name, other%groups(i)%title)
        end do
        call page%close_group()
        do i = 1, other%count
            item = other%items(i)
            if (item%group > 0) item%group = item%group + first
            if (is_turned) call turn(item, other%size(2))
            item%at(1, :) = item%at(1, :) + at(1)
            item%at(2, :) = item%at(2, :) + at(2)
            call page%add(item)
        end do
    end subroutine place

    !> Turns an item by a quarter to the left, then moves it to the right.
    pure subroutine turn(item, width)
        type(item_type), intent(inout) :: item  !! the item
        real(dp), intent(in) :: width           !! of what is turned, then, in
        real(dp), allocatable :: turned(:, :)

        allocate (turned(2, size(item%at, 2)))
        turned(1, :) = width - item%at(2, :)
        turned(2, :) = item%at(1, :)
        call move_alloc(turned, item%at)
        item%label%along = [-item%label%along(2), item%label%along(1)]
    end subroutine turn

    !> The corners of the box of a label, counter-clockwise from the start of its base line, lowered
    !> to hold what hangs below it.
    pure function label_corners(at, label) result(corners)
        real(dp), intent(in) :: at(2)           !! where it stands, in
        type(label_type), intent(in) :: label   !! the words
        real(dp) :: corners(2, 4), start(2), up(2), width
        real(dp), parameter :: below = 0.21_dp, above = 0.75_dp

        width = text_width(label%text, label%height, label%is_bold)
        up = [-label%along(2), label%along(1)]*label%height
        start = at - 0.5_dp*real(label%side, dp)*width*label%along
        corners(:, 1) = start - below*up
        corners(:, 2) = corners(:, 1) + width*label%along
        corners(:, 3) = corners(:, 2) + (below + above)*up
        corners(:, 4) = corners(:, 1) + (below + above)*up
    end function label_corners

    !> The box around everything on a page: left, bottom, right, top, in. Curves are in the box of
    !> their control points.
    pure function bounds_of(page) result(box)
        type(page_type), intent(in) :: page !! with at least one item
        real(dp) :: box(4), corners(2, 4)
        integer :: i

        box(:2) = huge(1.0_dp)
        box(3:) = -huge(1.0_dp)
        do i = 1, page%count
            associate (item => page%items(i))
                if (item%kind == item_kind%words) then
                    corners = label_corners(item%at(:, 1), item%label)
                    box(:2) = min(box(:2), minval(corners, dim=2))
                    box(3:) = max(box(3:), maxval(corners, dim=2))
                else
                    box(:2) = min(box(:2), minval(item%at, dim=2))
                    box(3:) = max(box(3:), maxval(item%at, dim=2))
                end if
            end associate
        end do
    end function bounds_of

    !> The items in the order of a file: part by part, each layer by layer, the sheet last.
    pure function drawing_order(page) result(order)
        type(page_type), intent(in) :: page !! any page
        integer, allocatable :: order(:)
        integer :: key(page%count), parts, i
        integer, allocatable :: place(:)

        parts = 0
        if (allocated(page%groups)) parts = size(page%groups)
        do i = 1, page%count
            key(i) = page%items(i)%group
            if (key(i) == 0) key(i) = parts + 1
            key(i) = size(layers)*key(i) + layer_of(page%items(i)%style)
        end do
        allocate (place(size(layers)*(parts + 2) + 1), order(page%count))
        place = 0
        do i = 1, page%count
            place(key(i) + 1) = place(key(i) + 1) + 1
        end do
        do i = 2, size(place)
            place(i) = place(i) + place(i - 1)
        end do
        do i = 1, page%count
            place(key(i)) = place(key(i)) + 1
            order(place(key(i))) = i
        end do
    end function drawing_order

    !> True for a Bezier arc that is a straight line at even pace.
    pure logical function is_straight(control)
        real(dp), intent(in) :: control(2, 4) !! its control points, in
        real(dp), parameter :: close = 1.0e-9_dp
        real(dp) :: third(2)

        third = (control(:, 4) - control(:, 1))/3.0_dp
        is_straight = all(abs(control(:, 2) - control(:, 1) - third) < close) .and. &
            all(abs(control(:, 4) - control(:, 3) - third) < close)
    end function is_straight

end module export_pattern_page
