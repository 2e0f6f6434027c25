!> What stands beside the shapes on a drawing in DXF: the reference lines with their ordinates, and
!> the notes below.
!>
!> The page is the plane of the true shapes, u to the right and v upwards, in which all cuts lie
!> over each other at a common origin; of a drawing in space it is the plane of BL 0, station to
!> the right and waterline upwards.
module export_dxf_page
    use base_digits, only: shortest
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use export_axis, only: axis_names
    use export_drawing, only: drawing_type
    implicit none (type, external)
    private

    public :: page_type, stroke_type, words_type, words_side, page_axes, add_references, add_words

    !> A straight line on the page.
    type :: stroke_type
        real(dp) :: from(2) = 0.0_dp        !! one end
        real(dp) :: to(2) = 0.0_dp          !! the other
    end type stroke_type

    !> Which point of the words stands at their place, numbered as in DXF.
    type :: words_side_list
        integer :: left = 0     !! their left end
        integer :: middle = 1   !! their middle
        integer :: right = 2    !! their right end
    end type words_side_list

    !> The points by name.
    type(words_side_list), parameter :: words_side = words_side_list()

    !> Words on the page.
    type :: words_type
        real(dp) :: at(2) = 0.0_dp              !! where they stand, half their height up
        integer :: side = 0                     !! one of `words_side%...`
        character(:), allocatable :: text       !! any bytes
    end type words_type

    !> The page around the shapes.
    type :: page_type
        real(dp) :: low(2) = 0.0_dp             !! lower left corner of the shapes
        real(dp) :: high(2) = 0.0_dp            !! upper right corner
        real(dp) :: height = 1.0_dp             !! of letters
        type(stroke_type), allocatable :: references(:) !! reference lines
        type(words_type), allocatable :: ordinates(:)   !! of the reference lines
        type(stroke_type), allocatable :: ticks(:)      !! of bevel marks
        type(words_type), allocatable :: words(:)       !! notes and bevels
    end type page_type

    !> Height of letters and distance of reference lines, about, in parts of the shapes' size.
    real(dp), parameter :: letter_part = 0.01_dp, step_part = 0.1_dp
    !> What follows is in heights of letters: how far reference lines reach beyond the shapes, from
    !> there to their ordinates.
    real(dp), parameter :: reach = 3.0_dp, beside = 1.0_dp

contains

    !> The names of the two axes of the page: all that some shape has, `STA/BL`.
    pure subroutine page_axes(drawing, is_in_space, u_name, v_name)
        type(drawing_type), intent(in) :: drawing               !! with cuts or lines
        logical, intent(in) :: is_in_space                      !! the page is BL 0
        character(:), allocatable, intent(out) :: u_name        !! of the axis to the right
        character(:), allocatable, intent(out) :: v_name        !! of the axis upwards
        character(3) :: names(2)
        integer :: i

        if (is_in_space) then
            u_name = 'STA'
            v_name = 'WL'
            return
        end if
        u_name = ''
        v_name = ''
        do i = 1, size(drawing%cuts)
            names = axis_names(drawing%cuts(i)%kind)
            call join(u_name, trim(names(1)))
            call join(v_name, trim(names(2)))
        end do
    end subroutine page_axes

    !> Joins a name to others where it is not among them.
    pure subroutine join(names, name)
        character(:), allocatable, intent(inout) :: names   !! with strokes between them
        character(*), intent(in) :: name                    !! one more
        if (names == '') then
            names = name
        else if (index('/'//names//'/', '/'//name//'/') == 0) then
            names = names//'/'//name
        end if
    end subroutine join

    !> Chooses the height of letters and draws the reference lines at round ordinates, both sets
    !> over all of the shapes, with their ordinates at the left and below.
    pure subroutine add_references(page, u_name, v_name)
        type(page_type), intent(inout) :: page  !! with its corners
        character(*), intent(in) :: u_name      !! of the axis to the right
        character(*), intent(in) :: v_name      !! of the axis upwards
        real(dp), allocatable :: at(:)
        real(dp) :: size_of, low(2), high(2)
        integer :: i

        size_of = maxval(page%high - page%low)
        if (.not. size_of > spacing(maxval(abs([page%low, page%high])))) size_of = 1.0_dp
        page%height = round_number(0.5_dp*letter_part*size_of)
        low = page%low - reach*page%height
        high = page%high + reach*page%height
        allocate (page%references(0), page%ordinates(0), page%ticks(0), page%words(0), at(0))
        at = multiples(round_number(step_part*size_of), low(1), high(1))
        do i = 1, size(at)
            call add_line(page, [at(i), low(2)], [at(i), high(2)])
            call add_words(page%ordinates, [at(i), low(2) - beside*page%height], &
                words_side%middle, ordinate(u_name, at(i)))
        end do
        at = multiples(round_number(step_part*size_of), low(2), high(2))
        do i = 1, size(at)
            call add_line(page, [low(1), at(i)], [high(1), at(i)])
            call add_words(page%ordinates, [low(1) - beside*page%height, at(i)], &
                words_side%right, ordinate(v_name, at(i)))
        end do
    end subroutine add_references

    !> Adds a reference line.
    pure subroutine add_line(page, from, to)
        type(page_type), intent(inout) :: page  !! gets it
        real(dp), intent(in) :: from(2)         !! one end
        real(dp), intent(in) :: to(2)           !! the other
        page%references = [page%references, stroke_type(from, to)]
    end subroutine add_line

    !> Adds words to a list.
    pure subroutine add_words(list, at, side, text)
        type(words_type), allocatable, intent(inout) :: list(:) !! gets them
        real(dp), intent(in) :: at(2)                           !! where they stand
        integer, intent(in) :: side                             !! one of `words_side%...`
        character(*), intent(in) :: text                        !! any bytes
        type(words_type), allocatable :: grown(:)

        allocate (grown(size(list) + 1))
        grown(:size(list)) = list
        grown(size(grown))%at = at
        grown(size(grown))%side = side
        grown(size(grown))%text = text
        call move_alloc(grown, list)
    end subroutine add_words

    !> The ordinate of a reference line; where butt lines are, zero is the centre line.
    pure function ordinate(name, at) result(text)
        character(*), intent(in) :: name    !! of the axis
        real(dp), intent(in) :: at          !! along it
        character(:), allocatable :: text
        text = name//' '//shortest(at)
        if (is_zero(at) .and. index('/'//name//'/', '/BL/') > 0) text = 'CL '//text
    end function ordinate

    !> The least of the numbers 1, 2, 5, 10, 20 ... and of their tenths, hundredths ... that is not
    !> below another.
    pure real(dp) function round_number(value) result(number)
        real(dp), intent(in) :: value   !! above zero
        real(dp), parameter :: figures(4) = [1.0_dp, 2.0_dp, 5.0_dp, 10.0_dp]
        integer :: power, i

        power = floor(log10(value))
        do i = 1, size(figures)
            number = figures(i)*10.0_dp**max(power, 0)/10.0_dp**max(-power, 0)
            if (number >= value) return
        end do
    end function round_number

    !> The multiples of a round number within limits. A step below 1 is one over a whole number, or
    !> such a number over another, by which they are divided, so that a third tenth is .3.
    pure function multiples(step, low, high) result(at)
        real(dp), intent(in) :: step    !! a round number
        real(dp), intent(in) :: low     !! lower limit
        real(dp), intent(in) :: high    !! upper limit
        real(dp), allocatable :: at(:)
        real(dp) :: first, scale
        integer :: i, count

        scale = 1.0_dp
        if (step < 1.0_dp) scale = 10.0_dp**(-floor(log10(step)))
        first = ceiling_of(low/step)
        count = max(0, 1 + int(ceiling_of(high/step) - first))
        allocate (at(count))
        do i = 1, count
            at(i) = (first + real(i - 1, dp))*anint(step*scale)/scale
        end do
        at = pack(at, at <= high)
    end function multiples

    !> The least whole number that is not below another, of any size.
    pure real(dp) function ceiling_of(value) result(whole)
        real(dp), intent(in) :: value   !! finite
        whole = aint(value)
        if (whole < value) whole = whole + 1.0_dp
    end function ceiling_of

end module export_dxf_page
